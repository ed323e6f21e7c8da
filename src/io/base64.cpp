#include "io/base64.hpp"

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

std::string to_base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      out += i + j > bytes.size() ? '=' : kLetters[group >> (18 - 6 * j) & 63U];
    }
  }
  return out;
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
