#include "core/point_text.hpp"

#include <array>
#include <charconv>

namespace quadloom {
namespace {

std::string number_text(double v) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), v).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::string point_text(Point p) {
  std::string out = "(";
  out += number_text(p.x);
  out += ", ";
  out += number_text(p.y);
  return out += ')';
}

}  // namespace quadloom
