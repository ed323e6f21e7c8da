// What is true of every result of constrained_delaunay(), checked with the exact predicates and
// without its help.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "quadloom/kernel.hpp"

namespace quadloom {

/// The input points and edges by number.
struct NumberedInput {
  std::vector<Point> points;
  std::vector<Segment> edges;
  std::size_t ring_edges = 0;
};

inline NumberedInput number_input(const PlanarInput& input) {
  NumberedInput out;
  for (const Polygon& polygon : input.polygons) {
    for (const auto& ring : polygon.rings) {
      const auto first = static_cast<VertexId>(out.points.size());
      const auto size = static_cast<VertexId>(ring.size());
      for (VertexId i = 0; i < size; ++i) {
        out.points.push_back(ring[i]);
        out.edges.push_back({first + i, first + (i + 1) % size});
      }
    }
  }
  const auto first = static_cast<VertexId>(out.points.size());
  out.ring_edges = out.edges.size();
  for (const Point p : input.points) out.points.push_back(p);
  for (const Segment s : input.segments) out.edges.push_back({first + s.from, first + s.to});
  return out;
}

/// c is on the closed segment.
inline bool on_segment(Point a, Point b, Point c) {
  return orient2d(a, b, c) == 0 && !lex_less(c, std::min(a, b, lex_less)) &&
         !lex_less(std::max(a, b, lex_less), c);
}

inline void expect_positive_triangles_and_twins(const ConstrainedResult& r) {
  const Triangulation& mesh = r.mesh;
  ASSERT_EQ(mesh.twin.size(), mesh.tri_vertex.size());
  ASSERT_EQ(r.edge.size(), mesh.tri_vertex.size());
  ASSERT_EQ(r.part.size(), mesh.triangle_count());
  std::set<std::pair<VertexId, VertexId>> directed;
  std::vector<bool> used(mesh.points.size(), false);
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); ++h) {
    ASSERT_LT(mesh.origin(h), mesh.points.size());
    used[mesh.origin(h)] = true;
    ASSERT_TRUE(directed.insert({mesh.origin(h), mesh.target(h)}).second);
    if (mesh.twin[h] == kNone) continue;
    ASSERT_LT(mesh.twin[h], mesh.tri_vertex.size());
    ASSERT_EQ(mesh.twin[mesh.twin[h]], h);
    ASSERT_EQ(mesh.origin(mesh.twin[h]), mesh.target(h));
    ASSERT_EQ(mesh.target(mesh.twin[h]), mesh.origin(h));
    ASSERT_EQ(r.edge[mesh.twin[h]], r.edge[h]);
  }
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); ++h) {
    if (mesh.twin[h] == kNone) {
      ASSERT_FALSE(directed.contains({mesh.target(h), mesh.origin(h)}));
    }
  }
  for (HalfedgeId h = 0; h < mesh.tri_vertex.size(); h += 3) {
    ASSERT_GT(orient2d(mesh.points[mesh.origin(h)], mesh.points[mesh.target(h)],
                       mesh.points[mesh.apex(h)]),
              0);
  }
  ASSERT_EQ(std::count(used.begin(), used.end(), false), 0);
}

/// Every edge that is not forced is locally Delaunay, ties decided as in delaunay().
inline void expect_constrained_delaunay_edges(const ConstrainedResult& r) {
  const Triangulation& mesh = r.mesh;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone || r.edge[h] != kNone) continue;
    const Point a = mesh.points[mesh.origin(h)], b = mesh.points[mesh.target(h)];
    const Point c = mesh.points[mesh.apex(h)], d = mesh.points[mesh.apex(mesh.twin[h])];
    const int sign = incircle(a, b, c, d);
    ASSERT_LE(sign, 0);
    if (sign != 0) continue;
    // Flipped only if the lifted one is on the diagonal, and if the quad is strictly convex (four
    // points of a circle always are).
    const Point beside = lex_less(c, d) ? d : c;
    ASSERT_TRUE(lex_less(a, beside) && lex_less(b, beside));
  }
}

/// Forced edges lie on the input edge of their number, and nothing else is forced.
inline void expect_forced_edges_on_input(const PlanarInput& input, const ConstrainedResult& r) {
  const NumberedInput in = number_input(input);
  for (HalfedgeId h = 0; h < r.edge.size(); ++h) {
    if (r.edge[h] == kNone) continue;
    ASSERT_LT(r.edge[h], in.edges.size());
    const Point a = in.points[in.edges[r.edge[h]].from], b = in.points[in.edges[r.edge[h]].to];
    ASSERT_TRUE(on_segment(a, b, r.mesh.points[r.mesh.origin(h)]));
    ASSERT_TRUE(on_segment(a, b, r.mesh.points[r.mesh.target(h)]));
  }
}

/// Each input edge (the rings' alone if `rings_only`) is a chain of forced edges through every
/// vertex on it. Looks at every vertex for every edge.
inline void expect_input_edges_forced(const PlanarInput& input, const ConstrainedResult& r,
                                      bool rings_only) {
  const NumberedInput in = number_input(input);
  std::set<std::pair<VertexId, VertexId>> forced;
  for (HalfedgeId h = 0; h < r.edge.size(); ++h) {
    if (r.edge[h] == kNone) continue;
    forced.insert({r.mesh.origin(h), r.mesh.target(h)});
    forced.insert({r.mesh.target(h), r.mesh.origin(h)});
  }
  for (std::size_t e = 0; e < (rings_only ? in.ring_edges : in.edges.size()); ++e) {
    const Point a = in.points[in.edges[e].from], b = in.points[in.edges[e].to];
    std::vector<VertexId> chain;
    for (VertexId v = 0; v < r.mesh.points.size(); ++v) {
      if (on_segment(a, b, r.mesh.points[v])) chain.push_back(v);
    }
    const auto less = [&](VertexId v, VertexId w) {
      return lex_less(r.mesh.points[v], r.mesh.points[w]);
    };
    std::sort(chain.begin(), chain.end(), less);
    ASSERT_FALSE(chain.empty());
    ASSERT_EQ(r.mesh.points[chain.front()], std::min(a, b, lex_less));
    ASSERT_EQ(r.mesh.points[chain.back()], std::max(a, b, lex_less));
    for (std::size_t i = 1; i < chain.size(); ++i) {
      ASSERT_TRUE(forced.contains({chain[i - 1], chain[i]})) << "edge " << e;
    }
  }
}

__extension__ using Wide = __int128;

/// Twice the area of a polygon with whole coordinates, holes taken off.
inline Wide doubled_area(const Polygon& polygon) {
  Wide sum = 0;
  for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
    const auto& ring = polygon.rings[r];
    Wide area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      area += static_cast<Wide>(a.x) * static_cast<Wide>(b.y) -
              static_cast<Wide>(b.x) * static_cast<Wide>(a.y);
    }
    if (area < 0) area = -area;
    sum += r == 0 ? area : -area;
  }
  return sum;
}

/// Each polygon's triangles have its area, and forced edges alone are on the border of each part:
/// with positive triangles, each polygon is tiled once. Coordinates must be whole.
inline void expect_parts_tiled(const PlanarInput& input, const ConstrainedResult& r) {
  std::map<std::uint32_t, Wide> area;
  for (TriangleId t = 0; t < r.part.size(); ++t) {
    Polygon triangle;
    triangle.rings.emplace_back();
    for (int i = 0; i < 3; ++i) {
      triangle.rings[0].push_back(
          r.mesh.points[r.mesh.tri_vertex[3 * t + static_cast<TriangleId>(i)]]);
    }
    area[r.part[t]] += doubled_area(triangle);
  }
  for (std::uint32_t p = 0; p < input.polygons.size(); ++p) {
    ASSERT_TRUE(area[p] == doubled_area(input.polygons[p])) << "polygon " << p;
  }
  const NumberedInput in = number_input(input);
  for (HalfedgeId h = 0; h < r.edge.size(); ++h) {
    const HalfedgeId twin = r.mesh.twin[h];
    const std::uint32_t here = r.part[triangle_of(h)];
    const std::uint32_t there = twin == kNone ? kNone : r.part[triangle_of(twin)];
    const bool ring_edge = r.edge[h] < in.ring_edges;
    ASSERT_EQ(here != there, ring_edge);
  }
}

/// The input points are vertices bit for bit; those that are none (kNone) are counted.
inline std::size_t expect_input_vertices(const PlanarInput& input, const ConstrainedResult& r) {
  const NumberedInput in = number_input(input);
  EXPECT_EQ(r.input_to_vertex.size(), in.points.size());
  std::size_t left_out = 0;
  VertexId seen = 0;
  for (std::size_t i = 0; i < in.points.size(); ++i) {
    const VertexId v = r.input_to_vertex[i];
    if (v == kNone) {
      ++left_out;
      continue;
    }
    EXPECT_LT(v, r.mesh.points.size());
    EXPECT_EQ(r.mesh.points[v], in.points[i]);
    EXPECT_LE(v, seen);  // in the order of first occurrence
    if (v == seen) ++seen;
  }
  EXPECT_EQ(seen, r.mesh.points.size());
  return left_out;
}

/// All of it for polygons with whole coordinates.
inline void expect_polygons(const PlanarInput& input, const ConstrainedResult& r) {
  expect_input_vertices(input, r);
  ASSERT_NO_FATAL_FAILURE(expect_positive_triangles_and_twins(r));
  ASSERT_NO_FATAL_FAILURE(expect_constrained_delaunay_edges(r));
  ASSERT_NO_FATAL_FAILURE(expect_forced_edges_on_input(input, r));
  ASSERT_NO_FATAL_FAILURE(expect_input_edges_forced(input, r, true));
  ASSERT_NO_FATAL_FAILURE(expect_parts_tiled(input, r));
}

}  // namespace quadloom
