// What the command returns.
#pragma once

#include "quadloom/core.hpp"

namespace quadloom::app {

enum ExitCode {
  kDone = 0,
  kCheckFailed = 1,      // a mesh that the check refuses, whoever made it
  kUsage = 2,            // the command line
  kInput = 3,            // a file or what is in it
  kGuaranteeMissed = 4,  // what was asked for does not exist for this input
};

inline ExitCode exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadOption:
      return kUsage;
    case ErrorCode::kGuarantee:
      return kGuaranteeMissed;
    case ErrorCode::kCancelled:
      return kCheckFailed;
    default:
      return kInput;
  }
}

}  // namespace quadloom::app
