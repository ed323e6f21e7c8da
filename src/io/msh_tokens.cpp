#include "io/msh_tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/binary.hpp"
#include "io/text.hpp"

namespace quadloom::io {

MshTokens::MshTokens(const Source& source) : source_(source), text_(without_mark(source.text)) {}

void MshTokens::set_binary(bool swap, std::size_t size_bytes) {
  binary_ = true;
  swap_ = swap;
  size_bytes_ = size_bytes;
}

void MshTokens::fail(const std::string& what, ErrorCode code) const {
  if (!binary_) fail_at(source_, line_, what, code);
  fail_in(source_, fmt::format("byte {}: {}", at_, what), code);
}

// ---- Text. ----

void MshTokens::skip_blanks() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\n') {
      ++line_;
    } else if (!is_blank(text_[at_])) {
      return;
    }
  }
}

std::string_view MshTokens::word() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view MshTokens::require(std::string_view what) {
  const auto out = word();
  if (out.empty()) fail(fmt::format("the file ends here, expected {}", what));
  return out;
}

std::string MshTokens::quoted(std::string_view what) {
  skip_blanks();
  if (at_ == text_.size() || text_[at_] != '"') return std::string(require(what));
  const auto end = text_.find_first_of("\"\n", at_ + 1);
  if (end == std::string_view::npos || text_[end] != '"') {
    fail(fmt::format("{} has no second quote", what));
  }
  std::string out(text_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  return out;
}

std::uint64_t MshTokens::text_count(std::string_view what) {
  const auto text = require(what);
  const auto value = to_integer<std::uint64_t>(text);
  if (!value) fail(fmt::format("{} is not a count or index, expected {}", in_quotes(text), what));
  return *value;
}

double MshTokens::text_number(std::string_view what) {
  const auto text = require(what);
  const auto value = to_number(text);
  if (!value) fail(fmt::format("{} is not a number, expected {}", in_quotes(text), what));
  return *value;
}

void MshTokens::expect(std::string_view expected) {
  const auto found = require(expected);
  if (found != expected) fail(fmt::format("{}, expected {}", in_quotes(found), expected));
}

void MshTokens::end_text() {
  if (!binary_) return;
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  if (at_ == text_.size() || text_[at_] != '\n') fail("expected the end of a line of text");
  ++at_;
}

bool MshTokens::swapped_one() {
  const char* const bytes = take(4, "the number 1 that tells the byte order");
  if (load<std::int32_t>(bytes, false) == 1) return false;
  if (load<std::int32_t>(bytes, true) == 1) return true;
  fail("the number that tells the byte order is not 1");
}

void MshTokens::skip_section(std::string_view name) {
  const std::string end = "$End" + std::string(name.substr(1));
  if (!binary_) {
    while (require(end) != end) {
    }
    return;
  }
  const auto found = text_.find("\n" + end, at_);
  if (found == std::string_view::npos) fail(fmt::format("the file ends here, expected {}", end));
  at_ = found + 1 + end.size();
}

// ---- Numbers in the file's encoding. ----

const char* MshTokens::take(std::size_t bytes, std::string_view what) {
  if (text_.size() - at_ < bytes) {
    at_ = text_.size();
    fail(fmt::format("the file ends here, expected {}", what));
  }
  const char* const out = text_.data() + at_;
  at_ += bytes;
  return out;
}

std::uint64_t MshTokens::size(std::string_view what) {
  if (!binary_) return text_count(what);
  const char* const bytes = take(size_bytes_, what);
  return size_bytes_ == 8 ? load<std::uint64_t>(bytes, swap_) : load<std::uint32_t>(bytes, swap_);
}

std::int64_t MshTokens::integer(std::string_view what) {
  if (binary_) return load<std::int32_t>(take(4, what), swap_);
  const auto text = require(what);
  const auto value = to_integer<std::int64_t>(text);
  if (!value) fail(fmt::format("{} is not a whole number, expected {}", in_quotes(text), what));
  return *value;
}

std::uint64_t MshTokens::index(std::string_view what) {
  if (!binary_) return text_count(what);
  const std::int64_t value = integer(what);
  if (value < 0) fail(fmt::format("{} is not a count or index, expected {}", value, what));
  return static_cast<std::uint64_t>(value);
}

double MshTokens::number(std::string_view what) {
  return binary_ ? load<double>(take(8, what), swap_) : text_number(what);
}

double MshTokens::finite(std::string_view what) {
  if (!binary_) {
    const auto text = require(what);
    return finite_number(source_, line_, text, what);
  }
  const double value = number(what);
  if (!std::isfinite(value)) fail(fmt::format("{} is not finite", what), ErrorCode::kNotFinite);
  return value + 0.0;
}

}  // namespace quadloom::io
