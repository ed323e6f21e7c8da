// Lines, words and numbers of a text in memory.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/line_blocks.hpp"
#include "io/source.hpp"

namespace quadloom::io {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// In lower case (ASCII letters).
std::string lower_case(std::string_view text);

/// Takes the first word (ended by blanks) off the front of `rest`; empty if there is none.
std::string_view take_word(std::string_view& rest);

/// The whole word as a number, rounded correctly; +1, inf and nan are numbers, a number too big for
/// a double is infinite and one too small is 0. Nothing if it is no number.
std::optional<double> to_number(std::string_view word);

/// The whole word as a non-negative or any integer.
template <class Integer>
std::optional<Integer> to_integer(std::string_view word) {
  Integer value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || word.empty()) return {};
  return value;
}

/// The text after a byte order mark, if there is one.
std::string_view without_mark(std::string_view text);

/// The lines of a text one by one, trimmed.
class Lines {
 public:
  explicit Lines(const Source& source) : Lines(source, {without_mark(source.text), 1}) {}
  /// Of a part of it.
  Lines(const Source& source, const LineBlock& block)
      : source_(source), rest_(block.text), number_(block.first_line - 1) {}

  /// Goes to the next line; false at the end.
  bool next();
  /// Goes to the next line that is neither empty nor a # comment.
  bool next_filled();
  /// next_filled, or an error that says what was expected.
  void require(std::string_view what);

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  std::size_t bytes_left() const { return rest_.size(); }
  LineBlock rest() const { return {rest_, number_ + 1}; }
  [[noreturn]] void fail(const std::string& what) const { fail_at(source_, number_, what); }

 private:
  const Source& source_;
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_;
};

/// The words of a text one by one, over line ends.
class Words {
 public:
  explicit Words(const Source& source, std::size_t first_line = 1)
      : source_(source), rest_(source.text), line_(first_line) {}

  /// The next word; empty at the end.
  std::string_view next();

  // The next word as a number, or an error that says what was expected.
  std::string_view require(std::string_view what);
  double finite(std::string_view what);
  double number(std::string_view what);
  std::uint64_t index(std::string_view what);

  std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& what) const { fail_at(source_, line_, what); }

 private:
  const Source& source_;
  std::string_view rest_;
  std::size_t line_;
};

/// A word as a finite number, or an error at the line.
double finite_number(const Source& source, std::size_t line, std::string_view word,
                     std::string_view what);

}  // namespace quadloom::io
