#include "quadrangulate/quad_mesh.hpp"

#include <numeric>
#include <utility>

#include "core/large_array.hpp"
#include "core/parallel.hpp"

namespace quadloom::quadrangulate {

void QuadMesh::pair(HalfedgeId h) {
  //       c
  //     /   .           a, d, b, c
  //    a --- b    ->
  //     .   /
  //       d
  const HalfedgeId g = twin(h);
  const std::array<HalfedgeId, 4> old = {next(g), next(next(g)), next(h), next(next(h))};
  Face quad;
  for (std::size_t i = 0; i < 4; ++i) {
    quad.corner[i] = origin(old[i]);
    quad.twin[i] = twin(old[i]);
  }
  const FaceId f = face_of(h);
  faces[f] = quad;
  for (std::size_t i = 0; i < 4; ++i) link(4 * f + static_cast<HalfedgeId>(i), quad.twin[i]);
  faces[face_of(g)] = {{kNone, kNone, kNone, 0}, {kNone, kNone, kNone, kNone}};
}

std::array<FaceId, 2> recut_pentagon(QuadMesh& mesh, HalfedgeId enter, int ear) {
  const QuadMesh::Behind quad = quad_behind(mesh, enter);
  const HalfedgeId shared = mesh.twin(enter);
  const FaceId t = QuadMesh::face_of(shared), q = quad.face;
  const std::array<HalfedgeId, 5> inner = {mesh.next(shared), mesh.next(mesh.next(shared)),
                                           quad.side[0], quad.side[1], quad.side[2]};
  // Turn the names so that the ear is at p[0] and the quad left is p[1], p[2], p[3], p[4].
  std::array<VertexId, 5> p;
  std::array<HalfedgeId, 5> outer;  // across the edge from p[k] to p[k + 1]
  for (std::size_t k = 0; k < 5; ++k) {
    const HalfedgeId h = inner[(static_cast<std::size_t>(ear) + k) % 5];
    p[k] = mesh.origin(h);
    outer[k] = mesh.twin(h);
  }
  mesh.faces[t].corner = {p[4], p[0], p[1], kNone};
  mesh.faces[q].corner = {p[1], p[2], p[3], p[4]};
  mesh.link(4 * t, outer[4]);
  mesh.link(4 * t + 1, outer[0]);
  mesh.link(4 * q, outer[1]);
  mesh.link(4 * q + 1, outer[2]);
  mesh.link(4 * q + 2, outer[3]);
  mesh.link(4 * t + 2, 4 * q + 3);
  return {t, q};
}

namespace {

/// Numbers what each triangle or face stands for, one after the other: the first of each, and how many in all.
/// `size` says how many.
template <typename Size>
std::uint32_t number_all(std::vector<std::uint32_t>& first, const Size& size) {
  const std::size_t count = first.size();
  std::vector<std::uint32_t> next((count + kPartOfPass - 1) / kPartOfPass + 1);  // of each block
  parallel_for_blocks(count, kPartOfPass, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
      next[begin / kPartOfPass + 1] += size(i);
  });
  std::partial_sum(next.begin(), next.end(), next.begin());
  parallel_for_blocks(count, kPartOfPass, [&](std::size_t begin, std::size_t end) {
    std::uint32_t at = next[begin / kPartOfPass];
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      first[i] = at;
      at += size(i);
    }
  });
  return next.back();
}

/// The face of each triangle, and where its sides are in it.
class FaceOfTriangles {
 public:
  explicit FaceOfTriangles(const PairedMesh& mesh)
      : face_(large_vector<FaceId>(mesh.mate.size())), kind_(mesh.mate.size(), 0) {
    const auto other = [&](TriangleId t) {
      return mesh.is_free(t) ? t : triangle_of(mesh.tri.twin[mesh.mate[t]]);
    };
    count_ = number_all(face_, [&](TriangleId t) { return other(t) < t ? 0U : 1U; });
    parallel_for(face_.size(), [&](TriangleId t) {
      if (mesh.is_free(t)) return;
      const bool is_second = other(t) < t;
      if (is_second) face_[t] = face_[other(t)];
      kind_[t] = static_cast<std::uint8_t>(1 + mesh.mate[t] - 3 * t + (is_second ? 3 : 0));
    });
  }
  FaceId count() const { return count_; }
  FaceId face(TriangleId t) const { return face_[t]; }
  /// The halfedge that takes the place of g; of an inner one: any.
  HalfedgeId side(HalfedgeId g) const {
    // After the inner halfedge are the sides 2 and 3 of the quad in its first triangle, 0 and 1 in the second.
    constexpr std::uint8_t kSide[][3] = {{0, 1, 2}, {0, 2, 3}, {3, 0, 2}, {2, 3, 0},
                                         {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    const TriangleId t = triangle_of(g);
    return 4 * face_[t] + kSide[kind_[t]][g - 3 * t];
  }

 private:
  std::vector<FaceId> face_;
  std::vector<std::uint8_t>
      kind_;  // 0: free; 1 + i, 4 + i: first or second of a quad, halfedge i is inside
  FaceId count_ = 0;
};

}  // namespace

QuadMesh to_quad_mesh(PairedMesh&& mesh) {
  QuadMesh out;
  const FaceOfTriangles where(mesh);
  out.faces = large_vector<QuadMesh::Face>(where.count());
  parallel_for(mesh.mate.size(), [&](TriangleId t) {
    QuadMesh::Face& face = out.faces[where.face(t)];
    const auto put = [&](HalfedgeId g) {
      const HalfedgeId side = where.side(g) % 4, twin = mesh.tri.twin[g];
      face.corner[side] = mesh.tri.origin(g);
      face.twin[side] = twin == kNone ? kNone : where.side(twin);
    };
    const HalfedgeId inner = mesh.mate[t];
    if (inner == kNone) {
      for (HalfedgeId g = 3 * t; g < 3 * t + 3; ++g) put(g);
      face.corner[3] = face.twin[3] = kNone;
    } else {
      put(next_halfedge(inner));
      put(previous_halfedge(inner));
    }
  });
  out.points = std::move(mesh.tri.points);
  return out;
}

PairedMesh to_paired_mesh(QuadMesh&& mesh) {
  // A quad a, b, c, d becomes a, b, c and c, d, a, or b, c, d and d, a, b.
  enum Parting : std::uint8_t { kFirstDiagonal, kSecondDiagonal, kNotParted };
  constexpr std::uint8_t kSide[][4] = {
      {0, 1, 3, 4}, {4, 0, 1, 3}, {0, 1, 2}};  // after the first halfedge
  auto first = large_vector<TriangleId>(mesh.face_count());
  const TriangleId count = number_all(first, [&](FaceId f) {
    return mesh.is_gone(f) ? 0U : mesh.is_free(f) ? 1U : 2U;
  });
  std::vector<Parting> parting(mesh.face_count(), kNotParted);
  parallel_for(mesh.face_count(), [&](FaceId f) {
    if (!mesh.is_quad(f)) return;
    const auto at = [&](std::size_t i) { return mesh.point(mesh.faces[f].corner[i]); };
    const bool by_first = split_by_first_diagonal(at(0), at(1), at(2), at(3));
    parting[f] = by_first ? kFirstDiagonal : kSecondDiagonal;
  });
  const auto halfedge = [&](HalfedgeId side) {
    const FaceId f = QuadMesh::face_of(side);
    return 3 * first[f] + kSide[parting[f]][side % 4];
  };
  PairedMesh out;
  reserve_large(out.tri.tri_vertex, 3 * with_room(count));
  reserve_large(out.tri.twin, 3 * with_room(count));
  reserve_large(out.mate, with_room(count));
  out.tri.tri_vertex.resize(3 * count);
  out.tri.twin.resize(3 * count);
  out.mate.resize(count);
  parallel_for(mesh.face_count(), [&](FaceId f) {
    if (mesh.is_gone(f)) return;
    const QuadMesh::Face& face = mesh.faces[f];
    const TriangleId t = first[f];
    const std::size_t corners = mesh.is_free(f) ? 3 : 4;
    for (std::size_t i = 0; i < corners; ++i) {
      const HalfedgeId h = 3 * t + kSide[parting[f]][i];
      out.tri.tri_vertex[h] = face.corner[i];
      out.tri.twin[h] = face.twin[i] == kNone ? kNone : halfedge(face.twin[i]);
    }
    out.mate[t] = kNone;
    if (corners == 3) return;
    const std::size_t skip = parting[f] == kFirstDiagonal ? 0 : 1;
    out.tri.tri_vertex[3 * t + 2] = face.corner[(skip + 2) % 4];
    out.tri.tri_vertex[3 * t + 5] = face.corner[skip];
    out.tri.twin[3 * t + 2] = 3 * t + 5;
    out.tri.twin[3 * t + 5] = 3 * t + 2;
    out.mate[t] = 3 * t + 2;
    out.mate[t + 1] = 3 * t + 5;
  });
  out.tri.points = std::move(mesh.points);
  return out;
}

Quadrangulation to_quadrangulation(QuadMesh&& mesh) {
  Quadrangulation out;
  out.points = std::move(mesh.points);
  reserve_large(out.quad_vertex, 4 * mesh.face_count());
  for (FaceId f = 0; f < mesh.face_count(); ++f) {
    const auto& corner = mesh.faces[f].corner;
    auto& list = mesh.is_quad(f) ? out.quad_vertex : out.tri_vertex;
    const std::ptrdiff_t corners = mesh.is_quad(f) ? 4 : mesh.is_free(f) ? 3 : 0;
    list.insert(list.end(), corner.begin(), corner.begin() + corners);
  }
  return out;
}

}  // namespace quadloom::quadrangulate
