// What segments enclose, as Triangle's .poly files mean it.
//
//   1. remove_outside   from the hull inwards up to the segments
//   2. locate           the triangle that holds a place: a walk from triangle to triangle that takes
//                       its edges in random order (Devillers, Pion, Teillaud 2002), since in a
//                       triangulation that is not Delaunay a fixed order can lead around in circles
//   3. spread           from there up to the segments
#include <string>

#include "core/point_text.hpp"
#include "core/random.hpp"
#include "kernel/planar_region.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

class Enclosed {
 public:
  Enclosed(const Triangulation& mesh, std::span<const std::uint32_t> edge)
      : mesh_(mesh), edge_(edge) {
    out_.inside.assign(mesh.triangle_count(), 1);
    out_.part.assign(mesh.triangle_count(), kNone);
  }

  void remove_outside() {
    for (HalfedgeId h = 0; h < mesh_.twin.size(); ++h) {
      if (mesh_.twin[h] == kNone && edge_[h] == kNone) remove(triangle_of(h));
    }
  }

  void remove_hole(Point at, std::size_t number) {
    const TriangleId t = locate(at, "hole", number);
    if (t != kNone) remove(t);
  }

  void name_region(Point at, std::uint32_t number) {
    const TriangleId t = locate(at, "region", number);
    if (t == kNone || out_.part[t] == number) return;
    spread(t, [&](TriangleId u) {
      const bool fresh = out_.part[u] != number;
      out_.part[u] = number;
      return fresh;
    });
  }

  EnclosedParts take() && { return std::move(out_); }

 private:
  void remove(TriangleId start) {
    spread(start, [&](TriangleId t) {
      const bool fresh = out_.inside[t] != 0;
      out_.inside[t] = 0;
      return fresh;
    });
  }

  /// From triangle to triangle over edges that are not forced, while `visit` says it is new.
  template <class Visit>
  void spread(TriangleId start, Visit visit) {
    if (!visit(start)) return;
    stack_.assign(1, start);
    while (!stack_.empty()) {
      const TriangleId t = stack_.back();
      stack_.pop_back();
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        const HalfedgeId twin = mesh_.twin[h];
        if (twin != kNone && edge_[h] == kNone && visit(triangle_of(twin))) {
          stack_.push_back(triangle_of(twin));
        }
      }
    }
  }

  TriangleId locate(Point at, const char* what, std::size_t number) {
    for (TriangleId t = last_;;) {
      last_ = t;
      const auto first = static_cast<HalfedgeId>(random_.below(3));
      bool on_forced = false, inside = true;
      for (HalfedgeId i = 0; i < 3 && inside; ++i) {
        const HalfedgeId h = 3 * t + (first + i) % 3;
        const Point from = mesh_.points[mesh_.origin(h)], to = mesh_.points[mesh_.target(h)];
        const int side = orient(from, to, at);
        on_forced = on_forced || at == from || (side == 0 && edge_[h] != kNone);
        if (side >= 0) continue;
        if (mesh_.twin[h] == kNone) return kNone;
        inside = false;
        t = triangle_of(mesh_.twin[h]);
      }
      if (!inside) continue;
      if (!on_forced) return t;
      throw Error(ErrorCode::kBadOption,
                  "the place " + point_text(at) + " of " + what + ' ' + std::to_string(number) +
                      " is on a segment or a point, so that its part is not clear",
                  {number});
    }
  }

  const Triangulation& mesh_;
  std::span<const std::uint32_t> edge_;
  EnclosedParts out_;
  std::vector<TriangleId> stack_;
  TriangleId last_ = 0;
  Random random_{1};
};

}  // namespace

EnclosedParts enclosed_parts(const Triangulation& mesh, std::span<const std::uint32_t> edge,
                             const PlanarInput& input) {
  Enclosed enclosed(mesh, edge);
  enclosed.remove_outside();
  for (std::size_t i = 0; i < input.holes.size(); ++i) enclosed.remove_hole(input.holes[i], i);
  for (std::uint32_t i = 0; i < input.regions.size(); ++i) {
    enclosed.name_region(input.regions[i], i);
  }
  return std::move(enclosed).take();
}

}  // namespace quadloom::kernel
