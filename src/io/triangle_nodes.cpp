#include "io/triangle_nodes.hpp"

#include <fmt/format.h>

namespace quadloom::io {
namespace {

constexpr std::uint64_t kMostAttributes = 1000;

}  // namespace

bool TriangleLines::next() {
  while (lines_.next_filled()) {
    rest_ = lines_.line().substr(0, lines_.line().find('#'));
    if (has_word()) return true;
  }
  return false;
}

void TriangleLines::require(std::string_view what) {
  if (!next()) fail(fmt::format("the file ends here, expected {}", what));
}

bool TriangleLines::has_word() const { return !trimmed(rest_).empty(); }

std::string_view TriangleLines::word(std::string_view what) {
  const auto out = take_word(rest_);
  if (out.empty()) fail(fmt::format("{} is missing", what));
  return out;
}

double TriangleLines::finite(std::string_view what) {
  return finite_number(source_, number(), word(what), what);
}

std::uint64_t TriangleLines::count(std::string_view what) {
  const auto text = word(what);
  const auto value = to_integer<std::uint64_t>(text);
  if (!value) fail(fmt::format("{} is not a count, expected {}", in_quotes(text), what));
  return *value;
}

std::int64_t TriangleLines::integer(std::string_view what) {
  const auto text = word(what);
  const auto value = to_integer<std::int64_t>(text);
  if (!value) fail(fmt::format("{} is not a whole number, expected {}", in_quotes(text), what));
  return *value;
}

//    4 2 1 1              points, dimensions, attributes, markers (0 or 1)
//    1  0.5 0.5  7.25  1  number, x, y, attributes, marker
TriangleNodes read_triangle_nodes(TriangleLines& lines) {
  lines.require("the number of points");
  const auto points = lines.count("the number of points");
  if (points >= kMaxPoints) lines.fail(fmt::format("{} points are too many", points));
  if (lines.has_word() && lines.count("the dimension") != 2) lines.fail("the dimension is not 2");
  const auto attributes = lines.has_word() ? lines.count("the number of attributes") : 0;
  const auto markers = lines.has_word() ? lines.count("the number of markers") : 0;
  if (attributes > kMostAttributes || markers > 1) {
    lines.fail(
        fmt::format("{} attributes and {} markers a point are too many", attributes, markers));
  }
  TriangleNodes out;
  for (std::uint64_t a = 0; a < attributes; ++a) {
    out.data.push_back({fmt::format("attribute{}", a), {}});
  }
  if (markers == 1) out.data.push_back({"marker", {}});
  for (std::uint64_t i = 0; i < points; ++i) {
    lines.require(fmt::format("point {} of {}", i + 1, points));
    const auto number = lines.integer("the number of the point");
    if (i == 0) out.first = number;
    if ((out.first != 0 && out.first != 1) || number != out.first + static_cast<std::int64_t>(i)) {
      lines.fail(fmt::format("point number {}: points are numbered in order from 0 or 1", number));
    }
    const double x = lines.finite("x"), y = lines.finite("y");
    out.points.push_back({x, y});
    for (Attribute& data : out.data) data.values.push_back(lines.finite(data.name));
  }
  return out;
}

VertexId read_triangle_point(TriangleLines& lines, std::int64_t first, std::size_t points) {
  const auto number = lines.integer("a point's number");
  const auto count = static_cast<std::int64_t>(points);
  if (number >= first && number - first < count) return static_cast<VertexId>(number - first);
  throw Error(ErrorCode::kIndexOutOfRange,
              fmt::format("{}, line {}: there is no point {}, the points are {} to {}",
                          lines.source().name, lines.number(), number, first, first + count - 1),
              {lines.number()});
}

//    3 1            segments, markers (0 or 1)
//    1  1 2  5      number, two points, marker
TriangleSegments read_triangle_segments(TriangleLines& lines, std::int64_t first,
                                        std::size_t points) {
  lines.require("the number of segments");
  const auto segments = lines.count("the number of segments");
  const auto markers = lines.has_word() ? lines.count("the number of markers") : 0;
  if (markers > 1) lines.fail(fmt::format("{} markers a segment are too many", markers));
  TriangleSegments out;
  out.has_markers = markers == 1;
  for (std::uint64_t i = 0; i < segments; ++i) {
    lines.require(fmt::format("segment {} of {}", i + 1, segments));
    lines.integer("the number of the segment");
    const VertexId from = read_triangle_point(lines, first, points);
    const VertexId to = read_triangle_point(lines, first, points);
    out.segments.push_back({from, to});
    // Triangle takes a missing marker for 0.
    if (out.has_markers) out.marker.push_back(lines.has_word() ? lines.finite("the marker") : 0);
  }
  return out;
}

}  // namespace quadloom::io
