// What the programs that bench/compare runs have in common. Each is called as
//
//   PROGRAM TASK INPUT [RESULT]
//
// INPUT and RESULT are names without endings: INPUT.points, RESULT.quads and so on are files of doubles as they are in
// memory (raw_meshes.hpp says which there are). The program reads its input, runs the task, writes what came out if RESULT
// is given, and prints one line of JSON: seconds, bytes, and figures of its own.
#pragma once

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

inline std::vector<double> read_doubles(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<double> values(static_cast<std::size_t>(file.tellg()) / sizeof(double));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(double)));
  return values;
}

/// The file is there when it is whole.
template <class Values>
void write_doubles(const std::string& path, const Values& values) {
  const std::vector<double> doubles(values.begin(), values.end());
  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  file.write(reinterpret_cast<const char*>(doubles.data()),
             static_cast<std::streamsize>(doubles.size() * sizeof(double)));
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0)
    throw std::runtime_error("cannot write " + path);
}

/// One line of JSON.
class Report {
 public:
  template <class Value>
  Report& add(const std::string& name, Value value) {
    std::ostringstream text;
    text.precision(9);
    text << std::boolalpha << value;
    return add_text(name, text.str());
  }
  Report& add_words(const std::string& name, const std::string& words) {
    return add_text(name, '"' + words + '"');
  }
  void print() const { std::cout << "{" << line_ << "}" << std::endl; }

 private:
  Report& add_text(const std::string& name, const std::string& value) {
    line_ += (line_.empty() ? "\"" : ", \"") + name + "\": " + value;
    return *this;
  }
  std::string line_;
};

// ---- Memory: what the process has in the machine's memory, and the most that it had, in bytes. ----

inline double status_of_process(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == name + ":" && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

/// From here on the most is what it has now; memory that was freed goes back to the system first.
inline double forget_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  return status_of_process("VmRSS");
}

// ---- The measurement. ----

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Writes to a gigabyte and gives it back: a virtual machine that has been idle asks its host for memory, which took up to
/// half of the time of a task, whichever came first.
inline void have_memory_at_hand() {
  constexpr std::size_t kBytes = std::size_t{1} << 30, kPage = 4096;
  void* const memory =
      mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return;
  madvise(memory, kBytes, MADV_HUGEPAGE);
  for (std::size_t i = 0; i < kBytes; i += kPage) static_cast<volatile char*>(memory)[i] = 1;
  munmap(memory, kBytes);
}

/// Runs the task, which gives its result: seconds, and bytes above what the process had before. Short tasks are run
/// again for a fifth of a second, and the median counts. Taking a result down is not timed.
template <class Task>
auto measure(Report& report, Task task) {
  using Clock = std::chrono::steady_clock;
  const auto timed = [&](std::vector<double>& seconds) {
    const Clock::time_point start = Clock::now();
    auto result = task();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    return result;
  };
  have_memory_at_hand();
  const double before = forget_peak();
  std::vector<double> seconds;
  auto result = timed(seconds);
  const double bytes = std::max(0.0, status_of_process("VmHWM") - before);
  for (double sum = seconds[0]; sum < 0.2; sum += seconds.back()) timed(seconds);
  report.add("seconds", median(seconds)).add("bytes", static_cast<long long>(bytes));
  return result;
}

/// What a program was called with; `result` is empty if nothing is to be written.
struct Call {
  std::string task, input, result;
};

/// Runs a program: an error is one line on stderr and exit code 1.
template <class Run>
int run_program(int argc, char** argv, Run run) {
  if (argc < 3) {
    std::cerr << "PROGRAM TASK INPUT [RESULT]\n";
    return 2;
  }
  try {
    Report report;
    run(Call{argv[1], argv[2], argc > 3 ? argv[3] : ""}, report);
    report.print();
    return 0;
  } catch (const std::bad_alloc&) {
    std::cerr << "out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
  }
  return 1;
}

[[noreturn]] inline void unknown_task(const Call& call) {
  throw std::runtime_error("no task is called " + call.task);
}

}  // namespace bench
