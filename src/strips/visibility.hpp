// What the corners of a polygon see of each other.
#pragma once

#include <vector>

#include "strips/polygon_disc.hpp"

namespace quadloom::strips {

/// How a corner is seen from another that is not its neighbour on the boundary.
enum class Sight : std::uint8_t {
  kChord,       ///< the open segment is inside: it may be an edge of a triangulation
  kPastBefore,  ///< the segment touches corners (or runs along sides), all of them before the one that
                ///< is seen, counted counter-clockwise from the one that looks
  kPastAfter,  ///< the same, all of them after it
};

struct Seen {
  Position position = 0;
  Sight sight = Sight::kChord;
};

/// Looks from one corner at a time.
class Visibility {
 public:
  explicit Visibility(const PolygonDisc& disc) : disc_(disc) {}

  /// What `from` sees, counter-clockwise from it; its two neighbours are left out. Valid until the next
  /// call. Linear in the triangles that it sees any part of.
  const std::vector<Seen>& look_from(Position from);

  /// Triangles looked into so far, a measure of the work done.
  std::size_t work() const { return work_; }

 private:
  /// A halfedge that is looked through, between the directions to two points on its two ends' sides;
  /// or, with halfedge = kNone, something that has been seen and is to be told.
  struct Window {
    HalfedgeId halfedge = kNone;
    VertexId right = kNone;
    VertexId left = kNone;
    Seen seen = {};
  };

  void look_through(Point eye, const Window& window);

  const PolygonDisc& disc_;
  std::vector<Seen> seen_;
  std::vector<Window> open_;
  std::size_t work_ = 0;
};

/// All chords, from either end: those of corner i are other[begin[i] .. begin[i + 1]),
/// counter-clockwise from i.
struct VisibilityGraph {
  std::vector<std::size_t> begin = {0};
  std::vector<Position> other;
};

VisibilityGraph visibility_graph(const PolygonDisc& disc);

}  // namespace quadloom::strips
