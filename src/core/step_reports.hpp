// Reports of progress from a loop of many short steps.
#pragma once

#include <cstddef>
#include <string_view>

#include "quadloom/core.hpp"

namespace quadloom {

/// Reports at every so many steps, 4,096 unless told otherwise, how many of all are done. Throws as
/// report_progress.
class StepReports {
 public:
  StepReports(const Progress& progress, std::string_view stage, std::size_t steps,
              std::size_t every = 4096)
      : progress_(progress), stage_(stage), steps_(steps), every_(every) {}

  void operator()() {
    if (done_++ % every_ != 0) return;
    const double share = static_cast<double>(done_ - 1) / static_cast<double>(steps_);
    report_progress(progress_, stage_, share < 1 ? share : 1);
  }

 private:
  const Progress& progress_;
  std::string_view stage_;
  std::size_t steps_, every_;
  std::size_t done_ = 0;
};

}  // namespace quadloom
