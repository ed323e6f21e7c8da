// A file being written: under a temporary name beside its own until commit() renames it, so that no
// reader ever sees half of it and a failure leaves what was there before.
#pragma once

#include <concepts>
#include <cstdio>
#include <string>
#include <string_view>

namespace quadloom::io {

class Output {
 public:
  /// "-" is standard output; a target that exists and is no regular file (a pipe, /dev/null) is
  /// written directly. Throws Error kFile.
  explicit Output(const std::string& path);
  /// Removes the temporary file unless committed.
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  Output& operator<<(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= kFlushAt) flush();
    return *this;
  }
  Output& operator<<(char c) {
    buffer_.push_back(c);
    return *this;
  }
  /// The shortest decimal that reads back as the same double; -0.0 is written as 0.
  Output& operator<<(double value);
  template <std::integral Integer>
  Output& operator<<(Integer value) {
    return integer(static_cast<long long>(value));
  }

  /// Writes what is left and gives the file its name. Throws Error kFile.
  void commit();

 private:
  static constexpr std::size_t kFlushAt = std::size_t{1} << 18;

  Output& integer(long long value);
  void open();
  void flush();
  void remove_temporary();
  [[noreturn]] void fail(const char* what, int error);

  std::string path_;       // as given, for messages
  std::string target_;     // where it ends up; empty for standard output
  std::string temporary_;  // empty if the target is written directly
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

}  // namespace quadloom::io
