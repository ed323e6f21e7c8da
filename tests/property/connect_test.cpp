// connect_triangles on meshes that were turned, shuffled and damaged, and on faces that are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "support/connected_checks.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

using test::check_connected;
using Face = std::vector<VertexId>;

std::string name(const char* kind, std::uint64_t seed) {
  return std::string(kind) + ", seed " + std::to_string(seed);
}

/// The triangles as sets of corners, in order.
std::vector<std::array<VertexId, 3>> corner_sets(const std::vector<VertexId>& tri_vertex) {
  std::vector<std::array<VertexId, 3>> out;
  for (std::size_t t = 0; t + 2 < tri_vertex.size(); t += 3) {
    out.push_back({tri_vertex[t], tri_vertex[t + 1], tri_vertex[t + 2]});
    std::ranges::sort(out.back());
  }
  std::ranges::sort(out);
  return out;
}

TEST(ConnectProperty, DelaunayMeshesShuffledAndTurned) {
  for (const Generator& kind : generators()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(kind.name.data(), seed));
      Random random(seed);
      const auto n = std::max(kind.min_points, 3 + random.below(200));
      const Triangulation mesh = delaunay(kind.make(n, seed)).mesh;
      PolygonMesh faces = to_polygon_mesh(mesh);
      const std::size_t turned = test::shuffle_faces(faces, random, 0.3);
      const ConnectedMesh out = connect_triangles(faces);
      check_connected(out, mesh.points.size());
      if (HasFatalFailure()) return;
      EXPECT_EQ(out.turned_faces, turned);
      EXPECT_EQ(out.flat_faces, 0U);
      EXPECT_EQ(out.components, 1U);
      EXPECT_EQ(out.boundary_cycles, 1U);
      EXPECT_EQ(test::euler_characteristic(out), 1);
      EXPECT_EQ(corner_sets(out.triangles.mesh.tri_vertex), corner_sets(mesh.tri_vertex));
    }
  }
}

TEST(ConnectProperty, VerticesSplitAndMergedAgain) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(name("uniform", seed));
    Random random(seed);
    const Triangulation mesh =
        delaunay(generate_points("uniform", 3 + random.below(100), seed)).mesh;
    PolygonMesh soup;  // each triangle with its own vertices, as in .stl
    for (const VertexId v : mesh.tri_vertex) soup.points.push_back(mesh.points[v]);
    for (VertexId v = 0; v < soup.points.size(); v += 3) {
      soup.add_face(std::array<VertexId, 3>{v, v + 1, v + 2});
    }
    const ConnectedMesh out = connect_triangles(soup, {}, {.equal = EqualVertices::kMerge});
    check_connected(out, soup.points.size());
    if (HasFatalFailure()) return;
    EXPECT_EQ(out.triangles.mesh.points.size(), mesh.points.size());
    EXPECT_EQ(out.components, 1U);
    EXPECT_EQ(out.boundary_cycles, 1U);
    if (mesh.triangle_count() == 1) continue;
    EXPECT_THROW(connect_triangles(soup), Error);
  }
}

// ---- Triangles without area. ----

/// Cuts a ring of vertices on one line into triangles at random, as sets of corners: some turned.
void add_flat_triangles(Face ring, Random& random, std::vector<Face>& faces) {
  while (ring.size() > 2) {
    const std::size_t i = random.below(ring.size());
    const VertexId a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    faces.push_back(random.below(2) == 0 ? Face{a, b, c} : Face{c, b, a});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>((i + 1) % ring.size()));
  }
}

/// A Delaunay mesh in which every few edges were opened: vertices in the edge on either side, the
/// gap of no width filled with triangles without area.
//
//        d                 d
//      /   \.            / | \.
//     a --- b    ->     a--p--b    and between a p b q, drawn apart but on one line, flat triangles
//      \   /            a---q-b
//        e               \  |/ e
struct Opened {
  Opened(std::uint64_t seed, std::uint64_t most_added) : random(seed) {
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) {
      points.push_back({1024.0 * static_cast<double>(random.below(40)),
                        1024.0 * static_cast<double>(random.below(40))});
    }
    const Triangulation from = delaunay(points).mesh;
    mesh.points = from.points;
    std::vector<std::uint8_t> done(from.triangle_count(), 0);
    for (HalfedgeId h = 0; h < from.twin.size(); ++h) {
      const HalfedgeId twin = from.twin[h];
      const TriangleId t = triangle_of(h), u = twin == kNone ? t : triangle_of(twin);
      if (done[t] != 0 || done[u] != 0 || random.below(3) != 0) continue;
      done[t] = done[u] = 1;
      open(from, h, most_added);
    }
    for (TriangleId t = 0; t < from.triangle_count(); ++t) {
      const VertexId* v = &from.tri_vertex[3 * t];
      if (done[t] == 0) faces.push_back({v[0], v[1], v[2]});
    }
    test::set_faces(mesh, faces);
  }

  /// Some of 31 places between a and b, in order, those of the other side left out; and a fan.
  Face add_side(VertexId a, VertexId b, VertexId apex, std::vector<std::uint8_t>& taken,
                std::uint64_t most) {
    std::vector<std::uint32_t> places;
    for (std::uint64_t i = random.below(most + 1); i > 0; --i) {
      const auto place = static_cast<std::uint32_t>(1 + random.below(31));
      if (taken[place] == 0) places.push_back(place);
      taken[place] = 1;
    }
    std::ranges::sort(places);
    Face side = {a};
    const Point p = mesh.points[a], q = mesh.points[b];
    for (const std::uint32_t place : places) {
      side.push_back(static_cast<VertexId>(mesh.points.size()));
      mesh.points.push_back({p.x + (q.x - p.x) / 32 * place, p.y + (q.y - p.y) / 32 * place});
    }
    side.push_back(b);
    for (std::size_t i = 0; i + 1 < side.size(); ++i) faces.push_back({side[i], side[i + 1], apex});
    return side;
  }

  void open(const Triangulation& from, HalfedgeId h, std::uint64_t most) {
    const VertexId a = from.origin(h), b = from.target(h);
    std::vector<std::uint8_t> taken(32, 0);
    Face ring = add_side(a, b, from.apex(h), taken, most);
    if (from.twin[h] != kNone) {
      const std::vector<std::uint8_t> before = taken;
      std::vector<Face> there;
      std::swap(there, faces);
      Face other = add_side(a, b, from.apex(from.twin[h]), taken, most);
      for (Face& face : faces) std::swap(face[0], face[1]);  // seen from the other side
      faces.insert(faces.end(), there.begin(), there.end());
      for (std::size_t i = other.size() - 2; i > 0; --i) ring.push_back(other[i]);
    }
    const std::size_t count = faces.size();
    add_flat_triangles(ring, random, faces);
    flat += faces.size() - count;
  }

  Random random;
  PolygonMesh mesh;
  std::vector<Face> faces;
  std::size_t flat = 0;
};

TEST(ConnectProperty, FlatTrianglesBetweenOthers) {
  std::size_t flat = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(name("opened", seed));
    Opened opened(seed, seed % 12 + 1);
    test::shuffle_faces(opened.mesh, opened.random, 0.3);
    const ConnectedMesh out = connect_triangles(opened.mesh);
    check_connected(out, opened.mesh.points.size());
    if (HasFatalFailure()) return;
    EXPECT_EQ(out.flat_faces, opened.flat);
    const Certificate certificate =
        certify_points(to_polygon_mesh(out.triangles.mesh), opened.mesh.points, {.corners = 3});
    ASSERT_TRUE(certificate.ok()) << certificate.sentence;
    for (TriangleId t = 0; t < out.source_face.size(); ++t) {  // data of faces with an area
      const auto source = opened.mesh.face(out.source_face[t]);
      EXPECT_NE(orient2d(opened.mesh.points[source[0]], opened.mesh.points[source[1]],
                         opened.mesh.points[source[2]]),
                0);
    }
    flat += opened.flat;
  }
  EXPECT_GT(flat, 5000U);
}

TEST(ConnectProperty, FlatTrianglesInSpace) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(name("opened, tilted", seed));
    Opened opened(seed, 6);
    test::shuffle_faces(opened.mesh, opened.random, 0.3);
    std::vector<double> z;
    for (Point& p : opened.mesh.points) {
      z.push_back(p.x + 2 * p.y);
      p.x = 4 * p.y - p.x;  // all exact
    }
    const ConnectedMesh out = connect_triangles(opened.mesh, z, {.space = Space::kSurface});
    check_connected(out, opened.mesh.points.size());
    if (HasFatalFailure()) return;
    EXPECT_EQ(out.flat_faces, opened.flat);
    EXPECT_EQ(out.boundary_cycles, 1U);
    EXPECT_EQ(test::euler_characteristic(out), 1);
  }
}

// ---- Surfaces. ----

TEST(ConnectProperty, SurfacesShuffledAndTurned) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(name("surfaces", seed));
    Random random(seed);
    const bool quads = random.below(2) == 0;
    const auto n = static_cast<VertexId>(3 + random.below(9)), m = n + 2;
    const std::array<test::Surface, 4> surfaces = {test::torus(n, m, quads), test::sphere(2),
                                                   test::cube(quads),
                                                   test::height_field(n, m, quads, seed)};
    const std::array<long, 4> euler = {0, 2, 2, 1};
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      PolygonMesh mesh = surfaces[i].mesh;
      const std::size_t turned = test::shuffle_faces(mesh, random, random.uniform());
      const auto given =
          connect_triangles(surfaces[i].mesh, surfaces[i].z, {.space = Space::kSurface});
      const auto out = connect_triangles(mesh, surfaces[i].z, {.space = Space::kSurface});
      check_connected(out, surfaces[i].z.size());
      if (HasFatalFailure()) return;
      EXPECT_EQ(given.turned_faces, 0U);
      EXPECT_EQ(out.turned_faces, std::min(turned, mesh.face_count() - turned));
      EXPECT_EQ(out.components, 1U);
      EXPECT_EQ(test::euler_characteristic(out), euler[i]);
      EXPECT_EQ(out.boundary_edges, given.boundary_edges);
      if (out.turned_faces == 0) continue;
      EXPECT_THROW(connect_triangles(mesh, surfaces[i].z,
                                     {.space = Space::kSurface, .faulty = FaultyFaces::kRefuse}),
                   Error);
    }
  }
}

TEST(ConnectProperty, OneSidedSurfacesShuffledAndTurned) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(name("moebius", seed));
    Random random(seed);
    auto strip = test::moebius_strip(static_cast<VertexId>(3 + random.below(20)));
    test::shuffle_faces(strip.mesh, random, 0.5);
    try {
      connect_triangles(strip.mesh, strip.z);
      ADD_FAILURE() << "a strip with one side was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
      EXPECT_EQ(error.culprits().size(), 2U);
    }
  }
}

// ---- Faces that are no mesh. ----

/// Whatever comes, it is a valid mesh or a refusal that names its culprits. Returns whether it is one.
bool connects(const PolygonMesh& mesh, const std::vector<double>& z,
              const ConnectOptions& options) {
  try {
    check_connected(connect_triangles(mesh, z, options), mesh.points.size());
    return true;
  } catch (const Error& error) {
    EXPECT_FALSE(error.culprits().empty() && error.code() != ErrorCode::kTooFewPoints)
        << error.what();
    EXPECT_NE(error.code(), ErrorCode::kIndexOutOfRange) << error.what();
    return false;
  }
}

PolygonMesh random_faces(Random& random, std::vector<double>& z) {
  PolygonMesh mesh;
  const std::size_t vertices = 3 + random.below(7), faces = 1 + random.below(8);
  const std::uint64_t grid = 1 + random.below(4), levels = 1 + random.below(3);
  for (std::size_t v = 0; v < vertices; ++v) {
    mesh.points.push_back(
        {static_cast<double>(random.below(grid)), static_cast<double>(random.below(grid))});
    z.push_back(static_cast<double>(random.below(levels)));
  }
  Face face;
  for (std::size_t f = 0; f < faces; ++f) {
    face.resize(random.below(4) == 0 ? 4 : 3);
    for (VertexId& v : face) v = static_cast<VertexId>(random.below(vertices));
    mesh.add_face(face);
  }
  return mesh;
}

TEST(ConnectProperty, RandomFaces) {
  std::size_t taken = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    SCOPED_TRACE(name("random faces", seed));
    Random random(seed);
    std::vector<double> z;
    const PolygonMesh mesh = random_faces(random, z);
    for (const Space space : {Space::kAuto, Space::kPlane, Space::kSurface}) {
      for (const FaultyFaces faulty : {FaultyFaces::kRepair, FaultyFaces::kRefuse}) {
        for (const EqualVertices equal : {EqualVertices::kKeep, EqualVertices::kMerge}) {
          ++(connects(mesh, z, {space, faulty, equal}) ? taken : refused);
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(taken, 10000U);
  EXPECT_GT(refused, 10000U);
}

TEST(ConnectProperty, DamagedMeshes) {
  std::size_t taken = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(name("damaged", seed));
    Random random(seed);
    const auto n = static_cast<VertexId>(3 + random.below(4));
    auto surface = random.below(2) == 0 ? test::torus(n, n, random.below(2) == 0)
                                        : test::height_field(n, n, random.below(2) == 0, seed);
    const auto any = [&] { return random.below(surface.z.size()); };
    for (std::uint64_t i = random.below(4); i > 0; --i) {
      VertexId& corner = surface.mesh.face_vertex[random.below(surface.mesh.face_vertex.size())];
      corner = static_cast<VertexId>(any());
    }
    for (std::uint64_t i = random.below(6); i > 0; --i) {  // vertices onto others, and onto lines
      const std::size_t v = any(), a = any(), b = any();
      const double t = random.below(2) == 0 ? 1 : 0.5;
      const Point p = surface.mesh.points[a], q = surface.mesh.points[b];
      surface.mesh.points[v] = {p.x * t + q.x * (1 - t), p.y * t + q.y * (1 - t)};
      surface.z[v] = surface.z[a] * t + surface.z[b] * (1 - t);
    }
    test::shuffle_faces(surface.mesh, random, 0.1);
    for (const EqualVertices equal : {EqualVertices::kKeep, EqualVertices::kMerge}) {
      ++(connects(surface.mesh, surface.z, {Space::kAuto, FaultyFaces::kRepair, equal}) ? taken
                                                                                        : refused);
      ++(connects(surface.mesh, {}, {Space::kAuto, FaultyFaces::kRepair, equal}) ? taken : refused);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(taken, 1000U);
  EXPECT_GT(refused, 1000U);
}

}  // namespace
}  // namespace quadloom
