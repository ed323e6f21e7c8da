// Faces of a file into a triangulation that the conversions can rely on.
//
//   1. check_input            the arrays fit together, faces have three or four corners, coordinates
//                             are finite
//   2. decide_space           is the third coordinate data over the plane or a surface
//   3. place_vertices         vertices at the same place are merged, or in the plane refused
//   4. split_faces            quads into two triangles
//   5. match_sides            edges: at most two sides each
//   6. orient_faces           both sides of an edge go opposite ways, in the plane counter-clockwise
//   7. repair_flat_triangles  no triangle without area is left
//   8. count_up               components, boundaries, unused vertices
//
// All decisions are exact. What is promised is local: triangles turn the right way and agree at
// their edges. Faces that lie over each other without sharing an edge are not looked for; certify
// finds them. Two fans of triangles may meet at one vertex (a bow-tie), components may meet at
// vertices; a boundary cycle then goes on within its fan. O(n log n).
#include <algorithm>
#include <cmath>

#include "core/point_text.hpp"
#include "kernel/connect_steps.hpp"

namespace quadloom {
namespace kernel {
namespace {

constexpr std::size_t kMostHalfedges = kNone;

std::string vertex_text(const PolygonMesh& mesh, std::size_t v) {
  return "vertex " + std::to_string(v) + ' ' + point_text(mesh.points[v]);
}

std::string face_text(const PolygonMesh& mesh, std::size_t face) {
  std::string out = "face " + std::to_string(face) + " (vertices";
  for (const VertexId v : mesh.face(face)) out += ' ' + std::to_string(v);
  return out + ')';
}

void check_layout(const PolygonMesh& mesh, std::span<const double> z) {
  const auto& begin = mesh.face_begin;
  if (begin.empty() || begin.front() != 0 || begin.back() != mesh.face_vertex.size() ||
      !std::ranges::is_sorted(begin)) {
    throw Error(ErrorCode::kBadMesh, "the faces' beginnings do not fit the list of corners");
  }
  if (mesh.face_count() == 0) throw Error(ErrorCode::kTooFewPoints, "the mesh has no faces");
  if (!z.empty() && z.size() != mesh.points.size()) {
    throw Error(ErrorCode::kBadMesh, std::to_string(z.size()) + " heights for " +
                                         std::to_string(mesh.points.size()) + " vertices");
  }
  if (mesh.points.size() > kMaxPoints || mesh.face_vertex.size() / 2 * 3 >= kMostHalfedges) {
    throw Error(ErrorCode::kTooManyPoints, "more vertices or faces than 32-bit indices allow");
  }
}

void check_faces(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    if (corners.size() != 3 && corners.size() != 4) {
      throw Error(ErrorCode::kBadMesh,
                  "face " + std::to_string(f) + " has " + std::to_string(corners.size()) +
                      " corners, triangles and quads are expected",
                  {f});
    }
    for (const VertexId v : corners) {
      if (v < mesh.points.size()) continue;
      throw Error(ErrorCode::kIndexOutOfRange,
                  face_text(mesh, f) + " names a vertex that is not there (" +
                      std::to_string(mesh.points.size()) + " vertices)",
                  {f, v});
    }
  }
}

void check_input(const PolygonMesh& mesh, std::span<const double> z) {
  check_layout(mesh, z);
  check_faces(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Point p = mesh.points[v];
    if (std::isfinite(p.x) && std::isfinite(p.y) && (z.empty() || std::isfinite(z[v]))) continue;
    throw Error(ErrorCode::kNotFinite, vertex_text(mesh, v) + " is not finite", {v});
  }
}

std::size_t count_components(const Triangulation& mesh) {
  std::vector<std::uint8_t> seen(mesh.triangle_count(), 0);
  std::vector<TriangleId> stack;
  std::size_t components = 0;
  for (TriangleId first = 0; first < seen.size(); ++first) {
    if (seen[first] != 0) continue;
    ++components;
    seen[first] = 1;
    stack.push_back(first);
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (mesh.twin[h] == kNone || seen[triangle_of(mesh.twin[h])] != 0) continue;
        seen[triangle_of(mesh.twin[h])] = 1;
        stack.push_back(triangle_of(mesh.twin[h]));
      }
    }
  }
  return components;
}

/// The boundary halfedge that begins where h ends, in the same fan.
HalfedgeId next_on_boundary(const Triangulation& mesh, HalfedgeId h) {
  h = next_halfedge(h);
  while (mesh.twin[h] != kNone) h = next_halfedge(mesh.twin[h]);
  return h;
}

void count_up(ConnectedMesh& out) {
  const Triangulation& mesh = out.triangles.mesh;
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (const VertexId v : mesh.tri_vertex) used[v] = 1;
  out.unused_vertices = static_cast<std::size_t>(std::ranges::count(used, 0));
  out.components = count_components(mesh);
  std::vector<std::uint8_t> seen(mesh.twin.size(), 0);
  for (HalfedgeId first = 0; first < mesh.twin.size(); ++first) {
    if (mesh.twin[first] != kNone || seen[first] != 0) continue;
    ++out.boundary_cycles;
    for (HalfedgeId h = first; seen[h] == 0; h = next_on_boundary(mesh, h)) {
      seen[h] = 1;
      ++out.boundary_edges;
    }
  }
}

}  // namespace

void Connecting::refuse_face(std::size_t face, const std::string& what) const {
  throw Error(ErrorCode::kBadMesh, face_text(input, face) + ' ' + what, {face});
}

void Connecting::refuse_edge(VertexId from, VertexId to, const std::string& what) const {
  if (!vertex_to_input.empty()) {
    from = vertex_to_input[from];
    to = vertex_to_input[to];
  }
  throw Error(
      ErrorCode::kBadMesh,
      "the edge from " + vertex_text(input, from) + " to " + vertex_text(input, to) + ' ' + what,
      {from, to});
}

}  // namespace kernel

ConnectedMesh connect_triangles(const PolygonMesh& mesh, std::span<const double> z,
                                const ConnectOptions& options) {
  using namespace kernel;
  check_input(mesh, z);
  Connecting work{mesh, z, options};
  decide_space(work);
  place_vertices(work);
  split_faces(work);
  orient_faces(work, match_sides(work));
  repair_flat_triangles(work);
  count_up(work.out);
  if (std::ranges::all_of(work.out.triangles.given_pair, [](auto h) { return h == kNone; })) {
    work.out.triangles.given_pair.clear();
  }
  return std::move(work.out);
}

}  // namespace quadloom
