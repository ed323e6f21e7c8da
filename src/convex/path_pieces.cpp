// Pieces of a path of triangles (Bose and Toussaint's spiral): which there are, what each becomes, and the
// cheapest way to cut the path into them.
//
//   two triangles that are a strictly convex quad      no point
//   two triangles that are not                         4 points
//   four triangles, the union of two quads             at most 3
//   three, with a point on their boundary              at most 3, see points_convex_pentagons.cpp
//   one triangle                                       if their number is odd
//
// Four triangles are a hexagon, a quad with a point inside, or a hexagon in which two corners are the
// same point, where the path has gone around a triangle (triangles ABD, BED, BCE, CAE around ADE):
//
//                C                     The search for a hexagon's quads does not mind, see hexagon.cpp.
//              / | \                   If no doubles are found for a piece, its quads stay as they are,
//            /   E   \                 at a cost that the plan avoids if it can, and the result says so.
//          /  / /  \ -- \              Cost: linear in the path.
//         A ----- D ----- B
#include "convex/path_pieces.hpp"

#include <algorithm>
#include <utility>

#include "convex/hexagon.hpp"
#include "convex/quad.hpp"
#include "quadloom/kernel.hpp"
#include "quadrangulate/odd_boundary.hpp"

namespace quadloom::convex {

using quadrangulate::Replaced;

namespace {

constexpr std::uint64_t kPerStay = std::uint64_t{1} << 32;  // cost of a quad that is not convex

struct OuterPlace {
  VertexId start = kNone;  // of the hull edge
  std::optional<Point> place;
};

OuterPlace choose_start(const std::vector<Point>& points, std::span<const VertexId> hull,
                        OddBoundary odd) {
  const std::size_t h = hull.size();
  if (h % 2 == 0 || odd == OddBoundary::kTriangle) return {};
  for (std::size_t i = 0; i < h; ++i) {
    const auto place =
        quadrangulate::place_outside(points[hull[(i + h - 1) % h]], points[hull[i]],
                                     points[hull[(i + 1) % h]], points[hull[(i + 2) % h]]);
    if (place) return {hull[i], place};
  }
  return {};
}

void add_outer_point(const Serpentine& path, Point place, ConvexResult& result) {
  const auto s = static_cast<VertexId>(result.mesh.points.size());
  result.mesh.points.push_back(place);
  result.mesh.quad_vertex = {path.outer(0), s, path.inner(0), path.apex(0)};
  result.steiner.push_back({s, SteinerKind::kOutside, {path.outer(0), path.inner(0), kNone}});
}

/// The boundary of a run of triangles of the path, counter-clockwise: the ends of the diagonals on the
/// inner side, the last apex, the ends on the outer side backwards.
template <std::size_t N>
std::array<VertexId, N> union_of(const Serpentine& path, std::size_t first) {
  std::array<VertexId, N> ring{};
  constexpr std::size_t kTriangles = N - 2;
  std::size_t front = 0, back = N;
  ring[--back] = path.outer(first);
  ring[front++] = path.inner(first);
  for (std::size_t t = first; t + 1 < first + kTriangles; ++t) {
    const bool outer = path.replaced(t) == Replaced::kOuter;
    ring[outer ? --back : front++] = path.apex(t);
  }
  ring[front] = path.apex(first + kTriangles - 1);
  return ring;
}

/// The ring, and the places of its corners, with the point s between a and b.
template <std::size_t N>
std::pair<std::array<VertexId, N + 1>, std::array<Point, N + 1>> with_point(
    const std::array<VertexId, N>& ring, const std::array<Point, N>& at, VertexId a, VertexId b,
    Point s, VertexId name) {
  std::array<VertexId, N + 1> longer;
  std::array<Point, N + 1> places;
  std::size_t to = 0;
  for (std::size_t k = 0; k < N; ++k) {
    longer[to] = ring[k];
    places[to++] = at[k];
    if (ring[k] != a || ring[(k + 1) % N] != b) continue;
    longer[to] = name;
    places[to++] = s;
  }
  return {longer, places};
}

std::size_t triangles_of(Piece piece) {
  return piece == Piece::kTriangle ? 1 : piece == Piece::kPair ? 4 : 2;
}

/// The cheapest pieces of the triangles first .. end - 1. After i of them the number of single triangles
/// so far is i mod 2, since there is at most one.
class Plan {
 public:
  Plan(const Pieces& pieces, std::size_t first, std::size_t end, const Progress& progress)
      : pieces_(pieces),
        first_(first),
        size_(end - first),
        cost_(size_ + 1, kUnreached),
        last_(size_ + 1, Piece::kNone) {
    cost_[0] = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (i % 65536 == 0) {
        report_progress(progress, "convex quads",
                        static_cast<double>(i) / static_cast<double>(size_));
      }
      if (cost_[i] != kUnreached) extend(i);
    }
  }

  /// In the order of the path.
  std::vector<Piece> pieces() const {
    std::vector<Piece> out;
    for (std::size_t i = size_; i > 0; i -= triangles_of(last_[i])) out.push_back(last_[i]);
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  static constexpr std::uint64_t kUnreached = ~std::uint64_t{0};

  void extend(std::size_t i) {
    const std::size_t t = first_ + i;
    const bool triangle_left = (size_ - i) % 2 == 1;
    if (triangle_left) offer(i, Piece::kTriangle, 0);
    if (i + 2 > size_) return;
    const bool convex = pieces_.quad_is_convex(t);
    if (convex) offer(i, Piece::kConvexQuad, 0);
    if (i + 4 <= size_ && !(convex && pieces_.quad_is_convex(t + 2))) {
      const auto found = pieces_.patch_of_pair(t);
      if (found.patch) offer(i, Piece::kPair, found.patch->steiner.size());
    }
    if (convex || cost_[i] + 4 >= cost_[i + 2]) return;
    if (pieces_.patch_of_quad(t).patch) offer(i, Piece::kLoneQuad, 4);
    if (cost_[i + 2] == kUnreached) offer(i, Piece::kStay, kPerStay);
  }

  void offer(std::size_t i, Piece piece, std::uint64_t points) {
    const std::size_t end = i + triangles_of(piece);
    if (cost_[i] + points >= cost_[end]) return;
    cost_[end] = cost_[i] + points;
    last_[end] = piece;
  }

  const Pieces& pieces_;
  std::size_t first_;
  std::size_t size_;
  std::vector<std::uint64_t> cost_;
  std::vector<Piece> last_;  // the piece that ends there
};

}  // namespace

bool Pieces::quad_is_convex(std::size_t t) const {
  const auto ring = union_of<4>(path_, t);
  const auto at = [&](std::uint32_t i) { return Corner{points_[ring[i]], i}; };
  return strictly_convex(at(0), at(1), at(2), at(3));
}

Pieces::Found Pieces::patch_of_quad(std::size_t t) const {
  const auto ring = union_of<4>(path_, t);
  return {{ring.begin(), ring.end()}, patch_quad(places_of(ring))};
}

// A corner between two equal ones is inside of the union:
//
//   x === y      the path turns around y, and comes back to the edge x y
Pieces::Found Pieces::patch_of_pair(std::size_t t) const {
  const auto ring = union_of<6>(path_, t);
  for (std::size_t k = 0; k < 6; ++k) {
    if (ring[k] != ring[(k + 2) % 6]) continue;
    const std::array<VertexId, 4> quad = {ring[k], ring[(k + 3) % 6], ring[(k + 4) % 6],
                                          ring[(k + 5) % 6]};
    const VertexId inner = ring[(k + 1) % 6];
    return {{quad[0], quad[1], quad[2], quad[3], inner},
            patch_quad_with_point(places_of(quad), points_[inner])};
  }
  return {{ring.begin(), ring.end()}, patch_hexagon(places_of(ring))};
}

// With s the pentagon is a hexagon, whose corner s is flat (or nearly). Where the three triangles go
// all the way around a point, it is inside of a triangle, with s a quad.
Pieces::Found Pieces::patch_of_pentagon(std::size_t t, VertexId a, VertexId b, Point s,
                                        VertexId name) const {
  const auto five = union_of<5>(path_, t);
  for (std::size_t k = 0; k < 5; ++k) {
    if (five[k] != five[(k + 2) % 5]) continue;
    const std::array<VertexId, 3> triangle = {five[k], five[(k + 3) % 5], five[(k + 4) % 5]};
    const VertexId inner = five[(k + 1) % 5];
    const auto [quad, at] = with_point(triangle, places_of(triangle), a, b, s, name);
    return {{quad[0], quad[1], quad[2], quad[3], inner}, patch_quad_with_point(at, points_[inner])};
  }
  const auto [hexagon, at] = with_point(five, places_of(five), a, b, s, name);
  return {{hexagon.begin(), hexagon.end()}, patch_hexagon(at)};
}

std::vector<Piece> cheapest_pieces(const Pieces& pieces, std::size_t first, std::size_t end,
                                   const Progress& progress) {
  return Plan(pieces, first, end, progress).pieces();
}

void PathBuilder::build(std::size_t first, std::span<const Piece> plan) {
  std::size_t t = first;
  for (const Piece piece : plan) {
    add(piece, t);
    t += triangles_of(piece);
  }
}

void PathBuilder::add(Piece piece, std::size_t t) {
  if (piece == Piece::kTriangle) {
    result_.mesh.tri_vertex = {path_.outer(t), path_.inner(t), path_.apex(t)};
  } else if (piece == Piece::kPair) {
    add_patch(pieces_.patch_of_pair(t), t, 4);
  } else if (piece == Piece::kLoneQuad) {
    add_patch(pieces_.patch_of_quad(t), t, 2);
  } else {
    if (piece == Piece::kStay) {
      result_.not_convex.push_back(static_cast<QuadId>(result_.mesh.quad_count()));
    } else {
      ++result_.statistics.kept;
    }
    for (const VertexId v : union_of<4>(path_, t)) result_.mesh.quad_vertex.push_back(v);
  }
}

void PathBuilder::add_patch(Pieces::Found found, std::size_t t, std::size_t triangles) {
  for (const Point s : found.patch->steiner) {
    const auto vertex = static_cast<VertexId>(result_.mesh.points.size());
    found.vertices.push_back(vertex);
    result_.mesh.points.push_back(s);
    result_.steiner.push_back({vertex, SteinerKind::kInner, triangle_around(s, t, triangles)});
  }
  for (const LocalQuad& q : found.patch->quads) {
    for (const std::uint32_t v : q) result_.mesh.quad_vertex.push_back(found.vertices[v]);
  }
  ++result_.statistics.patches;
  ++result_.statistics.patches_by_points[found.patch->steiner.size()];
}

std::array<VertexId, 3> PathBuilder::triangle_around(Point s, std::size_t t,
                                                     std::size_t triangles) const {
  std::array<VertexId, 3> corners{};
  for (std::size_t i = t; i < t + triangles; ++i) {
    corners = {path_.outer(i), path_.inner(i), path_.apex(i)};
    const auto& p = result_.mesh.points;
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      inside = inside && kernel::orient(p[corners[k]], p[corners[(k + 1) % 3]], s) >= 0;
    }
    if (inside) break;
  }
  return corners;
}

PathOfPoints path_of_points(const std::vector<Point>& points, const ConvexOptions& options) {
  const ConvexLayers layers = convex_layers(points, options.progress);
  const OuterPlace outer = choose_start(points, layers.layer(0), options.odd_boundary);
  report_progress(options.progress, "spiral", 0);
  PathOfPoints out;
  out.path = quadrangulate::make_serpentine(points, layers, outer.start);

  out.result.input_vertices = points.size();
  out.result.statistics.hull_points = layers.layer(0).size();
  out.result.mesh.points = points;
  if (outer.place) {
    add_outer_point(out.path, *outer.place, out.result);
    out.first = 1;
  }
  return out;
}

}  // namespace quadloom::convex
