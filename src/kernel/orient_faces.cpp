// Faces that go around the right way, consistently over edges.
//
//   In the plane   orient_in_plane: triangles with an area turn counter-clockwise; those without take
//                  the direction of their neighbours, breadth first from those with an area.
//   On a surface   orient_on_surface: component by component, breadth first from its first triangle,
//                  each triangle as its neighbour; then the way in which most of the component's
//                  faces were given wins, in a tie that of the first face. So a closed surface stays
//                  inside out if it came so.
//
// Then check_sides: an edge whose sides go the same way has, in the plane, two faces on one side; a
// surface has one side only, like Moebius' strip. Halves of quads turn together, since a diagonal is
// an edge like others. O(n).
#include <algorithm>

#include "kernel/connect_steps.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

enum class Way : std::uint8_t { kUnknown, kAsGiven, kTurned };

Way opposite(Way way) { return way == Way::kAsGiven ? Way::kTurned : Way::kAsGiven; }

class Orienting {
 public:
  Orienting(Connecting& work, std::span<const HalfedgeId> other)
      : work_(work), mesh_(work.mesh()), other_(other), way_(mesh_.triangle_count()) {
    queue_.reserve(way_.size());
  }

  void run() {
    if (work_.out.space == Space::kPlane) {
      orient_in_plane();
    } else {
      orient_on_surface();
    }
    check_sides();
    refuse_turned();
    turn_triangles();
  }

 private:
  bool same_way(HalfedgeId h) const { return mesh_.origin(h) == mesh_.origin(other_[h]); }

  /// The first triangle of a face stands for it.
  bool counts(TriangleId t) const {
    return t == 0 || work_.out.source_face[t] != work_.out.source_face[t - 1];
  }

  /// Gives a way to all triangles that can be reached from queue_[from ..], which have one.
  void spread(std::size_t from) {
    for (std::size_t i = from; i < queue_.size(); ++i) {
      const TriangleId t = queue_[i];
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (other_[h] == kNone) continue;
        const TriangleId next = triangle_of(other_[h]);
        if (way_[next] != Way::kUnknown) continue;
        way_[next] = same_way(h) ? opposite(way_[t]) : way_[t];
        queue_.push_back(next);
      }
    }
  }

  void orient_in_plane() {
    for (TriangleId t = 0; t < way_.size(); ++t) {
      const int turn =
          orient(mesh_.points[mesh_.tri_vertex[3 * t]], mesh_.points[mesh_.tri_vertex[3 * t + 1]],
                 mesh_.points[mesh_.tri_vertex[3 * t + 2]]);
      if (turn == 0) continue;
      way_[t] = turn > 0 ? Way::kAsGiven : Way::kTurned;
      queue_.push_back(t);
    }
    if (queue_.size() == way_.size()) return;
    spread(0);
    for (TriangleId t = 0; t < way_.size(); ++t) start_component(t);  // those without any area
  }

  void orient_on_surface() {
    for (TriangleId t = 0; t < way_.size(); ++t) start_component(t);
  }

  void start_component(TriangleId first) {
    if (way_[first] != Way::kUnknown) return;
    const std::size_t begin = queue_.size();
    way_[first] = Way::kAsGiven;
    queue_.push_back(first);
    spread(begin);
    std::size_t faces = 0, turned = 0;
    for (const TriangleId t : std::span(queue_).subspan(begin)) {
      if (!counts(t)) continue;
      ++faces;
      turned += way_[t] == Way::kTurned ? 1 : 0;
    }
    if (2 * turned <= faces) return;
    for (const TriangleId t : std::span(queue_).subspan(begin)) way_[t] = opposite(way_[t]);
  }

  void check_sides() const {
    for (HalfedgeId h = 0; h < other_.size(); ++h) {
      if (other_[h] == kNone || other_[h] < h) continue;
      if (same_way(h) == (way_[triangle_of(h)] != way_[triangle_of(other_[h])])) continue;
      work_.refuse_edge(mesh_.origin(h), mesh_.target(h),
                        work_.out.space == Space::kPlane
                            ? "has two faces on one side"
                            : "cannot have its faces on two sides: the surface has one side only");
    }
  }

  /// A planar mesh that is clockwise as a whole has no face that turns the other way.
  void refuse_turned() {
    std::size_t turned = 0, faces = 0;
    for (TriangleId t = 0; t < way_.size(); ++t) {
      if (!counts(t)) continue;
      ++faces;
      turned += way_[t] == Way::kTurned ? 1 : 0;
    }
    work_.out.turned_faces = turned;
    if (work_.repairs() || turned == 0 || turned == faces) return;
    const Way odd_one = 2 * turned <= faces ? Way::kTurned : Way::kAsGiven;
    const auto t = std::ranges::find(way_, odd_one) - way_.begin();
    work_.refuse_face(work_.out.source_face[static_cast<std::size_t>(t)],
                      "turns the other way than its neighbours");
  }

  //     c                     c
  //   2/ \1  halfedges      0/ \1     the same triangle turned: the first and the last halfedge
  //   a---b  0 1 2          a---b     change places
  //     0                     2
  HalfedgeId moved(HalfedgeId h) const {
    return h == kNone || way_[triangle_of(h)] != Way::kTurned ? h : 3 * triangle_of(h) + 2 - h % 3;
  }

  void turn_triangles() {
    mesh_.twin.resize(other_.size());
    for (HalfedgeId h = 0; h < other_.size(); ++h) mesh_.twin[moved(h)] = moved(other_[h]);
    for (TriangleId t = 0; t < way_.size(); ++t) {
      if (way_[t] != Way::kTurned) continue;
      std::swap(mesh_.tri_vertex[3 * t + 1], mesh_.tri_vertex[3 * t + 2]);
      HalfedgeId& pair = work_.out.triangles.given_pair[t];
      pair = moved(pair);
    }
  }

  Connecting& work_;
  Triangulation& mesh_;
  std::span<const HalfedgeId> other_;
  std::vector<Way> way_;
  std::vector<TriangleId> queue_;
};

}  // namespace

void orient_faces(Connecting& work, std::span<const HalfedgeId> other) {
  Orienting(work, other).run();
}

}  // namespace quadloom::kernel
