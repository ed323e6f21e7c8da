#include "progress.hpp"

#include <string_view>

namespace nb = nanobind;

namespace quadloom::python {
namespace {

constexpr auto kBetweenLooks = std::chrono::milliseconds(20);

}  // namespace

Progress Listener::progress() {
  return [this](std::string_view stage, double done) { return hear(stage, done); };
}

bool Listener::hear(std::string_view stage, double done) {
  const bool has_callable = callable_.is_valid() && !callable_.is_none();
  const Clock::time_point now = Clock::now();
  if (!has_callable && now < next_look_) return true;
  next_look_ = now + kBetweenLooks;
  nb::gil_scoped_acquire acquire;
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    return !has_callable || callable_(nb::str(stage.data(), stage.size()), done).ptr() != Py_False;
  } catch (nb::python_error& e) {
    raised_.emplace(std::move(e));
    return false;
  }
}

void Listener::rethrow() {
  if (raised_) throw nb::python_error(std::move(*raised_));
}

}  // namespace quadloom::python
