#include "progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace quadloom::app {
namespace {

constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kBetween = std::chrono::milliseconds(100);
constexpr int kCells = 30;

bool stderr_is_terminal() {
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(2) != 0;
#endif
}

}  // namespace

ProgressBar::ProgressBar() : terminal_(stderr_is_terminal()), next_(Clock::now() + kPatience) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

Progress ProgressBar::callback() {
  if (!terminal_) return {};
  return [this](std::string_view stage, double done) {
    if (Clock::now() >= next_) show(stage, done);
    return true;
  };
}

void ProgressBar::show(std::string_view stage, double done) {
  const int full = std::clamp(static_cast<int>(done * kCells), 0, kCells);
  fmt::print(stderr, "\r\033[K[{:=<{}}{: <{}}] {:3.0f}% {}", "", full, "", kCells - full,
             100 * done, stage);
  std::fflush(stderr);
  shown_ = true;
  next_ = Clock::now() + kBetween;
}

}  // namespace quadloom::app
