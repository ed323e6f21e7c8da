// Pieces of a path of triangles that become strictly convex quads, each by itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "convex/patch.hpp"
#include "quadloom/convex.hpp"
#include "quadrangulate/serpentine.hpp"

namespace quadloom::convex {

using quadrangulate::Serpentine;

/// A run of triangles of the path, and what becomes of it.
enum class Piece : std::uint8_t { kNone, kTriangle, kConvexQuad, kLoneQuad, kPair, kStay };

/// The patches of the pieces of a path.
class Pieces {
 public:
  Pieces(const std::vector<Point>& points, const Serpentine& path) : points_(points), path_(path) {}

  struct Found {
    std::vector<VertexId> vertices;  // of the patch's numbers, without Steiner points
    std::optional<Patch> patch;
  };

  /// Triangles t and t + 1.
  bool quad_is_convex(std::size_t t) const;
  Found patch_of_quad(std::size_t t) const;
  /// Triangles t to t + 3.
  Found patch_of_pair(std::size_t t) const;
  /// Triangles t to t + 2 with the point s, to be vertex `name`, on (or by) their boundary's edge a b.
  Found patch_of_pentagon(std::size_t t, VertexId a, VertexId b, Point s, VertexId name) const;

 private:
  template <std::size_t N>
  std::array<Point, N> places_of(const std::array<VertexId, N>& ring) const {
    std::array<Point, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = points_[ring[i]];
    return out;
  }

  const std::vector<Point>& points_;
  const Serpentine& path_;
};

/// Those pieces of the triangles first .. end - 1 with the fewest added points in all, in the order of the
/// path. A single triangle is among them if their number is odd.
std::vector<Piece> cheapest_pieces(const Pieces& pieces, std::size_t first, std::size_t end,
                                   const Progress& progress);

/// Adds the quads and Steiner points of pieces to a result.
class PathBuilder {
 public:
  PathBuilder(const Serpentine& path, const Pieces& pieces, ConvexResult& result)
      : path_(path), pieces_(pieces), result_(result) {}

  void build(std::size_t first, std::span<const Piece> plan);
  /// A patch that is inside of that many triangles from triangle t on.
  void add_patch(Pieces::Found found, std::size_t t, std::size_t triangles);

 private:
  void add(Piece piece, std::size_t t);
  std::array<VertexId, 3> triangle_around(Point s, std::size_t t, std::size_t triangles) const;

  const Serpentine& path_;
  const Pieces& pieces_;
  ConvexResult& result_;
};

/// The path of triangles of a point set, and a place outside the hull for the first one to be made a quad
/// with, if the number of points on the hull is odd and that is wished for and possible.
struct PathOfPoints {
  Serpentine path;
  std::size_t first = 0;  ///< the triangle after that quad
  ConvexResult result;    ///< with that quad and its Steiner point, or without quads
};
PathOfPoints path_of_points(const std::vector<Point>& points, const ConvexOptions& options);

}  // namespace quadloom::convex
