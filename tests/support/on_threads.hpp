// Work on a given number of threads, on more than there are cores, too.
#pragma once

#include <cstddef>

#ifdef QUADLOOM_THREADS
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace quadloom {

template <typename Work>
auto on_threads(int threads, const Work& work) {
#ifdef QUADLOOM_THREADS
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  return tbb::task_arena(threads).execute(work);
#else
  return work();
#endif
}

}  // namespace quadloom
