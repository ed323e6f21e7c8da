#include "guarantee.hpp"

#include <limits>
#include <span>

#include "mesh.hpp"

namespace quadloom::python {
namespace {

std::string added(std::size_t n) {
  return n == 0 ? "no point added" : counted(n, "point") + " added";
}

// "3 points added, at most 12 promised (...)"
std::string bounded(std::size_t n, std::size_t bound, const std::string& source) {
  return added(n) + ", at most " + std::to_string(bound) + " promised (" + source + ")";
}

std::string on_the_hull(std::size_t n) {
  return counted(n, "point is", "points are") + " on the hull, an " +
         (n % 2 == 0 ? "even" : "odd") + " number";
}

std::size_t outer(std::span<const SteinerPoint> steiner) {
  std::size_t n = 0;
  for (const SteinerPoint& s : steiner) n += s.kind != SteinerKind::kInner ? 1 : 0;
  return n;
}

std::string all_strictly_convex(std::size_t quads, std::size_t not_convex) {
  if (not_convex == 0) return "all " + counted(quads, "quad is", "quads are") + " strictly convex";
  return counted(not_convex, "quad", "quads") + " of " + std::to_string(quads) +
         " could not be made strictly convex among the doubles";
}

const char* theorem_of(TriangleMethod method) {
  switch (method) {
    case TriangleMethod::kPercolate:
      return "Ramaswami, Ramos and Toussaint, theorem 3.3";
    case TriangleMethod::kFans:
      return "Ramaswami, Ramos and Toussaint, theorem 2.1";
    case TriangleMethod::kQPercolate:
      return "Ramaswami, Ramos and Toussaint, theorem 3.4";
    case TriangleMethod::kQuarter:
      return "Ramaswami, Ramos and Toussaint, the full paper";
    default:
      return "";
  }
}

}  // namespace

std::string guarantee_of(const PointResult& result, const PointOptions& options) {
  const std::size_t h = result.statistics.hull_points;
  const std::size_t bound = steiner_bound(result.statistics, options);
  if (bound == std::numeric_limits<std::size_t>::max()) {
    return "all " + counted(result.mesh.quad_count(), "quad is", "quads are") +
           " strictly convex, three for each Delaunay triangle; one point added an edge and one a "
           "triangle "
           "(de Berg)";
  }
  std::string text = added(result.steiner.size());
  if (result.mesh.triangle_count() > 0) text += " and one triangle left";
  return text + ", the fewest possible, since " + on_the_hull(h) +
         " (Bose and Toussaint, theorems 3.1 and 4.3)";
}

std::string guarantee_of(const KAngulationResult& result, std::size_t k) {
  return "all faces have " + std::to_string(k) + " corners; " + added(result.steiner.size()) +
         ", as a rule at most " + std::to_string(k - 3) + " (Bose and Toussaint, corollary 4.1)";
}

std::string guarantee_of(const TriangleResult& result, const TriangleOptions& options) {
  const std::size_t bound = steiner_bound(result.statistics, options);
  const std::size_t left = result.mesh.triangle_count();
  std::string text =
      left == 0 ? "all faces are quads" : counted(left, "triangle is", "triangles are") + " left";
  text += "; every vertex, edge to keep and border of a region stays; ";
  if (options.method == TriangleMethod::kSubdivide) {
    return text +
           "all quads of a planar mesh are strictly convex; one point added an edge and one a face "
           "(de Berg)";
  }
  if (bound != std::numeric_limits<std::size_t>::max()) {
    const std::string theorem = theorem_of(options.method);
    return text + (theorem.empty() ? added(result.steiner.size())
                                   : bounded(result.steiner.size(), bound, theorem));
  }
  if (options.method == TriangleMethod::kPercolate) {
    return text + added(result.steiner.size()) +
           ", the fewest outer ones for this triangulation (" + theorem_of(options.method) + ")";
  }
  const std::size_t border = outer(result.steiner);
  text += added(result.steiner.size());
  if (!result.steiner.empty()) text += ", " + std::to_string(border) + " of them on the border";
  return text + "; " + counted(result.statistics.odd_parts, "part has", "parts have") +
         " an odd border, and no mesh of quads alone has one (Euler)";
}

std::string guarantee_of(const ConvexResult& result, const ConvexOptions& options) {
  const std::size_t bound = steiner_bound(result.input_vertices, result.statistics, options);
  std::string text = all_strictly_convex(result.mesh.quad_count(), result.not_convex.size()) +
                     "; " +
                     bounded(result.steiner.size(), bound,
                             options.method == ConvexMethod::kPentagons
                                 ? "Ramaswami, Ramos and Toussaint, theorem 4.2"
                                 : "Bremner, Hurtado, Ramaswami and Sacristan, theorem 3.1");
  if (result.mesh.triangle_count() > 0) {
    text += "; one triangle left, since " + on_the_hull(result.statistics.hull_points);
  }
  return text;
}

std::string guarantee_of(const ConvexMeshResult& result) {
  return all_strictly_convex(result.quads.mesh.quad_count(), result.not_convex.size()) +
         "; every vertex, edge to keep and border of a region stays; " +
         added(result.quads.steiner.size());
}

}  // namespace quadloom::python
