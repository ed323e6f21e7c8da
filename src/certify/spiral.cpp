// Whether a ring is a spiral polygon through given points.
//
//   1. check_ring      at least three corners, all finite
//   2. check_simple    no two edges share a point, but neighbours their corner (certify/polygon.hpp); so
//                      no place is there twice
//   3. check_turn      counter-clockwise
//   4. check_points    each point is a corner, each corner a point
//   5. check_reflex    the reflex corners follow each other around the ring when flat ones are left out
//
// Each step may rely on those before it. Cost: O(k log k) for k corners, linear in the points.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "certify/places.hpp"
#include "certify/polygon.hpp"
#include "core/point_text.hpp"
#include "quadloom/certify.hpp"

namespace quadloom {
namespace {

class SpiralJudge {
 public:
  SpiralJudge(std::span<const Point> ring, std::span<const Point> points)
      : ring_(ring), points_(points) {}

  Certificate judge() {
    (void)(check_ring() && check_simple() && check_turn() && check_points() && check_reflex());
    return std::move(out_);
  }

 private:
  bool fault(Fault fault, std::string sentence, std::vector<std::size_t> culprits) {
    out_.fault = fault;
    out_.sentence = std::move(sentence);
    out_.culprits = std::move(culprits);
    return false;
  }

  std::string corner_text(std::size_t i) const {
    return "corner " + std::to_string(i) + " " + point_text(ring_[i]);
  }

  bool check_ring() {
    if (ring_.size() < 3)
      return fault(Fault::kCornerCount, "the ring has fewer than three corners", {});
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (!std::isfinite(ring_[i].x) || !std::isfinite(ring_[i].y)) {
        return fault(Fault::kNotFinite, corner_text(i) + " is not finite", {i});
      }
    }
    return true;
  }

  bool check_simple() {
    out_.faces = 1;
    out_.boundary = ring_.size();
    constexpr std::size_t kByPairs = 64;
    if (ring_.size() <= kByPairs ? certify::edges_disjoint_by_pairs(ring_)
                                 : certify::edges_disjoint_by_sweep(ring_)) {
      return true;
    }
    return fault(Fault::kNotSimple, "the ring crosses or touches itself", {});
  }

  int turn(std::size_t i) const {
    const std::size_t k = ring_.size();
    return orient2d(ring_[(i + k - 1) % k], ring_[i], ring_[(i + 1) % k]);
  }

  bool check_turn() {
    const auto least = std::min_element(ring_.begin(), ring_.end(), lex_less) - ring_.begin();
    if (turn(static_cast<std::size_t>(least)) > 0) return true;
    return fault(Fault::kNotSimple, "the ring is clockwise", {});
  }

  bool check_points() {
    certify::Places places(ring_);
    places.reserve(ring_.size());
    for (VertexId i = 0; i < ring_.size(); ++i) places.insert(i);
    std::vector<std::uint8_t> asked(ring_.size(), 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const VertexId corner = places.find(points_[i]);
      if (corner == kNone) {
        return fault(Fault::kMissingPoint,
                     "point " + std::to_string(i) + " " + point_text(points_[i]) + " is no corner",
                     {i});
      }
      out_.points += asked[corner] == 0 ? 1 : 0;
      asked[corner] = 1;
    }
    const auto extra = std::find(asked.begin(), asked.end(), 0);
    if (extra == asked.end()) return true;
    const auto i = static_cast<std::size_t>(extra - asked.begin());
    out_.steiner = ring_.size() - out_.points;
    return fault(Fault::kTooManySteiner, corner_text(i) + " is none of the points", {i});
  }

  bool check_reflex() {
    std::vector<std::size_t> begins;  // reflex corners after a convex one
    int before = 0;
    for (std::size_t i = ring_.size(); i-- > 0 && before == 0;) before = turn(i);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const int here = turn(i);
      ++(here > 0 ? out_.strictly_convex : here == 0 ? out_.flat_cornered : out_.non_convex);
      if (here == 0) continue;
      if (here < 0 && before > 0) begins.push_back(i);
      before = here;
    }
    if (begins.size() <= 1) return true;
    const std::string sentence = "the reflex corners make " + std::to_string(begins.size()) +
                                 " chains; one begins at " + corner_text(begins[0]) + ", one at " +
                                 corner_text(begins[1]);
    return fault(Fault::kReflexChains, sentence, std::move(begins));
  }

  std::span<const Point> ring_;
  std::span<const Point> points_;
  Certificate out_;
};

}  // namespace

Certificate certify_spiral_polygon(std::span<const Point> ring, std::span<const Point> points) {
  return SpiralJudge(ring, points).judge();
}

}  // namespace quadloom
