// A file being written: under a temporary name beside its own until commit() renames it, so that no
// reader ever sees half of it and a failure leaves what was there before.
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

#include "io/text_buffer.hpp"

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

  /// As TextBuffer.
  template <class Value>
  Output& operator<<(const Value& value) {
    buffer_ << value;
    if (buffer_.size() >= kFlushAt) flush();
    return *this;
  }

  /// Writes what write(part, i) puts together for each i below `count`, in order; blocks of so many are
  /// put together on several threads. If some throw, the exception of the first comes through.
  template <class Write>
  void each(std::size_t count, const Write& write, std::size_t block = 4096) {
    blocks(count, block, [&](TextBuffer& part, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) write(part, i);
    });
  }

  /// Writes what is left and gives the file its name. Throws Error kFile.
  void commit();

 private:
  static constexpr std::size_t kFlushAt = std::size_t{1} << 18;

  using WriteBlock = std::function<void(TextBuffer& part, std::size_t first, std::size_t last)>;

  void blocks(std::size_t count, std::size_t block, const WriteBlock& write);
  void open();
  void flush();
  void write(std::string_view text);
  void remove_temporary();
  [[noreturn]] void fail(const char* what, int error);

  std::string path_;       // as given, for messages
  std::string target_;     // where it ends up; empty for standard output
  std::string temporary_;  // empty if the target is written directly
  std::FILE* file_ = nullptr;
  TextBuffer buffer_;
};

}  // namespace quadloom::io
