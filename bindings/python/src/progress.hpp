// Long work: without the GIL, with reports to Python and an ear for Ctrl-C.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <optional>
#include <utility>

#include "quadloom/core.hpp"

namespace quadloom::python {

/// The argument `progress`: a callable, or None.
class ProgressLike : public nanobind::object {
  NB_OBJECT_DEFAULT(ProgressLike, nanobind::object,
                    "collections.abc.Callable[[str, float], bool | None]", accepts)
 private:
  static bool accepts(PyObject* given) { return given == Py_None || PyCallable_Check(given); }
};

/// Takes the library's reports during work without the GIL. Calls the callable with each of them, looks
/// for signals now and then, and stops the work if the callable returned False or anything was raised.
class Listener {
 public:
  explicit Listener(ProgressLike callable) : callable_(std::move(callable)) {}

  Progress progress();

  /// After work that stopped: throws what was raised meanwhile, if anything.
  void rethrow();

 private:
  using Clock = std::chrono::steady_clock;
  bool hear(std::string_view stage, double done);

  ProgressLike callable_;
  Clock::time_point next_look_ = Clock::now();
  std::optional<nanobind::python_error> raised_;
};

/// Does work(progress) without the GIL.
template <typename Work>
auto run(const ProgressLike& callable, Work work) {
  Listener listener(callable);
  try {
    nanobind::gil_scoped_release release;
    return work(listener.progress());
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kCancelled) listener.rethrow();
    throw;
  }
}

/// Does work(options) without the GIL, `options.progress` being what hears of it.
template <typename Options, typename Work>
auto run(const ProgressLike& callable, Options options, Work work) {
  return run(callable, [&](const Progress& p) {
    options.progress = p;
    return work(std::as_const(options));
  });
}

/// Does work() without the GIL.
template <typename Work>
auto without_gil(Work work) {
  nanobind::gil_scoped_release release;
  return work();
}

}  // namespace quadloom::python
