// Points from Triangle's .node; attributes and markers are not heights and are left out.

#include "io/point_readers.hpp"
#include "io/triangle_nodes.hpp"

namespace quadloom::io {

PointTable read_node_points(const Source& source) {
  TriangleLines lines(source);
  PointTable table;
  table.points = read_triangle_nodes(lines).points;
  if (table.points.empty()) {
    fail_in(source, "the file holds no points", ErrorCode::kTooFewPoints);
  }
  return table;
}

}  // namespace quadloom::io
