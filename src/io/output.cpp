#include "io/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "quadloom/core.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {
namespace {

namespace fs = std::filesystem;

/// A name beside the target that no other writer of this machine uses.
std::string temporary_name(const std::string& target) {
  static std::atomic<unsigned> count = 0;
  return fmt::format("{}.{}-{}.part", target, ::getpid(), ++count);
}

/// A link is followed, so that it stays a link to the new file.
std::string followed(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const auto real = fs::weakly_canonical(path, error);
  return error ? path : real.string();
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
  if (path == "-") {
    file_ = stdout;
  } else {
    open();
  }
}

void Output::open() {
  target_ = followed(path_);
  std::error_code error;
  const auto kind = fs::status(target_, error).type();
  if (kind == fs::file_type::directory) fail("it is a folder", 0);
  const bool direct = kind != fs::file_type::regular && kind != fs::file_type::not_found &&
                      kind != fs::file_type::none;
  if (!direct) temporary_ = temporary_name(target_);
  file_ = std::fopen((direct ? target_ : temporary_).c_str(), direct ? "wb" : "wbx");
  if (file_ == nullptr) {
    const int why = errno;
    temporary_.clear();
    fail(nullptr, why);
  }
}

Output::~Output() { remove_temporary(); }

void Output::remove_temporary() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  file_ = nullptr;
  if (!temporary_.empty()) std::remove(temporary_.c_str());
  temporary_.clear();
}

void Output::fail(const char* what, int error) {
  remove_temporary();
  throw Error(ErrorCode::kFile,
              fmt::format("cannot write {}: {}", path_ == "-" ? "standard output" : path_,
                          what != nullptr ? what : std::strerror(error)));
}

void Output::flush() {
  write(buffer_.view());
  buffer_.clear();
}

void Output::write(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(nullptr, errno);
}

void Output::commit() {
  flush();
  errno = 0;
  if (std::fflush(file_) != 0) fail(nullptr, errno);
  if (file_ == stdout) return;
  std::FILE* const file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) fail(nullptr, errno);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(nullptr, errno);
  temporary_.clear();
}

// Rounds of blocks, so that not the whole file is in memory.
void Output::blocks(std::size_t count, std::size_t block, const WriteBlock& write_block) {
  constexpr std::size_t kBlocks = 64;
  std::vector<TextBuffer> parts(std::min(kBlocks, count / block + 1));
  for (std::size_t begin = 0; begin < count; begin += block * kBlocks) {
    const std::size_t of_round = std::min(kBlocks, (count - begin - 1) / block + 1);
    parallel_tasks_in_order(of_round, [&](std::size_t i) {
      const std::size_t first = begin + i * block;
      parts[i].clear();
      write_block(parts[i], first, std::min(count, first + block));
    });
    flush();
    for (std::size_t i = 0; i < of_round; ++i) write(parts[i].view());
  }
}

}  // namespace quadloom::io
