// A simple polygon through all points that is a spiral and has a serpentine triangulation (Iwerks and
// Mitchell, Spiral serpentine polygonization of a planar point set, theorem 2.5).
//
// A ray turns counter-clockwise about a pivot, from the point that it passes through, until it meets
// an unvisited point:
//
//      q <--              less than half a turn: the triangle pivot, pass, q; q is the next pivot,
//       \    \.           and the ray turns from the same pass-through point
//        \    |
//     pivot ----- pass    half a turn or more, or none left: back to the pivot before; the ray passes
//                         through the one that was left
//
//   1. sort_points       and find the start, the lowest point, of those the one farthest right: the
//                        first pivot
//   2. take_out_flats    the points inside the hull's first edge, from the start counter-clockwise
//   3. wind              the loop above; at most 2 n turns of it (lemma 2.1)
//   4. make_ring         pivots are the reflex chain, pass-through points the convex one
//   5. put_back_flats    into the first triangle, which becomes a fan
//
// Different from the paper: the next point is not sought by binary searches on convex layers. The
// unvisited points all lie on one side of the ray, so the point that it meets is where the tangent
// from the pivot touches their hull, and the hull under deletions is kept (shrinking_hull.hpp).
//   - For a pivot that was just taken off the hull this is its neighbour there.
//   - After a step back it is that neighbour, or one of those before it, most of which came to light
//     when the last point was taken off: each comes to light once, so all these walks together are O(n).
// Lemma 2.6, that points within one layer of the pivot's are enough, is not needed; as it stands it does
// not hold (tests/property/spiral_polygon_test.cpp has eleven points in general position where the next
// point is two layers away).
//
// Degenerate input. Ties go to the nearest point, as in the paper; points inside hull edges are flat
// corners. One place needs care: with points inside the hull's first edge the nearest of them would be
// the first pass-through point, those behind it lie on the ray and are not met, and the paper's
// procedure stops before the end. They are left out of the loop, which then never meets a point on the
// ray itself: such a point would have been met from the pivot in between. When the unvisited points are
// on one line, the tangent goes to one of its two ends.
//
// Cost: O(n log n), O(n) space.
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/step_reports.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadloom/strips.hpp"
#include "quadrangulate/point_input.hpp"
#include "strips/match_twins.hpp"
#include "strips/shrinking_hull.hpp"

namespace quadloom {
namespace {

using kernel::orient;
using strips::ShrinkingHull;

/// Which point of the edge pivot - pass the new point takes the place of.
enum class Replaced { kPivot, kPass };

class Winding {
 public:
  Winding(std::span<const Point> points, const Progress& progress)
      : input_(points), progress_(progress) {}

  SpiralPolygon run() {
    sort_points();
    ShrinkingHull hull(points_);
    take_out_flats(hull);
    wind(hull);
    make_ring();
    put_back_flats();
    return std::move(out_);
  }

 private:
  using Spot = ShrinkingHull::Spot;
  struct Step {
    VertexId pivot, pass, next;
  };

  void sort_points() {
    order_.resize(input_.size());
    std::iota(order_.begin(), order_.end(), VertexId{0});
    std::sort(order_.begin(), order_.end(),
              [&](VertexId a, VertexId b) { return lex_less(input_[a], input_[b]); });
    points_.reserve(input_.size());
    for (const VertexId v : order_) points_.push_back(input_[v]);
  }

  /// Takes the start, the flats and the first pass-through point off the hull.
  void take_out_flats(ShrinkingHull& hull) {
    Spot start = hull.spot_of_greatest();
    for (Spot s = hull.after(start); s.point != hull.greatest(); s = hull.after(s)) {
      const Point p = points_[s.point], q = points_[start.point];
      if (p.y < q.y || (p.y == q.y && p.x > q.x)) start = s;
    }
    start_ = start.point;
    Spot pass = hull.after(start);
    for (Spot s = hull.after(pass);
         orient(points_[start_], points_[pass.point], points_[s.point]) == 0; s = hull.after(s)) {
      flats_.push_back(pass.point);
      pass = s;
    }
    pass_ = pass.point;
    after_last_ = hull.erase(start);
    for (std::size_t i = 0; i <= flats_.size(); ++i) after_last_ = hull.erase(after_last_);
  }

  /// Where the tangent from the pivot that has all unvisited points on its left touches them first.
  /// `fresh`: the pivot is the point that was taken off last; else the one before it.
  Spot tangent(const ShrinkingHull& hull, VertexId pivot, bool fresh) const {
    const Point eye = points_[pivot];
    if (hull.straight()) {
      const Point a = points_[hull.least()], b = points_[hull.greatest()];
      const int side = orient(eye, a, b);
      return {side > 0 || (side == 0 && lex_less(eye, a)) ? hull.least() : hull.greatest()};
    }
    Spot spot = after_last_;
    while (!fresh) {
      const Spot before = hull.before(spot);
      const Point p = points_[spot.point], q = points_[before.point];
      const int side = orient(eye, p, q);
      const bool nearer = side == 0 && dot_sign(q, eye, q, p) < 0;
      if (side > 0 || (side == 0 && !nearer)) break;
      spot = before;
    }
    return spot;
  }

  void wind(ShrinkingHull& hull) {
    VertexId pivot = start_, pass = pass_, pivot_before = kNone;
    bool fresh = false;
    StepReports report(progress_, "winding", 2 * points_.size());
    while (!hull.empty()) {
      report();
      ++out_.statistics.iterations;
      const Spot next = tangent(hull, pivot, fresh);
      fresh = orient(points_[pivot], points_[pass], points_[next.point]) > 0;
      if (fresh) {
        steps_.push_back({pivot, pass, next.point});
        after_last_ = hull.erase(next);
        pivot_before = pivot;
        pivot = next.point;
      } else {
        pass = pivot;
        pivot = pivot_before;
        pivot_before = kNone;
      }
    }
  }

  /// Of the last step it does not matter.
  Replaced replaced(std::size_t step) const {
    const bool pass_stays = step + 1 < steps_.size() && steps_[step + 1].pass == steps_[step].pass;
    return pass_stays ? Replaced::kPivot : Replaced::kPass;
  }

  void make_ring() {
    std::vector<VertexId>& ring = out_.ring;
    ring.push_back(order_[start_]);
    for (const VertexId flat : flats_) ring.push_back(order_[flat]);
    ring.push_back(order_[pass_]);
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (replaced(i) == Replaced::kPass) ring.push_back(order_[steps_[i].next]);
    }
    for (std::size_t i = steps_.size(); i-- > 0;) {
      if (replaced(i) == Replaced::kPivot) ring.push_back(order_[steps_[i].next]);
    }
  }

  void put_back_flats() {
    std::vector<VertexId>& corners = out_.mesh.tri_vertex;
    corners.reserve(3 * (input_.size() - 2));
    std::vector<VertexId> edge = {start_};  // of the first triangle
    edge.insert(edge.end(), flats_.begin(), flats_.end());
    edge.push_back(pass_);
    for (std::size_t k = 0; k + 1 < edge.size();
         ++k) {  // the last has the edge to the next triangle
      const std::size_t i = replaced(0) == Replaced::kPivot ? k : edge.size() - 2 - k;
      corners.insert(corners.end(), {order_[edge[i]], order_[edge[i + 1]], order_[steps_[0].next]});
    }
    for (std::size_t i = 1; i < steps_.size(); ++i) {
      corners.insert(corners.end(),
                     {order_[steps_[i].pivot], order_[steps_[i].pass], order_[steps_[i].next]});
    }
  }

  std::span<const Point> input_;
  const Progress& progress_;
  std::vector<VertexId>
      order_;  // lexicographic; the other members name points by their place in it
  std::vector<Point> points_;
  std::vector<VertexId> flats_;  // from the start on
  VertexId start_ = kNone, pass_ = kNone;
  Spot after_last_;  // what came after the last erased point on the ring
  std::vector<Step> steps_;
  SpiralPolygon out_;
};

}  // namespace

SpiralPolygon spiral_polygon(std::span<const Point> input, const Progress& progress) {
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  SpiralPolygon result = Winding(distinct.points, progress).run();
  result.mesh.twin = strips::match_twins(result.mesh.tri_vertex, distinct.points.size());
  result.mesh.points = std::move(distinct.points);
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  return result;
}

}  // namespace quadloom
