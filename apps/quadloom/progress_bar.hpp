// A bar on the terminal for work of more than a second.
#pragma once

#include <chrono>
#include <string_view>

#include "quadloom/core.hpp"

namespace quadloom::app {

/// Draws on standard error if that is a terminal; wipes itself at the end.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// A callback that lives no longer than the bar.
  Progress callback();

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::string_view stage, double done);

  bool terminal_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace quadloom::app
