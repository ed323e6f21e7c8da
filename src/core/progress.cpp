#include "quadloom/core.hpp"

namespace quadloom {

void report_progress(const Progress& progress, std::string_view stage, double done) {
  if (progress && !progress(stage, done)) {
    throw Error(ErrorCode::kCancelled, "stopped during " + std::string(stage));
  }
}

}  // namespace quadloom
