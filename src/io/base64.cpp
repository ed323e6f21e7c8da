#include "io/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace quadloom::io {
namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kBlank = 64, kPadding = 65, kWrong = 66;

constexpr std::array<std::uint8_t, 256> make_values() {
  std::array<std::uint8_t, 256> out{};
  out.fill(kWrong);
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    out[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
  }
  for (const char c : {' ', '\t', '\r', '\n'}) out[static_cast<unsigned char>(c)] = kBlank;
  out[static_cast<unsigned char>('=')] = kPadding;
  return out;
}
constexpr auto kValues = make_values();

}  // namespace

void append_base64(std::string_view bytes, TextBuffer& out) {
  const std::size_t size = (bytes.size() + 2) / 3 * 4;
  char* to = out.room(size);
  const auto byte = [&](std::size_t i) {
    return std::uint32_t{static_cast<unsigned char>(bytes[i])};
  };
  const auto put = [&](std::uint32_t group) {
    for (int shift = 18; shift >= 0; shift -= 6) *to++ = kLetters[group >> shift & 63U];
  };
  std::size_t i = 0;
  for (; i + 3 <= bytes.size(); i += 3) put(byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2));
  const std::size_t rest = bytes.size() - i;
  if (rest > 0) {
    put(byte(i) << 16 | (rest == 2 ? byte(i + 1) << 8 : 0));
    std::fill_n(to - (3 - rest), 3 - rest, '=');
  }
  out.added(size);
}

std::string to_base64(std::string_view bytes) {
  TextBuffer out;
  append_base64(bytes, out);
  return std::string(out.view());
}

bool from_base64(std::string_view& text, std::size_t enough, std::string& out) {
  std::uint32_t group = 0;
  int letters = 0, padding = 0;
  std::size_t read = 0;
  while (read < text.size() && (out.size() < enough || letters > 0)) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(text[read++])];
    if (value == kBlank) continue;
    if (value == kWrong || (padding > 0 && value != kPadding)) return false;
    if (value == kPadding && (letters < 2 || ++padding + letters > 4)) return false;
    if (value != kPadding) {
      group = group << 6 | value;
      ++letters;
    }
    if (letters + padding < 4) continue;
    group <<= 6 * padding;
    for (int j = 0; j < 3 - padding; ++j) out += static_cast<char>(group >> (16 - 8 * j) & 255U);
    group = 0;
    letters = padding = 0;
  }
  text.remove_prefix(read);
  return letters == 0;
}

bool from_base64(std::string_view text, std::string& out) {
  out.clear();
  out.reserve(text.size() / 4 * 3 + 3);
  return from_base64(text, std::string_view::npos, out);
}

}  // namespace quadloom::io
