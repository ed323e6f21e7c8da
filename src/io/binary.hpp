// Numbers in binary data.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace quadloom::io {

enum class NumberType : std::uint8_t { kI8, kU8, kI16, kU16, kI32, kU32, kI64, kU64, kF32, kF64 };

inline std::size_t size_of(NumberType type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

template <class T>
T load(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if (swap) std::ranges::reverse(copy);
  return std::bit_cast<T>(copy);
}

/// The number at `bytes` as a double (an integer above 2^53 is rounded). `swap`: its bytes are in
/// the other order than this machine's.
inline double load_number(const char* bytes, NumberType type, bool swap) {
  switch (type) {
    case NumberType::kI8:
      return load<std::int8_t>(bytes, swap);
    case NumberType::kU8:
      return load<std::uint8_t>(bytes, swap);
    case NumberType::kI16:
      return load<std::int16_t>(bytes, swap);
    case NumberType::kU16:
      return load<std::uint16_t>(bytes, swap);
    case NumberType::kI32:
      return load<std::int32_t>(bytes, swap);
    case NumberType::kU32:
      return load<std::uint32_t>(bytes, swap);
    case NumberType::kI64:
      return static_cast<double>(load<std::int64_t>(bytes, swap));
    case NumberType::kU64:
      return static_cast<double>(load<std::uint64_t>(bytes, swap));
    case NumberType::kF32:
      return load<float>(bytes, swap);
    case NumberType::kF64:
      return load<double>(bytes, swap);
  }
  return 0;
}

}  // namespace quadloom::io
