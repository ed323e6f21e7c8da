// Steps 3 to 6 of the algorithm in delaunay.cpp.
#include "kernel/delaunay_builder.hpp"

#include <algorithm>
#include <utility>

#include "kernel/delaunay_ranges.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

/// Of more points, rounds of more than so many are cut into ranges.
constexpr std::size_t kManyPoints = std::size_t{1} << 16;
constexpr std::size_t kManyInRound = std::size_t{1} << 15;
constexpr std::size_t kFirst = 3;  // the first triangle's are there before the rounds

}  // namespace

bool DelaunayBuilder::build() {
  InsertionOrder order = insertion_order(mesh_.ghost);
  if (!first_triangle(order)) return false;
  DelaunayInserter inserter(mesh_);
  for (std::size_t r = 0; r + 1 < order.round_begin.size(); ++r) {
    insert_round(order, order.round_begin[r], order.round_begin[r + 1], inserter);
  }
  drop_ghosts();
  return true;
}

// The first two points and the first that is not on their line, moved to the front; the rounds that
// it moves through begin one later. Around the triangle its three ghosts:
//
//            3       c       2        ghost 1 + i lies beyond edge i; its edge 0 is that edge's
//                   / \               twin, edges 1 and 2 lead to infinity
//                  / 0 \              .
//                 a-----b
//                    1
bool DelaunayBuilder::first_triangle(InsertionOrder& order) {
  const std::span<std::uint32_t> p = order.point;
  std::size_t k = 2;
  int turn = 0;
  for (; k < p.size(); ++k) {
    turn = orient(mesh_.points[p[0]], mesh_.points[p[1]], mesh_.points[p[k]]);
    if (turn != 0) break;
  }
  if (turn == 0) return false;
  std::rotate(&p[2], &p[k], &p[k] + 1);
  for (std::size_t& begin : order.round_begin) {
    if (begin <= k) begin = std::max(begin + 1, kFirst);
  }
  if (turn < 0) std::swap(p[0], p[1]);
  const std::uint32_t a = p[0], b = p[1], c = p[2], inf = mesh_.ghost;
  DelaunayMesh::Triangle* const t = mesh_.triangles.get();
  t[0] = {{a, b, c, a}, {4, 8, 12}, 0};
  t[1] = {{b, a, inf, b}, {0, 14, 9}, 0};
  t[2] = {{c, b, inf, c}, {1, 6, 13}, 0};
  t[3] = {{a, c, inf, a}, {2, 10, 5}, 0};
  return true;
}

void DelaunayBuilder::insert_round(const InsertionOrder& order, std::size_t begin, std::size_t end,
                                   DelaunayInserter& inserter) {
  if (mesh_.ghost > kManyPoints && end - begin > kManyInRound) {
    put_off_ += insert_in_ranges(mesh_, order, begin, end, inserter);
    return;
  }
  for (std::size_t i = begin; i < end; ++i) {
    inserter.insert(order.point[i], DelaunayMesh::triangles_of(i));
  }
}

// Cuts the ghosts off and closes the gaps with the last triangles.
void DelaunayBuilder::drop_ghosts() {
  DelaunayMesh::Triangle* const triangles = mesh_.triangles.get();
  const std::vector<std::uint32_t> ghosts = mark_ghosts();
  std::size_t from = DelaunayMesh::triangles_of(mesh_.ghost);
  const std::size_t kept = from - ghosts.size();
  for (const std::uint32_t gap : ghosts) {
    if (gap >= kept) continue;
    do {
      --from;
    } while (mesh_.is_ghost(triangles[from]));
    triangles[gap] = triangles[from];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const DelaunayMesh::Edge e = triangles[gap].twin[i];
      if (e != kNone) triangles[e >> 2].twin[e & 3U] = gap << 2 | i;
    }
  }
  triangle_count_ = kept;
}

// The ghosts, found by going around the hull; the twins that lead to them become kNone.
std::vector<std::uint32_t> DelaunayBuilder::mark_ghosts() {
  DelaunayMesh::Triangle* const triangles = mesh_.triangles.get();
  std::uint32_t at = 0;
  while (!mesh_.is_ghost(triangles[at])) ++at;
  std::vector<std::uint32_t> ghosts;
  const std::uint32_t start = at;
  do {
    ghosts.push_back(at);
    const DelaunayMesh::Triangle& t = triangles[at];
    const std::uint32_t infinity = t.v[0] == mesh_.ghost ? 0 : t.v[1] == mesh_.ghost ? 1 : 2;
    const DelaunayMesh::Edge inside = t.twin[DelaunayMesh::next(infinity)];
    triangles[inside >> 2].twin[inside & 3U] = kNone;
    at = t.twin[infinity] >> 2;
  } while (at != start);
  return ghosts;
}

}  // namespace quadloom::kernel
