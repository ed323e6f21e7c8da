// Quads into two triangles each.
//
//    d --- c      a-c is a diagonal if a b c and a c d turn the same way, b-d if a b d and b c d do;
//    |   / |      a quad has one if and only if it is simple and has an area. Of two the one is taken
//    | /   |      that Delaunay would take.
//    a --- b
//
// On a surface the quad is seen in the coordinate plane that it is nearest to; a quad so bent that
// it has no diagonal there is seen in the two others.
#include <algorithm>
#include <array>

#include "kernel/connect_steps.hpp"
#include "kernel/predicates_inline.hpp"

namespace quadloom::kernel {
namespace {

using Corners = std::array<VertexId, 4>;

QuadCut cut_in_chart(const Places& places, const Chart& chart, const Corners& q) {
  return cut_quad(places.seen(chart, q[0]), places.seen(chart, q[1]), places.seen(chart, q[2]),
                  places.seen(chart, q[3]));
}

QuadCut cut_in_space(const Places& places, const Corners& q) {
  if (places.planar()) return cut_in_chart(places, Chart(), q);
  const Vector3 area = cross(places.at(q[2]) - places.at(q[0]), places.at(q[3]) - places.at(q[1]));
  const std::array charts = {Chart(area), Chart({0, 0, 1}), Chart({0, 1, 0}), Chart({1, 0, 0})};
  QuadCut cut;
  for (std::size_t i = 0; i < charts.size() && cut.turn == 0; ++i) {
    cut = cut_in_chart(places, charts[i], q);
  }
  return cut;
}

/// The corners of a face as vertices, without those that repeat the one before.
std::size_t distinct_corners(const Connecting& work, std::size_t face, Corners& out) {
  std::size_t size = 0;
  for (const VertexId corner : work.input.face(face)) {
    const VertexId v = work.out.input_to_vertex[corner];
    if (size == 0 || out[size - 1] != v) out[size++] = v;
  }
  while (size > 1 && out[size - 1] == out[0]) --size;
  return size;
}

void add_triangle(Connecting& work, std::size_t face, VertexId a, VertexId b, VertexId c,
                  HalfedgeId pair) {
  auto& corners = work.mesh().tri_vertex;
  corners.insert(corners.end(), {a, b, c});
  work.out.source_face.push_back(static_cast<std::uint32_t>(face));
  work.out.triangles.given_pair.push_back(pair);
}

void add_quad(Connecting& work, std::size_t face, Corners q) {
  if (q[0] == q[2] || q[1] == q[3]) work.refuse_face(face, "has a corner twice");
  const QuadCut cut = cut_in_space(work.places(), q);
  if (cut.turn == 0) work.refuse_face(face, "is not a simple quad with an area");
  if (!cut.from_a) std::rotate(q.begin(), q.begin() + 1, q.end());
  const auto h = static_cast<HalfedgeId>(work.mesh().tri_vertex.size());
  add_triangle(work, face, q[0], q[1], q[2], h + 2);
  add_triangle(work, face, q[0], q[2], q[3], h + 3);
}

}  // namespace

QuadCut cut_quad(Point a, Point b, Point c, Point d) {
  const int abc = orient(a, b, c), acd = orient(a, c, d);
  const int abd = orient(a, b, d), bcd = orient(b, c, d);
  const bool from_a = abc != 0 && abc == acd, from_b = abd != 0 && abd == bcd;
  if (from_a && from_b) return {abc, incircle(a, b, c, d) * abc <= 0};
  if (from_a) return {abc, true};
  return {from_b ? abd : 0, false};
}

void split_faces(Connecting& work) {
  const PolygonMesh& input = work.input;
  Corners q{};
  for (std::size_t f = 0; f < input.face_count(); ++f) {
    const std::size_t size = distinct_corners(work, f, q);
    if (size == 4) {
      add_quad(work, f, q);
    } else if (size == 3) {
      add_triangle(work, f, q[0], q[1], q[2], kNone);
    } else if (work.repairs()) {
      ++work.out.flat_faces;
    } else {
      work.refuse_face(f, "has a corner twice");
    }
  }
  if (work.mesh().tri_vertex.empty()) {
    throw Error(ErrorCode::kTooFewPoints, "the mesh has no faces with an area");
  }
}

}  // namespace quadloom::kernel
