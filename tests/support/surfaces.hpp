// Surfaces in space to start from, and what is done to faces on their way into a file.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "quadloom/core.hpp"

namespace quadloom::test {

struct Surface {
  PolygonMesh mesh;
  std::vector<double> z;

  VertexId add_vertex(double x, double y, double height) {
    mesh.points.push_back({x, y});
    z.push_back(height);
    return static_cast<VertexId>(z.size() - 1);
  }
};

/// A quad, or the two triangles that it falls into.
inline void add_patch(PolygonMesh& mesh, std::array<VertexId, 4> q, bool quads) {
  if (quads) {
    mesh.add_face(q);
    return;
  }
  mesh.add_face(std::array{q[0], q[1], q[2]});
  mesh.add_face(std::array{q[0], q[2], q[3]});
}

/// `across` x `along` patches around a torus, outside out.
inline Surface torus(VertexId across, VertexId along, bool quads) {
  Surface out;
  for (VertexId j = 0; j < along; ++j) {
    for (VertexId i = 0; i < across; ++i) {
      const double u = 2 * std::numbers::pi * i / across, v = 2 * std::numbers::pi * j / along;
      const double r = 3 + std::cos(u);
      out.add_vertex(r * std::cos(v), r * std::sin(v), std::sin(u));
    }
  }
  for (VertexId j = 0; j < along; ++j) {
    for (VertexId i = 0; i < across; ++i) {
      const VertexId next = (i + 1) % across, up = (j + 1) % along;
      add_patch(out.mesh, {j * across + i, up * across + i, up * across + next, j * across + next},
                quads);
    }
  }
  return out;
}

/// A strip of n patches with half a twist: one side, one boundary.
inline Surface moebius_strip(VertexId n) {
  Surface out;
  for (VertexId i = 0; i < n; ++i) {
    const double u = 2 * std::numbers::pi * i / n;
    for (const double w : {-0.5, 0.5}) {
      const double r = 2 + w * std::cos(u / 2);
      out.add_vertex(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
    }
  }
  for (VertexId i = 0; i < n; ++i) {
    const VertexId a = 2 * i, b = i + 1 < n ? a + 2 : 1, c = i + 1 < n ? a + 3 : 0;
    add_patch(out.mesh, {a, b, c, a + 1}, false);
  }
  return out;
}

/// A sphere of 4 rings x 2 n triangles and more: an octahedron split `levels` times, outside out.
inline Surface sphere(int levels) {
  Surface out;
  for (const double s : {1.0, -1.0}) {
    out.add_vertex(s, 0, 0);
    out.add_vertex(0, s, 0);
    out.add_vertex(0, 0, s);
  }
  std::vector<std::array<VertexId, 3>> faces = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                                                {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int level = 0; level < levels; ++level) {
    std::vector<std::array<VertexId, 3>> finer;
    std::vector<std::array<VertexId, 3>> middles;  // smaller end, larger end, vertex
    const auto middle = [&](VertexId a, VertexId b) {
      if (a > b) std::swap(a, b);
      for (const auto& m : middles) {
        if (m[0] == a && m[1] == b) return m[2];
      }
      const double x = out.mesh.points[a].x + out.mesh.points[b].x,
                   y = out.mesh.points[a].y + out.mesh.points[b].y, h = out.z[a] + out.z[b];
      const double r = std::sqrt(x * x + y * y + h * h);
      middles.push_back({a, b, out.add_vertex(x / r, y / r, h / r)});
      return middles.back()[2];
    };
    for (const auto [a, b, c] : faces) {
      const VertexId ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  for (const auto& f : faces) out.mesh.add_face(f);
  return out;
}

/// The unit cube, six quads or twelve triangles, outside out.
inline Surface cube(bool quads) {
  Surface out;
  for (int i = 0; i < 8; ++i) out.add_vertex(i & 1, i >> 1 & 1, i >> 2 & 1);
  for (const std::array<VertexId, 4> q : {std::array<VertexId, 4>{0, 2, 3, 1},
                                          {4, 5, 7, 6},
                                          {0, 1, 5, 4},
                                          {1, 3, 7, 5},
                                          {3, 2, 6, 7},
                                          {2, 0, 4, 6}}) {
    add_patch(out.mesh, q, quads);
  }
  return out;
}

/// A grid of columns x rows patches with random heights.
inline Surface height_field(VertexId columns, VertexId rows, bool quads, std::uint64_t seed) {
  Random random(seed);
  Surface out;
  for (VertexId j = 0; j <= rows; ++j) {
    for (VertexId i = 0; i <= columns; ++i) out.add_vertex(i, j, random.uniform());
  }
  for (VertexId j = 0; j < rows; ++j) {
    for (VertexId i = 0; i < columns; ++i) {
      const VertexId a = j * (columns + 1) + i, d = a + columns + 1;
      add_patch(out.mesh, {a, a + 1, d + 1, d}, quads);
    }
  }
  return out;
}

inline std::vector<std::vector<VertexId>> faces_of(const PolygonMesh& mesh) {
  std::vector<std::vector<VertexId>> out;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  }
  return out;
}

inline void set_faces(PolygonMesh& mesh, const std::vector<std::vector<VertexId>>& faces) {
  mesh.face_begin = {0};
  mesh.face_vertex.clear();
  for (const auto& face : faces) mesh.add_face(face);
}

/// Faces in random order, each begun anywhere; a share of them turned. Returns how many.
inline std::size_t shuffle_faces(PolygonMesh& mesh, Random& random, double turned_share) {
  auto faces = faces_of(mesh);
  for (std::size_t i = faces.size(); i > 1; --i) std::swap(faces[i - 1], faces[random.below(i)]);
  std::size_t turned = 0;
  for (auto& face : faces) {
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random.below(face.size())),
                face.end());
    if (random.uniform() >= turned_share) continue;
    std::reverse(face.begin(), face.end());
    ++turned;
  }
  set_faces(mesh, faces);
  return turned;
}

}  // namespace quadloom::test
