#include "io/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

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
  buffer_.reserve(kFlushAt + 4096);
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
  errno = 0;
  const std::size_t written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_);
  if (written != buffer_.size()) fail(nullptr, errno);
  buffer_.clear();
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

Output& Output::operator<<(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0).ptr;
  return *this << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

Output& Output::integer(long long value) {
  std::array<char, 24> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return *this << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

}  // namespace quadloom::io
