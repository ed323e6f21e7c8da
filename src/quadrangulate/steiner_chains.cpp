#include "quadrangulate/steiner_chains.hpp"

#include <cmath>
#include <queue>

#include "kernel/point_on_segment.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/odd_boundary.hpp"

namespace quadloom::quadrangulate {
namespace {

/// Strictly inside the triangle, and in strict angular order around c.
bool is_chain(Point a, Point b, Point c, const std::vector<Point>& chain) {
  const int side = orient2d(a, b, c);
  Point before = a;
  for (const Point& p : chain) {
    if (orient2d(a, b, p) != side || orient2d(c, before, p) != side) return false;
    before = p;
  }
  return orient2d(c, before, b) == side;
}

double length(Point a, Point b) { return std::hypot(b.x / 2 - a.x / 2, b.y / 2 - a.y / 2); }

/// A piece of the boundary between two consecutive vertices, and the hull edge it came from.
struct Piece {
  double length;
  VertexId from, to;
  std::pair<VertexId, VertexId> edge;
  bool operator<(const Piece& other) const {
    return length != other.length ? length < other.length : from > other.from;
  }
};

class HullPoints {
 public:
  HullPoints(std::span<const VertexId> hull, std::vector<Point>& points, OddBoundary wish)
      : points_(points), wish_(wish), next_(points.size(), kNone), previous_(points.size(), kNone) {
    for (std::size_t i = 0; i < hull.size(); ++i) link(hull[i], hull[(i + 1) % hull.size()]);
  }

  void allow(std::pair<VertexId, VertexId> edge) {
    push(first_choice_, edge.first, edge.second, edge);
  }

  void add_one(std::vector<SteinerPoint>& steiner) {
    const SteinerKind wished =
        wish_ == OddBoundary::kOnEdge ? SteinerKind::kOnEdge : SteinerKind::kOutside;
    while (!first_choice_.empty()) {
      const Piece piece = pop(first_choice_);
      const auto odd = place(piece);
      if (odd && odd->kind == wished) return insert(piece, *odd, steiner);
      if (odd) second_choice_.push(piece);
    }
    while (!second_choice_.empty()) {
      const Piece piece = pop(second_choice_);
      if (const auto odd = place(piece)) return insert(piece, *odd, steiner);
    }
    throw Error(ErrorCode::kGuarantee, "no place is left on the hull for the points to add");
  }

  /// The vertices added between the ends of a hull edge.
  std::vector<VertexId> chain(std::pair<VertexId, VertexId> edge) const {
    std::vector<VertexId> out;
    for (VertexId v = next_[edge.first]; v != edge.second; v = next_[v]) out.push_back(v);
    return out;
  }

 private:
  using Queue = std::priority_queue<Piece>;

  void link(VertexId a, VertexId b) {
    next_[a] = b;
    previous_[b] = a;
  }
  void push(Queue& queue, VertexId a, VertexId b, std::pair<VertexId, VertexId> edge) {
    queue.push({length(points_[a], points_[b]), a, b, edge});
  }
  static Piece pop(Queue& queue) {
    const Piece piece = queue.top();
    queue.pop();
    return piece;
  }
  std::optional<OddPlace> place(const Piece& piece) const {
    return place_odd_point(points_[previous_[piece.from]], points_[piece.from], points_[piece.to],
                           points_[next_[piece.to]], wish_);
  }
  void insert(const Piece& piece, const OddPlace& odd, std::vector<SteinerPoint>& steiner) {
    const auto s = static_cast<VertexId>(points_.size());
    points_.push_back(odd.place);
    next_.push_back(kNone);
    previous_.push_back(kNone);
    link(piece.from, s);
    link(s, piece.to);
    push(first_choice_, piece.from, s, piece.edge);
    push(first_choice_, s, piece.to, piece.edge);
    steiner.push_back({s, odd.kind, {piece.edge.first, piece.edge.second, kNone}});
  }

  std::vector<Point>& points_;
  OddBoundary wish_;
  std::vector<VertexId> next_, previous_;
  Queue first_choice_, second_choice_;
};

}  // namespace

std::optional<std::vector<Point>> chain_on_segment(Point a, Point b, std::size_t count) {
  std::vector<Point> chain = {a, b};
  std::vector<char> full = {0};  // the piece from chain[i] to chain[i + 1] has no double in it
  while (chain.size() < count + 2) {
    std::size_t longest = full.size();
    for (std::size_t i = 0; i < full.size(); ++i) {
      const bool longer = longest == full.size() || length(chain[i], chain[i + 1]) >
                                                        length(chain[longest], chain[longest + 1]);
      if (!full[i] && longer) longest = i;
    }
    if (longest == full.size()) return std::nullopt;
    const auto i = static_cast<std::ptrdiff_t>(longest);
    if (const auto p = kernel::point_on_segment(chain[longest], chain[longest + 1])) {
      chain.insert(chain.begin() + i + 1, *p);
      full.insert(full.begin() + i, 0);
    } else {
      full[longest] = 1;
    }
  }
  return std::vector<Point>(chain.begin() + 1, chain.end() - 1);
}

std::optional<std::vector<Point>> chain_in_triangle(Point a, Point b, Point c, std::size_t count) {
  constexpr int kHalvings = 50;
  for (int k = 2; k <= kHalvings; ++k) {
    const double lift = std::ldexp(1.0, -k);
    std::vector<Point> chain(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double along = static_cast<double>(i + 1) / static_cast<double>(count + 1);
      const double wa = (1 - lift) * (1 - along), wb = (1 - lift) * along;
      chain[i] = {wa * a.x + wb * b.x + lift * c.x, wa * a.y + wb * b.y + lift * c.y};
    }
    if (is_chain(a, b, c, chain)) return chain;
  }
  return chain_on_segment(a, b, count);
}

void add_hull_points(std::span<const VertexId> hull,
                     std::span<const std::pair<VertexId, VertexId>> edges, std::size_t count,
                     OddBoundary wish, std::vector<Point>& points, EdgeChains& chains,
                     std::vector<SteinerPoint>& steiner) {
  if (count == 0) return;
  HullPoints ring(hull, points, wish);
  for (const auto& edge : edges) ring.allow(edge);
  for (std::size_t i = 0; i < count; ++i) ring.add_one(steiner);
  for (const auto& edge : edges) chains[edge] = ring.chain(edge);
}

}  // namespace quadloom::quadrangulate
