// Strictly convex quads of a point set (Bremner, Hurtado, Ramaswami and Sacristan, theorem 3.1): a
// path of triangles, paired to quads, the quads paired again and each union cut anew with inner Steiner
// points. At most 3 floor(n / 2) of them.
//
//   1. path_of_points   the path of t = 2n - 2 - h triangles (Bose and Toussaint's spiral); h odd: from a
//                       hull edge with a place outside, for the first triangle, if wished
//   2. cheapest_pieces  the path in pieces (path_pieces.hpp): those with the fewest points in all
//   3. build            each piece's patch
//
// Differs from the paper. It pairs all quads from one end, and quads that are convex as they are with
// them; here a shortest path over the pieces chooses, so that the paper's pairing is one of the choices
// and the bound holds. The paper knows unions of two quads that share one edge (a hexagon) or two (a
// quad with a point inside); for a third kind see path_pieces.cpp.
//
// Cost: O(n log n) for the layers, then O(n).
#include "convex/points_convex_spiral.hpp"

#include <utility>

#include "convex/path_pieces.hpp"

namespace quadloom::convex {

ConvexResult convex_spiral_quadrangulation(const std::vector<Point>& points,
                                           const ConvexOptions& options) {
  PathOfPoints given = path_of_points(points, options);
  const Pieces pieces(points, given.path);
  const auto plan = cheapest_pieces(pieces, given.first, given.path.size(), options.progress);
  PathBuilder(given.path, pieces, given.result).build(given.first, plan);
  return std::move(given.result);
}

}  // namespace quadloom::convex
