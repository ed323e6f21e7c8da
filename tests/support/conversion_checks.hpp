// What every conversion of a triangulation promises, checked from the result alone.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "quadloom/quadloom.hpp"

namespace quadloom::test {

using Edge = std::pair<VertexId, VertexId>;

inline Edge edge_of(VertexId a, VertexId b) { return std::minmax(a, b); }

/// All edges of the faces of a mesh.
inline std::set<Edge> face_edges(const PolygonMesh& mesh) {
  std::set<Edge> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      edges.insert(edge_of(face[i], face[(i + 1) % face.size()]));
    }
  }
  return edges;
}

inline bool is_kept(const TriangleMesh& input, HalfedgeId h) {
  const HalfedgeId twin = input.mesh.twin[h];
  if (twin == kNone) return true;
  if (!input.keep.empty() && (input.keep[h] != 0 || input.keep[twin] != 0)) return true;
  return !input.region.empty() && input.region[triangle_of(h)] != input.region[triangle_of(twin)];
}

/// Edges to keep, borders of regions and the boundary are edges still, or two with a point added there.
inline void check_kept_edges(const TriangleMesh& input, const TriangleResult& result) {
  std::map<Edge, VertexId> added;
  for (const SteinerPoint& s : result.steiner) {
    if (s.kind != SteinerKind::kInner) added[edge_of(s.parents[0], s.parents[1])] = s.vertex;
  }
  const std::set<Edge> edges = face_edges(to_polygon_mesh(result.mesh));
  for (HalfedgeId h = 0; h < input.mesh.twin.size(); ++h) {
    if (!is_kept(input, h)) continue;
    const VertexId a = input.mesh.origin(h), b = input.mesh.target(h);
    if (const auto s = added.find(edge_of(a, b)); s != added.end()) {
      EXPECT_TRUE(edges.contains(edge_of(a, s->second)) && edges.contains(edge_of(s->second, b)));
    } else {
      EXPECT_TRUE(edges.contains(edge_of(a, b))) << "edge " << a << " " << b << " is gone";
    }
  }
}

/// Every source triangle has a face, and no face has sources of two regions.
inline void check_sources(const TriangleMesh& input, const TriangleResult& result) {
  ASSERT_EQ(result.quad_source.size(), result.mesh.quad_count());
  ASSERT_EQ(result.triangle_source.size(), result.mesh.triangle_count());
  std::vector<std::size_t> faces(input.mesh.triangle_count());
  for (const auto& [a, b] : result.quad_source) {
    ASSERT_LT(a, faces.size());
    ++faces[a];
    if (b == kNone) continue;
    ASSERT_LT(b, faces.size());
    ++faces[b];
    if (!input.region.empty()) {
      EXPECT_EQ(input.region[a], input.region[b]);
    }
  }
  for (const TriangleId t : result.triangle_source) {
    ASSERT_LT(t, faces.size());
    ++faces[t];
  }
  EXPECT_GE(*std::min_element(faces.begin(), faces.end()), 1U);
}

/// The whole promise for a planar mesh; `triangles` may be left.
inline void check_conversion(const TriangleMesh& input, const TriangleResult& result,
                             std::size_t triangles = 0) {
  const auto outside = std::count_if(result.steiner.begin(), result.steiner.end(),
                                     [](const auto& s) { return s.kind == SteinerKind::kOutside; });
  CertifyOptions wanted;
  wanted.triangles_allowed = triangles;
  wanted.outer_steiner = outside > 0;
  const Certificate certificate =
      certify_mesh(to_polygon_mesh(result.mesh), to_polygon_mesh(input.mesh), wanted);
  ASSERT_TRUE(certificate.ok()) << certificate.sentence;
  EXPECT_EQ(certificate.triangles, triangles);
  EXPECT_EQ(certificate.steiner, result.steiner.size());
  EXPECT_EQ(result.input_vertices, input.mesh.points.size());
  EXPECT_EQ(result.mesh.points.size(), input.mesh.points.size() + result.steiner.size());
  EXPECT_TRUE(
      std::equal(input.mesh.points.begin(), input.mesh.points.end(), result.mesh.points.begin()));
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    EXPECT_EQ(result.steiner[i].vertex, input.mesh.points.size() + i);
  }
  check_kept_edges(input, result);
  check_sources(input, result);
}

/// Labels for the triangles, `labels` of them, in connected patches that grow from random triangles.
inline std::vector<std::uint32_t> random_regions(const Triangulation& mesh, std::uint32_t labels,
                                                 Random& random) {
  std::vector<std::uint32_t> region(mesh.triangle_count(), kNone);
  std::vector<TriangleId> rim;
  for (std::uint32_t label = 0; label < labels; ++label) {
    const auto t = static_cast<TriangleId>(random.below(region.size()));
    region[t] = label;
    rim.push_back(t);
  }
  while (!rim.empty()) {
    const std::size_t i = random.below(rim.size());
    const TriangleId t = rim[i];
    rim[i] = rim.back();
    rim.pop_back();
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh.twin[h] == kNone || region[triangle_of(mesh.twin[h])] != kNone) continue;
      region[triangle_of(mesh.twin[h])] = region[t];
      rim.push_back(triangle_of(mesh.twin[h]));
    }
  }
  return region;
}

/// Marks each inner edge to be kept with a chance of one in `one_in`.
inline std::vector<std::uint8_t> random_kept_edges(const Triangulation& mesh, std::uint64_t one_in,
                                                   Random& random) {
  std::vector<std::uint8_t> keep(mesh.twin.size());
  for (std::uint8_t& k : keep) k = random.below(2 * one_in) == 0 ? 1 : 0;
  return keep;
}

}  // namespace quadloom::test
