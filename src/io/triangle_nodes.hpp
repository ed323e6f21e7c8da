// What the formats of Triangle have in common: lines of words with # comments, the list of points
// that begins a .node and a .poly, the list of edges of a .poly and an .edge.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/text.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

/// The lines that hold something before a #, word by word.
class TriangleLines {
 public:
  explicit TriangleLines(const Source& source) : source_(source), lines_(source) {}

  bool next();
  /// The next line, or an error that says what was expected.
  void require(std::string_view what);
  bool has_word() const;

  // The next word of the line, or an error that says what was expected.
  double finite(std::string_view what);
  std::uint64_t count(std::string_view what);
  std::int64_t integer(std::string_view what);

  const Source& source() const { return source_; }
  std::size_t number() const { return lines_.number(); }
  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

 private:
  std::string_view word(std::string_view what);

  const Source& source_;
  Lines lines_;
  std::string_view rest_;
};

struct TriangleNodes {
  std::vector<Point> points;
  std::vector<Attribute> data;  ///< the attributes by number ("attribute0" ...), then "marker"
  std::int64_t first = 0;       ///< the number of the first point: 0 or 1
};

/// The line of counts and the points that follow it.
TriangleNodes read_triangle_nodes(TriangleLines& lines);

/// The point with the line's next number, of `points` points that are numbered from `first`. Throws
/// Error kIndexOutOfRange naming the line.
VertexId read_triangle_point(TriangleLines& lines, std::int64_t first, std::size_t points);

struct TriangleSegments {
  std::vector<Segment> segments;
  bool has_markers = false;
  std::vector<double> marker;  ///< one a segment if there are markers
};

/// The line of counts and the segments that follow it.
TriangleSegments read_triangle_segments(TriangleLines& lines, std::int64_t first,
                                        std::size_t points);

}  // namespace quadloom::io
