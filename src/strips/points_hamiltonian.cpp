// A triangulation of a point set whose dual graph has a Hamiltonian cycle (Arkin, Held, Mitchell and
// Skiena, theorem 3.1 and lemma 3.2).
//
//   1. split_off_hull   the h points on the hull, those inside its edges included, and the m others
//   2. start_cycle      an inner point joined to all hull points makes a cycle of triangles; where
//                       points are in the way, more than one (hamiltonian_start.hpp)
//   3. split_wedges     the points in each triangle, one by one, by random or balanced splitters
//                       (wedge_splitting.hpp)
//   4. cycle_twins      which edges are the same (cycle_twins.hpp)
//   5. by_search        no start found, and few points: an exhaustive search, which finds a cycle or
//                       proves that there is none (hamiltonian_search.hpp)
//   6. path_instead     no point inside, or no cycle found: the serpentine triangulation (Bose and
//                       Toussaint), which is a path
//
// The paper takes points in general position. With three of them on a line a point can fall on an
// edge. On one that the cycle does not cross it is inserted like any other: both triangles become two,
// which the cycle visits one after the other. On one that it crosses this need not be so:
//
//           c             Let the cycle come over a c, cross a b and leave over b d. With p on a b there
//         / | \.          are four triangles around p: acp, cbp, bdp, dap, each beside the next. The
//       a - p - b         first and the third are those that the cycle must begin and end with, and no
//         \ | /           path through a ring of four ends opposite its begin.
//           d
//
// So we keep all edges that the cycle crosses free of points, from the start on. Then points are
// inside triangles, or on edges that are not crossed. For a triangle there always is a splitter that
// keeps it so: the point nearest to the base. Hence each start gives a cycle, and all that depends on
// collinear points is whether there is a start. There is none in hull-only sets (the dual graph is a
// tree) and in sets like the pinwheel of hamiltonian_start.cpp, which have no Hamiltonian cycle
// triangulation at all. No start is found, although there is a cycle, in one of ten thousand random
// sets of seven to nine points of small grids; up to 16 points the search of step 5 tells the two apart.
//
// Cost: see the steps; O(n log n) expected, or in the worst case, for points in general position.
#include <utility>

#include "quadloom/quadrangulate.hpp"
#include "quadloom/strips.hpp"
#include "quadrangulate/point_input.hpp"
#include "quadrangulate/serpentine.hpp"
#include "strips/cycle_twins.hpp"
#include "strips/hamiltonian_search.hpp"
#include "strips/hamiltonian_start.hpp"
#include "strips/match_twins.hpp"
#include "strips/wedge_splitting.hpp"

namespace quadloom {
namespace {

using strips::Place;

struct Parts {
  std::vector<Place> hull, inner;
};

Parts split_off_hull(std::span<const Point> points) {
  Parts parts;
  std::vector<char> on_hull(points.size(), 0);
  for (const VertexId v : convex_hull(points)) {
    on_hull[v] = 1;
    parts.hull.push_back({points[v], v});
  }
  parts.inner.reserve(points.size() - parts.hull.size());
  for (VertexId v = 0; v < points.size(); ++v) {
    if (!on_hull[v]) parts.inner.push_back({points[v], v});
  }
  return parts;
}

/// Steps 2 and 3; false if there is no start.
bool by_splitting(std::span<const Point> points, Parts& parts, const HamiltonianOptions& options,
                  HamiltonianResult& result) {
  Random random(options.seed);
  const auto start = strips::start_cycle(parts.hull, parts.inner, random);
  if (!start) return false;
  strips::SplittingStatistics splitting;
  result.cycle = Answer::kYes;
  result.mesh.tri_vertex =
      strips::split_wedges(start->wedges, parts.inner, 2 * points.size() - 2 - parts.hull.size(),
                           options, random, splitting);
  result.mesh.twin =
      strips::cycle_twins(result.mesh.tri_vertex, parts.hull[0].vertex, parts.hull[1].vertex);
  result.statistics.centres = start->centres;
  result.statistics.levels = splitting.levels;
  result.statistics.locations = splitting.locations;
  result.statistics.chains = splitting.chains;
  return true;
}

void by_search(std::span<const Point> points, const HamiltonianOptions& options,
               HamiltonianResult& result) {
  if (points.size() > strips::kMostSearched) return;
  strips::CycleSearch search = strips::search_cycle(points, options.work_at_most);
  result.cycle = search.answer;
  result.mesh.tri_vertex = std::move(search.corners);
  result.mesh.twin = strips::match_twins(result.mesh.tri_vertex, points.size());
}

Triangulation path_instead(std::span<const Point> points, const Progress& progress) {
  const ConvexLayers layers = convex_layers(points, progress);
  return quadrangulate::to_triangulation(points, quadrangulate::make_serpentine(points, layers));
}

}  // namespace

HamiltonianResult hamiltonian_cycle_triangulation(std::span<const Point> input,
                                                  const HamiltonianOptions& options) {
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  HamiltonianResult result;
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  report_progress(options.progress, "hull", 0);
  Parts parts = split_off_hull(distinct.points);
  result.statistics.hull_points = parts.hull.size();
  if (parts.inner.empty()) {
    result.cycle = Answer::kNo;
  } else if (!by_splitting(distinct.points, parts, options, result)) {
    by_search(distinct.points, options, result);
  }
  if (result.cycle == Answer::kYes) {
    result.order = OrderKind::kCycle;
    result.mesh.points = std::move(distinct.points);
  } else {
    result.order = OrderKind::kPath;
    result.mesh = path_instead(distinct.points, options.progress);
  }
  return result;
}

}  // namespace quadloom
