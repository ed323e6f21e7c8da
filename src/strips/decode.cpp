// The triangles of a code, whether two lists of triangles are the same, and triangles as they are.
//
// Degenerate input: any sequence of numbers is a code, also one with strips of fewer than three
// vertices; vertices need not exist. Cost: O(n), same_triangles O(n log n).
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "quadloom/strips.hpp"

namespace quadloom {
namespace {

using Corners = std::array<VertexId, 3>;

/// Sorted, each triangle from its smallest corner.
std::vector<Corners> normal_form(std::span<const VertexId> triangles) {
  std::vector<Corners> out;
  out.reserve(triangles.size() / 3);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    Corners t = {triangles[i], triangles[i + 1], triangles[i + 2]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    out.push_back(t);
  }
  std::sort(out.begin(), out.end());
  return out;
}

void check_triangles(std::size_t points, std::span<const VertexId> tri_vertex) {
  if (tri_vertex.size() % 3 != 0) {
    throw Error(ErrorCode::kBadMesh, "triangles need three corners each");
  }
  if (points > kMaxPoints || tri_vertex.size() >= kNone) {
    throw Error(ErrorCode::kTooManyPoints, "more triangles than 32-bit indices can number");
  }
  for (std::size_t i = 0; i < tri_vertex.size(); ++i) {
    if (tri_vertex[i] >= points) {
      throw Error(ErrorCode::kIndexOutOfRange,
                  "triangle " + std::to_string(i / 3) + " names vertex " +
                      std::to_string(tri_vertex[i]) + " of " + std::to_string(points),
                  {i / 3, tri_vertex[i]});
    }
    if (tri_vertex[i] == tri_vertex[i % 3 == 2 ? i - 2 : i + 1]) {
      throw Error(ErrorCode::kBadMesh, "triangle " + std::to_string(i / 3) + " has a corner twice",
                  {i / 3});
    }
  }
}

/// Halfedges by their smaller end, in lists.
class EdgeLists {
 public:
  explicit EdgeLists(const Triangulation& mesh)
      : mesh_(mesh), first_(mesh.points.size(), kNone), next_(mesh.tri_vertex.size()) {
    for (HalfedgeId h = 0; h < next_.size(); ++h) {
      VertexId& first = first_[smaller(h)];
      next_[h] = first;
      first = h;
    }
  }

  /// The only other halfedge of the edge, if it goes the other way; else kNone.
  HalfedgeId twin_of(HalfedgeId h) const {
    const VertexId from = mesh_.origin(h), to = mesh_.target(h);
    HalfedgeId twin = kNone;
    for (HalfedgeId g = first_[smaller(h)]; g != kNone; g = next_[g]) {
      const VertexId a = mesh_.origin(g), b = mesh_.target(g);
      if (g == h || !((a == to && b == from) || (a == from && b == to))) continue;
      if (twin != kNone || a == from) return kNone;
      twin = g;
    }
    return twin;
  }

 private:
  VertexId smaller(HalfedgeId h) const { return std::min(mesh_.origin(h), mesh_.target(h)); }

  const Triangulation& mesh_;
  std::vector<HalfedgeId> first_, next_;
};

}  // namespace

std::vector<VertexId> decode_strips(const StripCode& code) {
  const bool with_swaps = code.encoding == StripEncoding::kSwap;
  if (code.swap.size() != (with_swaps ? code.index.size() : 0)) {
    throw Error(ErrorCode::kBadOption, with_swaps ? "a code with swaps needs one bit an index"
                                                  : "only the encoding with swaps has bits");
  }
  const bool restarts = code.encoding != StripEncoding::kRepeat;
  std::vector<VertexId> triangles;
  triangles.reserve(3 * code.index.size());
  VertexId before = kNone, last = kNone;
  std::size_t sent = 0;  // of this strip
  bool odd = false;
  for (std::size_t i = 0; i < code.index.size(); ++i) {
    const VertexId v = code.index[i];
    if (restarts && v == kStripRestart) {
      sent = 0;
      odd = false;
      continue;
    }
    if (sent >= 2) {
      if (with_swaps && code.swap[i] != 0) {
        std::swap(before, last);
        odd = !odd;
      }
      if (before != last && before != v && last != v) {
        if (odd) {
          triangles.insert(triangles.end(), {last, before, v});
        } else {
          triangles.insert(triangles.end(), {before, last, v});
        }
      }
      odd = !odd;
    }
    ++sent;
    before = std::exchange(last, v);
  }
  return triangles;
}

bool same_triangles(std::span<const VertexId> a, std::span<const VertexId> b) {
  return a.size() == b.size() && a.size() % 3 == 0 && normal_form(a) == normal_form(b);
}

Triangulation triangles_with_twins(std::vector<Point> points, std::vector<VertexId> tri_vertex) {
  check_triangles(points.size(), tri_vertex);
  Triangulation mesh{std::move(points), std::move(tri_vertex), {}};
  const EdgeLists edges(mesh);
  mesh.twin.resize(mesh.tri_vertex.size());
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) mesh.twin[h] = edges.twin_of(h);
  return mesh;
}

}  // namespace quadloom
