// The fewest outer Steiner points that turn a given triangulation into quads.
//
// Ramaswami, Ramos and Toussaint, Converting Triangulations to Quadrangulations, theorem 3.3: pair as
// many triangles as possible such that what stays over are leaves of the dual tree; each of these has an
// edge on the boundary, and a Steiner point outside that edge makes a quad of it. No other quads are
// possible without an edge more or less, so the number of points is the least for this triangulation; at most
// n / 3 for a simple polygon of n corners.
//
// Steps:
//   1. match_tree           theorem 3.2, in O(n), if the dual is a forest
//   2. match_inside_first   otherwise, and where leaves have no boundary edge: a maximum matching in which
//                           what stays over has boundary edges, if there is one (boundary_matching.hpp)
//   3. add_outer_points
//
//      \  /|              The triangle a, b, c that stays over and the point s outside its boundary
//       c  |  .           edge a b are the quad a s b c.
//      / \ | . .
//     a---b      s is below a b
//
// What differs from the paper: step 2, for triangulations with holes, inner vertices or edges that stay;
// the paper has step 1 alone. A triangle with two boundary edges takes the longer one, if it has a
// place. Places are those of outer_places.hpp: all of them together leave the boundary simple.
//
// Degenerate input: parts of one triangle; corners that touch. Where no boundary is near enough, so that a
// triangle stays over whatever is done, and where no double is outside an edge, the answer is an
// Error. Cost: O(n) for step 1, the matching's for step 2, and O(b log b) for b boundary edges.
#include "quadrangulate/triangulation_percolate.hpp"

#include <array>
#include <optional>
#include <string>

#include "quadloom/dual.hpp"
#include "quadrangulate/border_edges.hpp"
#include "quadrangulate/boundary_matching.hpp"
#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/outer_places.hpp"
#include "quadrangulate/quad_collector.hpp"

namespace quadloom::quadrangulate {
namespace {

bool is_forest(const Triangulation& cut, const MeshParts& parts) {
  const std::size_t edges = (cut.twin.size() - border_size(cut)) / 2;
  return edges + parts.count() == cut.triangle_count();
}

class Percolation {
 public:
  Percolation(const TriangleMesh& input, const TriangleOptions& options)
      : input_(input), options_(options), cut_(cut_along_kept_edges(input)), out_(input) {}

  TriangleResult run() {
    const MeshParts parts = parts_of(cut_);
    out_.statistics().parts = parts.count();
    out_.statistics().odd_parts = parts.odd_count();
    report_progress(options_.progress, "pairing", 0);
    if (!is_forest(cut_, parts) || !match_tree()) match_inside_first();
    out_.statistics().unmatched = matching_.unmatched;
    report_progress(options_.progress, "outer points", 0);
    add_outer_points();
    return out_.take();
  }

 private:
  bool match_tree();
  void match_inside_first();
  void add_outer_points();
  bool has_boundary_edge(TriangleId t) const {
    const auto& twin = input_.mesh.twin;
    return twin[3 * t] == kNone || twin[3 * t + 1] == kNone || twin[3 * t + 2] == kNone;
  }

  const TriangleMesh& input_;
  const TriangleOptions& options_;
  const Triangulation cut_;
  DualMatching matching_;
  QuadCollector out_;
};

/// False if a leaf that stays over has no boundary edge.
bool Percolation::match_tree() {
  matching_ = percolate_up_and_down(dual_graph(cut_));
  for (TriangleId t = 0; t < matching_.mate.size(); ++t) {
    if (matching_.mate[t] == kNone && !has_boundary_edge(t)) return false;
  }
  return true;
}

void Percolation::match_inside_first() {
  std::vector<std::uint8_t> may_stay(cut_.triangle_count());
  for (TriangleId t = 0; t < may_stay.size(); ++t) may_stay[t] = has_boundary_edge(t) ? 1 : 0;
  matching_ = matching_inside_first(dual_graph(cut_), may_stay);
  for (TriangleId t = 0; t < may_stay.size(); ++t) {
    if (matching_.mate[t] != kNone || may_stay[t] != 0) continue;
    throw Error(
        ErrorCode::kGuarantee,
        "triangle " + std::to_string(t) +
            " stays over whatever is paired, or another one inside does: no boundary edge is "
            "near enough for an outer Steiner point to help",
        {t});
  }
}

void Percolation::add_outer_points() {
  std::optional<OuterPlaces> places;
  for (TriangleId t = 0; t < matching_.mate.size(); ++t) {
    const HalfedgeId h = matching_.mate[t];
    if (h != kNone) {
      if (h < cut_.twin[h]) out_.add_pair(h);
      continue;
    }
    if (!places) places.emplace(input_.mesh);
    const std::array<TriangleId, 1> alone = {t};
    const auto [edge, place] = longest_with_place(input_.mesh, alone, *places);
    out_.add_split(edge, out_.add_steiner({place, 0, SteinerKind::kOutside}, edge));
  }
}

}  // namespace

TriangleResult percolate_triangulation(const TriangleMesh& input, const TriangleOptions& options) {
  require_planar(input);
  return Percolation(input, options).run();
}

}  // namespace quadloom::quadrangulate
