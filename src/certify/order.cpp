// Whether the order of triangles is a path, a cycle or a sequential one.
//
//   1. judge_corners    all faces are triangles of vertices that are there (certify/corners.hpp)
//   2. check_neighbours consecutive triangles have an edge, once in each direction; in a cycle the last
//                       and the first too
//   3. check_turns      sequential: one of the six orders of the first triangle's corners goes on to the
//                       end. From two vertices of the sequence on the next triangle gives the third:
//
//           s1 ------ s3 ------ s5
//          /  \  1   /  \  3   /        triangle i = s(i) s(i + 1) s(i + 2)
//         /  0 \    /  2 \    /
//       s0 ----- s2 ----- s4
//
// Cost: linear.
#include <algorithm>
#include <array>
#include <vector>

#include "certify/corners.hpp"
#include "certify/wording.hpp"
#include "quadloom/certify.hpp"

namespace quadloom {
namespace {

using Corners = std::span<const VertexId>;

bool share_an_edge(Corners t, Corners u) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (t[i] == u[(j + 1) % 3] && t[(i + 1) % 3] == u[j]) return true;
    }
  }
  return false;
}

void check_neighbours(const PolygonMesh& mesh, OrderKind kind, Certificate& out) {
  const std::size_t count = mesh.face_count();
  const auto complain = [&](std::size_t f, std::size_t g, const std::string& words) {
    certify::fail(out, Fault::kOrder,
                  certify::face_text(mesh, f) + " and " + certify::face_text(mesh, g) + words,
                  {f, g});
  };
  for (std::size_t f = 0; f + 1 < count; ++f) {
    if (!share_an_edge(mesh.face(f), mesh.face(f + 1))) {
      return complain(f, f + 1, " follow each other and share no edge");
    }
  }
  if (kind == OrderKind::kCycle &&
      (count < 3 || !share_an_edge(mesh.face(count - 1), mesh.face(0)))) {
    complain(count - 1, 0, count < 3 ? " are too few for a cycle" : " do not close the cycle");
  }
}

/// How many triangles the sequence that begins with these corners of the first one goes through.
std::size_t reach(const PolygonMesh& mesh, std::array<VertexId, 3> s) {
  for (std::size_t f = 1; f < mesh.face_count(); ++f) {
    const Corners t = mesh.face(f);
    VertexId next = kNone;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<VertexId, 2> others = {t[(i + 1) % 3], t[(i + 2) % 3]};
      if (others == std::array{s[1], s[2]} || others == std::array{s[2], s[1]}) next = t[i];
    }
    if (next == kNone) return f;
    s = {s[1], s[2], next};
  }
  return mesh.face_count();
}

void check_turns(const PolygonMesh& mesh, Certificate& out) {
  std::array<VertexId, 3> first;
  std::copy_n(mesh.face(0).begin(), 3, first.begin());
  std::sort(first.begin(), first.end());
  std::size_t farthest = 0;
  do {
    farthest = std::max(farthest, reach(mesh, first));
  } while (std::next_permutation(first.begin(), first.end()));
  if (farthest == mesh.face_count()) return;
  certify::fail(out, Fault::kTurns,
                certify::face_text(mesh, farthest) + " turns the same way as the one before",
                {farthest});
}

}  // namespace

Certificate certify_order(const PolygonMesh& mesh, OrderKind kind) {
  CertifyOptions triangles;
  triangles.corners = 3;
  Certificate out;
  std::vector<std::uint8_t> used;
  if (!certify::judge_corners(mesh, triangles, out, used)) return out;
  check_neighbours(mesh, kind, out);
  if (out.ok() && kind == OrderKind::kSequential) check_turns(mesh, out);
  return out;
}

}  // namespace quadloom
