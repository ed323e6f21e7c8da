// Vertices at the same place, and what the third coordinate means. A spatial order has equal points
// of the plane next to each other; heights sort them further.
#include <algorithm>
#include <numeric>

#include "kernel/connect_steps.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/ring_direction.hpp"

namespace quadloom::kernel {
namespace {

/// The turn of a face seen from above: 0 if it has none, or is not simple.
int turn_from_above(const PolygonMesh& mesh, std::size_t face) {
  const auto corner = mesh.face(face);
  if (corner.size() < 3) return 0;
  if (corner.size() > 4) {
    std::vector<Point> ring;
    for (const VertexId v : corner) ring.push_back(mesh.points[v]);
    return goes_counter_clockwise(ring) ? 1 : -1;
  }
  const auto at = [&](std::size_t i) { return mesh.points[corner[i]]; };
  if (corner.size() == 3) return orient(at(0), at(1), at(2));
  for (std::size_t i = 0; i < 4; ++i) {  // a triangle, written as a quad
    if (corner[i] == corner[(i + 1) % 4]) return orient(at(i), at((i + 2) % 4), at((i + 3) % 4));
  }
  return cut_quad(at(0), at(1), at(2), at(3)).turn;
}

bool turns_one_way(const PolygonMesh& mesh) {
  const int first = turn_from_above(mesh, 0);
  if (first == 0) return false;
  for (std::size_t f = 1; f < mesh.face_count(); ++f) {
    if (turn_from_above(mesh, f) != first) return false;
  }
  return true;
}

/// For each vertex of a face that is not the first one at its place: visit(that one, vertex).
template <class Visit>
void for_each_repeated(const PolygonMesh& mesh, Visit visit) {
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (const VertexId v : mesh.face_vertex) used[v] = 1;
  const std::vector<VertexId> first = first_at_place({mesh.points, {}});
  std::vector<VertexId> first_used(first.size(), kNone);
  for (VertexId v = 0; v < first.size(); ++v) {
    if (used[v] == 0) continue;
    VertexId& there = first_used[first[v]];
    if (there == kNone) {
      there = v;
    } else {
      visit(there, v);
    }
  }
}

bool has_stacked_vertices(const PolygonMesh& mesh, std::span<const double> z) {
  bool stacked = false;
  for_each_repeated(mesh, [&](VertexId a, VertexId b) { stacked |= z[a] != z[b]; });
  return stacked;
}

void refuse_repeated(const Connecting& work) {
  for_each_repeated(work.input, [&](VertexId a, VertexId b) {
    throw Error(ErrorCode::kBadMesh,
                "vertices " + std::to_string(a) + " and " + std::to_string(b) +
                    " are at the same place; merging equal vertices may help",
                {a, b});
  });
}

void merge_repeated(Connecting& work) {
  auto& vertex = work.out.input_to_vertex;
  vertex = first_at_place(work.places());
  Triangulation& mesh = work.mesh();
  std::vector<double>& z = work.out.triangles.z;
  for (VertexId v = 0; v < vertex.size(); ++v) {
    if (vertex[v] != v) {
      vertex[v] = vertex[vertex[v]];
      continue;
    }
    vertex[v] = static_cast<VertexId>(work.vertex_to_input.size());
    mesh.points[vertex[v]] = mesh.points[v];
    if (!z.empty()) z[vertex[v]] = z[v];
    work.vertex_to_input.push_back(v);
  }
  mesh.points.resize(work.vertex_to_input.size());
  if (!z.empty()) z.resize(mesh.points.size());
}

}  // namespace

std::vector<VertexId> first_at_place(const Places& places) {
  std::vector<VertexId> order = spatial_order(places.points);
  std::vector<VertexId> first(order.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && places.points[order[end]] == places.points[order[i]]) ++end;
    const auto here = std::span(order).subspan(i, end - i);
    const auto height = [&](VertexId v) { return places.planar() ? 0 : places.z[v]; };
    if (!places.planar()) std::ranges::stable_sort(here, {}, height);
    VertexId same = here[0];
    for (const VertexId v : here) {
      if (height(v) != height(same)) same = v;
      first[v] = same;
    }
    i = end;
  }
  return first;
}

void decide_space(Connecting& work) {
  const Space asked = work.options.space;
  work.out.space = asked == Space::kAuto ? space_of(work.input, work.z) : asked;
}

void place_vertices(Connecting& work) {
  work.mesh().points = work.input.points;
  if (work.out.space == Space::kSurface) {
    work.out.triangles.z.assign(work.z.begin(), work.z.end());
    work.out.triangles.z.resize(work.input.points.size(), 0);  // none given: the plane at height 0
  }
  if (work.options.equal == EqualVertices::kMerge) {
    merge_repeated(work);
    return;
  }
  if (work.out.space == Space::kPlane) refuse_repeated(work);
  work.out.input_to_vertex.resize(work.input.points.size());
  std::iota(work.out.input_to_vertex.begin(), work.out.input_to_vertex.end(), VertexId{0});
}

}  // namespace quadloom::kernel

namespace quadloom {

Space space_of(const PolygonMesh& mesh, std::span<const double> z) {
  const bool level = std::ranges::adjacent_find(z, std::ranges::not_equal_to{}) == z.end();
  if (level) return Space::kPlane;
  if (z.size() != mesh.points.size() ||
      std::ranges::any_of(mesh.face_vertex, [&](VertexId v) { return v >= z.size(); })) {
    throw Error(ErrorCode::kBadMesh, "heights or corners that do not fit the vertices");
  }
  return kernel::turns_one_way(mesh) && !kernel::has_stacked_vertices(mesh, z) ? Space::kPlane
                                                                               : Space::kSurface;
}

}  // namespace quadloom
