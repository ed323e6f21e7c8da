// The empty faces of a few points, from the signs of their triples alone.
//
//   1. find_turns    the exact sign of every triple
//   2. find_edges    segments without a point between their ends, and which of them cross. Two that
//                    share a line can then have no more than an end in common
//   3. add_faces_at  per directed segment the quads and triangles on its left
//
//        c                    A cycle of four such segments is simple if no two of them cross: where
//       / `.  d               neighbours lay on each other, one would have a point inside. It is
//      /     `.`.             counter-clockwise if it turns left at the first of its corners in
//     a         `.`.          lexicographic order. At most one corner is reflex or flat, and the
//       ` - .. _   `b         diagonal from there is inside (if there is none, both are); its two
//               ` -           triangles tell whether a point is inside.
//
// A segment that meets the inside of an empty quad crosses one of its sides or is a diagonal, since it
// has no corner between its ends: `apart` is exactly the segments that no mesh with this face has.
#include "convex/empty_faces.hpp"

#include <algorithm>

#include "quadloom/kernel.hpp"

namespace quadloom::convex {

EmptyFaces::EmptyFaces(std::span<const Point> points) : n_(points.size()) {
  find_turns(points);
  find_edges();
  for (std::size_t a = 0; a < kMostExactPoints; ++a) {
    for (std::size_t b = 0; b < kMostExactPoints; ++b) {
      if (a < n_ && b < n_ && a != b && is_edge(a, b)) add_faces_at(a, b);
      begin_[a * kMostExactPoints + b + 1] = static_cast<std::uint32_t>(faces_.size());
    }
  }
}

void EmptyFaces::find_turns(std::span<const Point> points) {
  for (std::size_t a = 0; a < n_; ++a) {
    for (std::size_t b = 0; b < n_; ++b) {
      for (std::size_t c = 0; c < n_; ++c) {
        turn_[(a * kMostExactPoints + b) * kMostExactPoints + c] =
            static_cast<std::int8_t>(orient2d(points[a], points[b], points[c]));
      }
    }
  }
}

void EmptyFaces::find_edges() {
  const auto has_point_between = [&](std::size_t a, std::size_t b) {
    for (std::size_t p = a + 1; p < b; ++p) {  // on a line the order is that of the indices
      if (turn(a, b, p) == 0) return true;
    }
    return false;
  };
  for (std::size_t b = 1; b < n_; ++b) {
    for (std::size_t a = 0; a < b; ++a) edges_[edge(a, b)] = !has_point_between(a, b);
  }
  across_.resize(edges_.size());
  for (std::size_t b = 1; b < n_; ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      for (std::size_t d = 1; d < n_; ++d) {
        for (std::size_t c = 0; c < d; ++c) {
          if (crossing(a, b, c, d)) across_[edge(a, b)].set(edge(c, d));
        }
      }
    }
  }
}

bool EmptyFaces::crossing(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// In the closed triangle, which turns left.
bool EmptyFaces::in_triangle(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

void EmptyFaces::add_faces_at(std::size_t a, std::size_t b) {
  for (const bool convex : {true, false}) {
    for (std::size_t c = 0; c < n_; ++c) {
      if (c == a || c == b || !is_edge(b, c)) continue;
      for (std::size_t d = 0; d < n_; ++d) {
        if (d != a && d != b && d != c && is_edge(c, d) && is_edge(d, a)) {
          add_quad(a, b, c, d, convex);
        }
      }
    }
  }
  for (std::size_t c = 0; c < n_; ++c) {
    if (c != a && c != b && is_edge(b, c) && is_edge(c, a)) add_triangle(a, b, c);
  }
}

void EmptyFaces::add_quad(std::size_t a, std::size_t b, std::size_t c, std::size_t d, bool convex) {
  if (crossing(a, b, c, d) || crossing(b, c, d, a)) return;
  const std::array<std::size_t, 4> q = {a, b, c, d};
  const auto first = static_cast<std::size_t>(std::min_element(q.begin(), q.end()) - q.begin());
  if (turn(q[(first + 3) % 4], q[first], q[(first + 1) % 4]) <= 0) return;

  std::array<int, 4> turns{};
  for (std::size_t i = 0; i < 4; ++i) turns[i] = turn(q[(i + 3) % 4], q[i], q[(i + 1) % 4]);
  const bool all_left = std::all_of(turns.begin(), turns.end(), [](int t) { return t > 0; });
  if (all_left != convex) return;
  const std::size_t k = turns[1] > 0 && turns[3] > 0 ? 0 : 1;  // the diagonal k, k + 2 is inside
  const std::size_t u = q[k], v = q[k + 1], w = q[k + 2], x = q[(k + 3) % 4];
  for (std::size_t p = 0; p < n_; ++p) {
    const bool corner = p == a || p == b || p == c || p == d;
    if (!corner && (in_triangle(u, v, w, p) || in_triangle(u, w, x, p))) return;
  }

  EmptyFace face;
  for (std::size_t i = 0; i < 4; ++i) face.corner[i] = static_cast<std::uint8_t>(q[i]);
  face.convex = convex;
  face.apart.set(edge(u, w));
  if (convex) face.apart.set(edge(v, x));
  add(face);
}

void EmptyFaces::add_triangle(std::size_t a, std::size_t b, std::size_t c) {
  if (turn(a, b, c) <= 0) return;
  for (std::size_t p = 0; p < n_; ++p) {
    if (p != a && p != b && p != c && in_triangle(a, b, c, p)) return;
  }
  EmptyFace face;
  face.corner = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                 static_cast<std::uint8_t>(c), 0};
  face.triangle = true;
  add(face);
}

void EmptyFaces::add(EmptyFace face) {
  const std::size_t size = face.size();
  for (std::size_t i = 0; i < size; ++i) {
    face.apart |= across_[edge(face.corner[i], face.corner[(i + 1) % size])];
  }
  faces_.push_back(face);
}

}  // namespace quadloom::convex
