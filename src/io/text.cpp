#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadloom::io {
namespace {

/// A decimal number that is no double: whether it is too big (else it is too small). True if its
/// first digit that is not 0 stands before the decimal point after the exponent is applied.
bool too_big(std::string_view word) {
  if (!word.empty() && word[0] == '-') word.remove_prefix(1);
  const auto e = std::min(word.find_first_of("eE"), word.size());
  const std::string_view digits = word.substr(0, e);
  const auto point = std::min(digits.find('.'), digits.size());
  const auto first = std::min(digits.find_first_of("123456789"), digits.size());
  const auto magnitude = static_cast<long long>(point) - static_cast<long long>(first);
  if (e == word.size()) return magnitude > 0;
  std::string_view exponent = word.substr(e + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  const auto value = to_integer<long long>(exponent);
  if (!value) return !exponent.starts_with('-');  // an exponent of twenty digits
  return *value > -magnitude;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

std::string_view take_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const auto word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

std::optional<double> to_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return {};
  if (error == std::errc{}) return value;
  if (error != std::errc::result_out_of_range) return {};
  if (!too_big(word)) return 0.0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return word[0] == '-' ? -infinity : infinity;
}

std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
}

bool Lines::next() {
  if (rest_.empty()) return false;
  const auto end = std::min(rest_.find('\n'), rest_.size());
  line_ = trimmed(rest_.substr(0, end));
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

bool Lines::next_filled() {
  while (next()) {
    if (!line_.empty() && line_[0] != '#') return true;
  }
  return false;
}

void Lines::require(std::string_view what) {
  if (!next_filled()) fail(fmt::format("the file ends here, expected {}", what));
}

std::string_view Words::next() {
  std::size_t begin = 0;
  for (; begin < rest_.size(); ++begin) {
    if (rest_[begin] == '\n') {
      ++line_;
    } else if (!is_blank(rest_[begin])) {
      break;
    }
  }
  std::size_t end = begin;
  while (end < rest_.size() && !is_blank(rest_[end]) && rest_[end] != '\n') ++end;
  const auto word = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return word;
}

std::string_view Words::require(std::string_view what) {
  const auto word = next();
  if (word.empty()) fail(fmt::format("the file ends here, expected {}", what));
  return word;
}

double Words::finite(std::string_view what) {
  const auto word = require(what);  // first: it moves on to the word's line
  return finite_number(source_, line_, word, what);
}

double Words::number(std::string_view what) {
  const auto word = require(what);
  const auto value = to_number(word);
  if (!value) fail(fmt::format("{} is not a number, expected {}", in_quotes(word), what));
  return *value;
}

std::uint64_t Words::index(std::string_view what) {
  const auto word = require(what);
  const auto value = to_integer<std::uint64_t>(word);
  if (!value) fail(fmt::format("{} is not a count or index, expected {}", in_quotes(word), what));
  return *value;
}

double finite_number(const Source& source, std::size_t line, std::string_view word,
                     std::string_view what) {
  const auto value = to_number(word);
  if (!value) {
    fail_at(source, line,
            word.empty() ? fmt::format("{} is missing", what)
                         : fmt::format("{} is not a number, expected {}", in_quotes(word), what));
  }
  if (!std::isfinite(*value)) {
    fail_at(source, line,
            fmt::format("{} is not a finite number, expected {}", in_quotes(word), what),
            ErrorCode::kNotFinite);
  }
  return *value + 0.0;
}

}  // namespace quadloom::io
