// What the command returns.
#pragma once

#include "quadloom/core.hpp"

namespace quadloom::app {

enum ExitCode {
  kDone = 0,
  kCheckFailed = 1,      // a mesh that the check refuses, whoever made it
  kUsage = 2,            // the command line
  kInput = 3,            // a file or what is in it
  kGuaranteeMissed = 4,  // a guarantee that was asked for is not met, or cannot be
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
