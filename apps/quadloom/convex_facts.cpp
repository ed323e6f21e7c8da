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

std::string corners_of(const PolygonMesh& mesh, QuadId quad) {
  std::string out;
  for (const VertexId v : mesh.face(quad)) {
    const Point p = mesh.points[v];
    out += fmt::format("{}{} ({:.6g}, {:.6g})", out.empty() ? "" : ", ", v, p.x, p.y);
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
  for (std::size_t i = 0; i < named; ++i) {
    line += fmt::format("{}the vertices {}", i > 0 ? "; " : "", corners_of(mesh, not_convex[i]));
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

Json not_convex_json(std::span<const QuadId> not_convex) {
  return {{"quads", not_convex.size()},
          {"listed", not_convex.first(std::min(kMostListed, not_convex.size()))}};
}

}  // namespace quadloom::app
