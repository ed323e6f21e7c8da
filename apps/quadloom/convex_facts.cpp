#include "convex_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "exit_codes.hpp"
#include "facts.hpp"

namespace quadloom::app {
namespace {

constexpr std::size_t kMostNamed = 4;
constexpr std::size_t kMostListed = 1000;

/// A corner that keeps a quad from being strictly convex.
struct BadCorner {
  QuadId quad;
  VertexId vertex;
  bool flat;  // else reflex
  bool
      on_boundary;  // of the mesh, which stays as it is: the corner may be what makes it impossible
};

std::vector<std::uint8_t> boundary_vertices(const PolygonMesh& mesh) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      edges.emplace_back(face[i], face[(i + 1) % face.size()]);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint8_t> on_boundary(mesh.points.size(), 0);
  for (const auto& [a, b] : edges) {
    if (!std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) {
      on_boundary[a] = on_boundary[b] = 1;
    }
  }
  return on_boundary;
}

std::vector<BadCorner> bad_corners(const PolygonMesh& mesh, std::span<const QuadId> quads) {
  const std::vector<std::uint8_t> on_boundary = boundary_vertices(mesh);
  std::vector<BadCorner> out;
  for (const QuadId q : quads) {
    const auto v = mesh.face(q);
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId corner = v[(i + 1) % 4];
      const int turn =
          orient2d(mesh.points[v[i]], mesh.points[corner], mesh.points[v[(i + 2) % 4]]);
      if (turn <= 0) out.push_back({q, corner, turn == 0, on_boundary[corner] != 0});
    }
  }
  return out;
}

std::string place_of(const PolygonMesh& mesh, VertexId v) {
  return fmt::format("{} ({:.6g}, {:.6g})", v, mesh.points[v].x, mesh.points[v].y);
}

std::string corners_of(const PolygonMesh& mesh, QuadId quad, std::span<const BadCorner> bad) {
  std::string out;
  for (const VertexId v : mesh.face(quad)) out += (out.empty() ? "" : ", ") + place_of(mesh, v);
  for (const BadCorner& c : bad) {
    if (c.quad != quad) continue;
    out += fmt::format(", {} at {}{}", c.flat ? "flat" : "reflex", c.vertex,
                       c.on_boundary ? ", a corner of the boundary" : "");
  }
  return out;
}

}  // namespace

std::vector<QuadId> find_not_convex(const Quadrangulation& mesh) {
  std::vector<QuadId> out;
  for (QuadId q = 0; q < mesh.quad_count(); ++q) {
    const VertexId* v = &mesh.quad_vertex[4 * std::size_t{q}];
    bool convex = true;
    for (std::size_t i = 0; i < 4 && convex; ++i) {
      convex =
          orient2d(mesh.points[v[i]], mesh.points[v[(i + 1) % 4]], mesh.points[v[(i + 2) % 4]]) > 0;
    }
    if (!convex) out.push_back(q);
  }
  return out;
}

std::string mending_line(const MendStatistics& mending, std::size_t added_inside) {
  if (mending.bad == 0) return {};
  const std::string added = added_inside == 0 ? "no point" : counted(added_inside, "point");
  return fmt::format("{} {} not strictly convex, {} added inside\n", counted(mending.bad, "quad"),
                     mending.bad == 1 ? "was" : "were", added);
}

int tell_not_convex(const PolygonMesh& mesh, std::span<const QuadId> not_convex) {
  if (not_convex.empty()) return kDone;
  const std::size_t named = std::min(kMostNamed, not_convex.size());
  std::string line = fmt::format(
      "{} {} not strictly convex, no doubles were found for points that would mend {}: ",
      counted(not_convex.size(), "quad"), not_convex.size() == 1 ? "is" : "are",
      not_convex.size() == 1 ? "it" : "them");
  const std::vector<BadCorner> bad = bad_corners(mesh, not_convex.first(named));
  for (std::size_t i = 0; i < named; ++i) {
    line +=
        fmt::format("{}the vertices {}", i > 0 ? "; " : "", corners_of(mesh, not_convex[i], bad));
  }
  if (named < not_convex.size()) {
    line += fmt::format("; {} more (--report lists them)", not_convex.size() - named);
  }
  fmt::print(stderr, "quadloom: {}\n", line);
  return kGuaranteeMissed;
}

Json mending_json(const MendStatistics& mending) {
  return {{"bad", mending.bad},           {"bad_after_moves", mending.bad_after_moves},
          {"clusters", mending.clusters}, {"stars", mending.stars},
          {"cases", mending.cases},       {"left", mending.left}};
}

Json convex_json(const ConvexStatistics& statistics) {
  return {{"kept", statistics.kept},
          {"patches", statistics.patches},
          {"patches_by_points", statistics.patches_by_points},
          {"mending", mending_json(statistics.mending)}};
}

Json not_convex_json(const PolygonMesh& mesh, std::span<const QuadId> not_convex) {
  const auto listed = not_convex.first(std::min(kMostListed, not_convex.size()));
  Json corners = Json::array();
  for (const BadCorner& c : bad_corners(mesh, listed)) {
    corners.push_back({{"quad", c.quad},
                       {"vertex", c.vertex},
                       {"turn", c.flat ? "flat" : "reflex"},
                       {"boundary", c.on_boundary}});
  }
  return {{"quads", not_convex.size()}, {"listed", listed}, {"corners", corners}};
}

}  // namespace quadloom::app
