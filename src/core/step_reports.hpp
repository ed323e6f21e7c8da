// Reports of progress from a loop of many short steps.
#pragma once

#include <cstddef>
#include <string_view>

#include "quadloom/core.hpp"

namespace quadloom {

/// Reports at every so many steps how many of all are done, counting on from those done before. Throws
/// as report_progress.
class StepReports {
 public:
  static constexpr std::size_t kEvery = 4096;

  StepReports(const Progress& progress, std::string_view stage, std::size_t steps,
              std::size_t every = kEvery, std::size_t before = 0)
      : progress_(progress), stage_(stage), steps_(steps), every_(every), before_(before) {}

  void operator()() {
    if (done_++ % every_ != 0) return;
    const double share = static_cast<double>(before_ + done_ - 1) / static_cast<double>(steps_);
    report_progress(progress_, stage_, share < 1 ? share : 1);
  }

 private:
  const Progress& progress_;
  std::string_view stage_;
  std::size_t steps_, every_, before_;
  std::size_t done_ = 0;
};

}  // namespace quadloom
