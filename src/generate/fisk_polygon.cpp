// The polygon that needs n / 3 outer Steiner points.
#include <algorithm>

#include "generate/polygons.hpp"

namespace quadloom::generate {

// Figure 2.1 of Ramaswami, Ramos and Toussaint (1995): one triangulation, a third of whose triangles
// stays over in every matching.
//
//                 v1
//                /  .
//              /      .           v1 sees the corners of a hill, and they see no other corner than their
//            /   v5 v6  .         neighbours and v1. On every other edge of the hill stands a tooth
//          /  v3'--'--._  .       downwards, aslant, so that its tip sees the corners of that edge alone
//        /  ,'   \ |    v8 .      and, past them, nothing but the edge v1 v2.
//      v2-'       `v4 ...   vn
//
// The hill's corner number j, from -J to J - 1, is (4 j, -2 j^2), so its slope falls from j to j + 1 by -j
// - 1/2 there; the tooth that ends at corner j has its tip at (1, -max(1, j + 1)) from it, which is below
// both edges. From the tip past corner j one passes x = 0 at 4 j max(1, j + 1) - 2 j^2 at most, which is
// below v1 = (0, 4 J^2 + 8 J); so are all edges of the hill.
Polygon make_fisk_polygon(std::size_t n, std::uint64_t) {
  constexpr std::size_t kMostCorners = 90000;  // whole coordinates below 2^32
  const auto half = static_cast<std::int64_t>(std::min(n, kMostCorners) / 3);
  const auto corner = [](std::int64_t j) {
    return Point{4.0 * static_cast<double>(j), -2.0 * static_cast<double>(j * j)};
  };
  const auto size = static_cast<double>(half);
  std::vector<Point> ring = {{0, 4 * size * size + 8 * size}, corner(-half), corner(1 - half)};
  for (std::int64_t j = 2 - half; j < half; j += 2) {
    const Point end = corner(j);
    const auto down = static_cast<double>(std::max<std::int64_t>(1, j + 1));
    ring.push_back({end.x + 1, end.y - down});
    ring.push_back(end);
    ring.push_back(corner(j + 1));
  }
  return {{std::move(ring)}};
}

}  // namespace quadloom::generate
