// Text being put together, as the writers see it: a part of a file, or a file (Output).
#pragma once

#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

namespace quadloom::io {

/// Grows as needed. Numbers are printed in place.
class TextBuffer {
 public:
  TextBuffer& operator<<(std::string_view text) {
    if (text.empty()) return *this;
    std::memcpy(room(text.size()), text.data(), text.size());
    size_ += text.size();
    return *this;
  }
  TextBuffer& operator<<(char c) {
    *room(1) = c;
    ++size_;
    return *this;
  }
  /// The shortest decimal that reads back as the same double; -0.0 is written as 0.
  TextBuffer& operator<<(double value) { return number(value + 0.0); }
  template <std::integral Integer>
  TextBuffer& operator<<(Integer value) {
    return number(static_cast<long long>(value));
  }

  /// Room for so many bytes at the end; what is written there counts after added().
  char* room(std::size_t bytes) {
    if (capacity_ - size_ < bytes) grow(bytes);
    return text_.get() + size_;
  }
  void added(std::size_t bytes) { size_ += bytes; }

  std::string_view view() const { return {text_.get(), size_}; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

 private:
  static constexpr std::size_t kLongestNumber = 32;

  template <class Number>
  TextBuffer& number(Number value) {
    char* const to = room(kLongestNumber);
    size_ += static_cast<std::size_t>(std::to_chars(to, to + kLongestNumber, value).ptr - to);
    return *this;
  }

  void grow(std::size_t bytes) {
    const std::size_t capacity = std::max({size_ + bytes, 2 * capacity_, std::size_t{4096}});
    auto text = std::make_unique_for_overwrite<char[]>(capacity);
    if (size_ > 0) std::memcpy(text.get(), text_.get(), size_);
    text_ = std::move(text);
    capacity_ = capacity;
  }

  std::unique_ptr<char[]> text_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace quadloom::io
