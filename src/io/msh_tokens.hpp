// The words and numbers of Gmsh's .msh, whose sections are text, or binary between lines of text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/source.hpp"

namespace quadloom::io {

class MshTokens {
 public:
  explicit MshTokens(const Source& source);

  /// Numbers are binary from here on; `swap`: in the other byte order than this machine's, sizes in
  /// `size_bytes` (4 or 8) bytes.
  void set_binary(bool swap, std::size_t size_bytes);
  bool binary() const { return binary_; }

  // Text in either encoding; `what` says what was expected.
  std::string_view word();  // empty at the end
  std::string_view require(std::string_view what);
  std::string quoted(std::string_view what);  // "a name", or one word
  std::uint64_t text_count(std::string_view what);
  double text_number(std::string_view what);
  void expect(std::string_view word);
  /// In a binary file the line of text ends here and numbers begin; nothing in a text.
  void end_text();
  /// The first byte of a number that tells the byte order: true if it is swapped.
  bool swapped_one();
  /// From after $Name to after $EndName.
  void skip_section(std::string_view name);

  // Numbers in the file's encoding.
  std::uint64_t size(std::string_view what);    // 32 or 64 bits
  std::int64_t integer(std::string_view what);  // 32 bits
  std::uint64_t index(std::string_view what);   // 32 bits, not negative
  double number(std::string_view what);
  double finite(std::string_view what);

  /// 0 in a binary file.
  std::size_t line() const { return binary_ ? 0 : line_; }
  /// Names the line, or the byte in a binary file.
  [[noreturn]] void fail(const std::string& what, ErrorCode code = ErrorCode::kParse) const;

 private:
  const char* take(std::size_t bytes, std::string_view what);
  void skip_blanks();

  const Source& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool binary_ = false;
  bool swap_ = false;
  std::size_t size_bytes_ = 8;
};

}  // namespace quadloom::io
