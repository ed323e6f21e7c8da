// The judge of surfaces: lets good meshes pass and catches every kind of damage.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/random.hpp"
#include "quadloom/certify.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

constexpr std::uint64_t kRounds = 60;

/// A source of triangles, and a mesh of quads that was made from it: of pairs, or of pairs that are
/// split in four, with Steiner points in the middles of edges and quads.
struct Subject {
  explicit Subject(std::uint64_t seed) : random(seed) {
    const auto n = static_cast<VertexId>(3 + random.below(5));
    const auto m = static_cast<VertexId>(3 + random.below(5));
    closed = random.below(2) == 0;
    source = closed ? test::torus(n, m, false) : test::height_field(n, m, false, seed);
    made = closed ? test::torus(n, m, true) : test::height_field(n, m, true, seed);
    pairs = made.mesh.face_count();
    Random order(seed);
    test::shuffle_faces(made.mesh, order, 0);
  }

  /// Each quad into four.
  void split() {
    std::vector<std::vector<VertexId>> faces;
    std::vector<std::array<VertexId, 3>> middles;
    const auto middle = [&](VertexId a, VertexId b) {
      for (const auto& m : middles) {
        if ((m[0] == a && m[1] == b) || (m[0] == b && m[1] == a)) return m[2];
      }
      middles.push_back({a, b, add(a, b)});
      return middles.back()[2];
    };
    for (const auto& q : test::faces_of(made.mesh)) {
      const VertexId centre = add(q[0], q[2]);
      for (std::size_t i = 0; i < 4; ++i) {
        faces.push_back({q[i], middle(q[i], q[(i + 1) % 4]), centre, middle(q[(i + 3) % 4], q[i])});
      }
    }
    test::set_faces(made.mesh, faces);
  }

  VertexId add(VertexId a, VertexId b) {
    const Point p = made.mesh.points[a], q = made.mesh.points[b];
    return made.add_vertex((p.x + q.x) / 2, (p.y + q.y) / 2, (made.z[a] + made.z[b]) / 2);
  }

  VertexId below(std::size_t n) { return static_cast<VertexId>(random.below(n)); }
  VertexId any_source_vertex() { return below(source.z.size()); }
  VertexId any_steiner() {
    return static_cast<VertexId>(source.z.size()) + below(made.z.size() - source.z.size());
  }
  VertexId* corners(std::size_t f) { return made.mesh.face_vertex.data() + 4 * f; }
  VertexId any_face() { return below(made.mesh.face_count()); }
  Certificate verdict(const CertifyOptions& options = {}) const {
    return certify_surface(made.mesh, made.z, source.mesh, source.z, options);
  }

  Random random;
  bool closed = false;
  test::Surface source, made;
  std::size_t pairs = 0;
};

/// The mesh must be good before, and have one of the faults after.
template <class Damage>
void expect_caught(bool split, Damage damage, const std::vector<Fault>& faults,
                   const CertifyOptions& options = {}) {
  for (std::uint64_t seed = 1; seed <= kRounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Subject s(seed);
    if (split) s.split();
    ASSERT_TRUE(s.verdict().ok()) << s.verdict().sentence;
    if (!damage(s)) continue;
    const Certificate verdict = s.verdict(options);
    ASSERT_TRUE(std::ranges::count(faults, verdict.fault) > 0)
        << static_cast<int>(verdict.fault) << ' ' << verdict.sentence;
    ASSERT_FALSE(verdict.sentence.empty());
  }
}

TEST(CertifySurface, CountsWhatItSees) {
  for (std::uint64_t seed = 1; seed <= kRounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Subject s(seed);
    auto verdict = s.verdict();
    ASSERT_TRUE(verdict.ok()) << verdict.sentence;
    EXPECT_EQ(verdict.faces, s.pairs);
    EXPECT_EQ(verdict.points, s.source.z.size());
    EXPECT_EQ(verdict.steiner, 0U);
    EXPECT_EQ(verdict.strictly_convex + verdict.flat_cornered + verdict.non_convex, s.pairs);
    EXPECT_EQ(verdict.boundary == 0, s.closed);
    s.split();
    verdict = s.verdict();
    ASSERT_TRUE(verdict.ok()) << verdict.sentence;
    EXPECT_EQ(verdict.faces, 4 * s.pairs);
    EXPECT_EQ(verdict.points + verdict.steiner, s.made.z.size());
    EXPECT_TRUE(
        certify_surface(s.source.mesh, s.source.z, s.source.mesh, s.source.z, {.corners = 3}).ok());
  }
}

TEST(CertifySurface, VertexMovedOrLost) {
  expect_caught(true,
                [](Subject& s) {
                  double& z = s.made.z[s.any_source_vertex()];
                  z = std::nextafter(z, 9);
                  return true;
                },
                {Fault::kMissingPoint});
  expect_caught(true,
                [](Subject& s) {  // another vertex at the same place instead
                  const VertexId v = s.any_source_vertex();
                  const VertexId w = s.add(v, v);
                  std::ranges::replace(s.made.mesh.face_vertex, v, w);
                  return true;
                },
                {Fault::kMissingPoint});
}

TEST(CertifySurface, FacesDroppedDoubledOrTurned) {
  expect_caught(true,
                [](Subject& s) {
                  auto faces = test::faces_of(s.made.mesh);
                  faces.erase(faces.begin() + s.any_face());
                  test::set_faces(s.made.mesh, faces);
                  return true;
                },
                {Fault::kBoundary, Fault::kFans, Fault::kMissingPoint});
  expect_caught(false,
                [](Subject& s) {
                  const auto faces = test::faces_of(s.made.mesh);
                  s.made.mesh.add_face(faces[s.any_face()]);
                  return true;
                },
                {Fault::kRepeatedEdge});
  expect_caught(false,
                [](Subject& s) {
                  VertexId* c = s.corners(s.any_face());
                  std::reverse(c, c + 4);
                  return true;
                },
                {Fault::kRepeatedEdge});
}

TEST(CertifySurface, CornersOfOtherVertices) {
  expect_caught(true,
                [](Subject& s) {  // a crack: one face has its own copy of a corner
                  VertexId& corner = s.corners(s.any_face())[s.below(4)];
                  corner = s.add(corner, corner);
                  return true;
                },
                {Fault::kBoundary, Fault::kFans, Fault::kMissingPoint});
  expect_caught(true,
                [](Subject& s) {  // two Steiner points far from each other become one
                  const VertexId v = s.any_steiner(), w = s.any_steiner();
                  if (v == w) return false;
                  std::ranges::replace(s.made.mesh.face_vertex, v, w);
                  return true;
                },
                {Fault::kFans, Fault::kRepeatedCorner, Fault::kRepeatedEdge, Fault::kBoundary});
  expect_caught(false,
                [](Subject& s) {
                  s.corners(s.any_face())[s.below(4)] = static_cast<VertexId>(s.made.z.size());
                  return true;
                },
                {Fault::kIndexOutOfRange});
}

TEST(CertifySurface, SteinerPointsThatAreNotFinite) {
  expect_caught(true,
                [](Subject& s) {
                  s.made.z[s.any_steiner()] = std::numeric_limits<double>::quiet_NaN();
                  return true;
                },
                {Fault::kNotFinite});
}

//   A handle: two faces a, b are cut out and their rims joined by a tube of four quads.
TEST(CertifySurface, Handle) {
  std::size_t made = 0;
  expect_caught(true,
                [&](Subject& s) {
                  auto faces = test::faces_of(s.made.mesh);
                  const std::size_t i = s.any_face(), j = s.any_face();
                  const auto a = faces[i], b = faces[j];
                  for (const VertexId v : a) {
                    if (std::ranges::count(b, v) > 0) return false;
                  }
                  faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
                  faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)));
                  for (std::size_t k = 0; k < 4; ++k) {
                    faces.push_back({a[k], a[(k + 1) % 4], b[3 - k], b[(4 - k) % 4]});
                  }
                  test::set_faces(s.made.mesh, faces);
                  ++made;
                  return true;
                },
                {Fault::kTopology});
  EXPECT_GT(made, kRounds / 2);
}

TEST(CertifySurface, ComponentTooMany) {
  expect_caught(true,
                [](Subject& s) {
                  const auto cube = test::cube(true);
                  const auto first = static_cast<VertexId>(s.made.z.size());
                  for (std::size_t v = 0; v < 8; ++v) {
                    s.made.add_vertex(cube.mesh.points[v].x, cube.mesh.points[v].y, cube.z[v]);
                  }
                  for (auto face : test::faces_of(cube.mesh)) {
                    for (VertexId& v : face) v += first;
                    s.made.mesh.add_face(face);
                  }
                  return true;
                },
                {Fault::kTopology});
}

TEST(CertifySurface, ComponentsThatChangePlaces) {
  // Two tetrahedra that exchange a vertex.
  test::Surface source;
  for (const double x : {0.0, 10.0}) {
    source.add_vertex(x, 0, 0);
    source.add_vertex(x + 1, 0, 0);
    source.add_vertex(x, 1, 0);
    source.add_vertex(x, 0, 1);
  }
  test::Surface made = source;
  for (const VertexId o : {0U, 4U}) {
    const VertexId other = 4 - o;
    for (const auto& f : {std::array<VertexId, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
      const auto corner = [&](VertexId i) { return (i == 3 ? other : o) + i; };
      source.mesh.add_face(std::array<VertexId, 3>{f[0] + o, f[1] + o, f[2] + o});
      made.mesh.add_face(std::array<VertexId, 3>{corner(f[0]), corner(f[1]), corner(f[2])});
    }
  }
  const CertifyOptions triangles{.corners = 3};
  EXPECT_TRUE(certify_surface(source.mesh, source.z, source.mesh, source.z, triangles).ok());
  EXPECT_EQ(certify_surface(made.mesh, made.z, source.mesh, source.z, triangles).fault,
            Fault::kTopology);
}

TEST(CertifySurface, FacesOnALine) {
  expect_caught(false,
                [](Subject& s) {
                  const VertexId* c = s.corners(s.any_face());
                  for (std::size_t i = 0; i < 4; ++i) {
                    const double t = static_cast<double>(c[i]);
                    for (test::Surface* surface : {&s.source, &s.made}) {
                      surface->mesh.points[c[i]] = {t, 2 * t};
                      surface->z[c[i]] = 3 * t;
                    }
                  }
                  return true;
                },
                {Fault::kNotSimple});
}

TEST(CertifySurface, PointsAddedToTheBoundary) {
  for (std::uint64_t seed = 1; seed <= kRounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Subject s(seed);
    s.split();
    EXPECT_EQ(s.verdict({.steiner_inside = true}).fault,
              s.closed ? Fault::kNoFault : Fault::kSteinerOnBoundary);
    EXPECT_EQ(s.verdict({.steiner_at_most = 3}).fault, Fault::kTooManySteiner);
    if (s.closed) continue;
    // The middle of an edge on the boundary, moved out of the edge's box.
    const auto on_rim = std::ranges::find_if(
        s.made.mesh.points, [&](Point p) { return p.y == 0 && p.x != std::floor(p.x); });
    ASSERT_NE(on_rim, s.made.mesh.points.end());
    on_rim->y = -0.25;
    EXPECT_EQ(s.verdict().fault, Fault::kBoundary);
    EXPECT_TRUE(s.verdict({.outer_steiner = true}).ok());
  }
}

TEST(CertifySurface, StrictConvexity) {
  test::Surface s;
  for (const auto& p : {std::array{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {1.0, 1.0}}) {
    s.add_vertex(0, p[0], p[1]);
  }
  s.mesh.add_face(std::array<VertexId, 4>{0, 1, 2, 3});
  EXPECT_EQ(certify_surface(s.mesh, s.z, s.mesh, s.z).flat_cornered, 1U);
  EXPECT_EQ(certify_surface(s.mesh, s.z, s.mesh, s.z, {.strictly_convex = true}).fault,
            Fault::kNotStrictlyConvex);
  s.z[3] = std::nextafter(1.0, 2);
  EXPECT_TRUE(certify_surface(s.mesh, s.z, s.mesh, s.z, {.strictly_convex = true}).ok());
}

TEST(CertifySurface, RefusesSourcesThatAreNone) {
  const auto s = test::cube(true);
  EXPECT_THROW(certify_surface(s.mesh, s.z, PolygonMesh{}, {}), Error);
  EXPECT_THROW(certify_surface(s.mesh, s.z, s.mesh, std::vector<double>(3, 0)), Error);
  EXPECT_THROW(certify_surface(s.mesh, s.z, s.mesh, s.z, {.corners = 2}), Error);
  auto twice = s.mesh;
  twice.add_face(std::array<VertexId, 4>{0, 2, 3, 1});
  EXPECT_THROW(certify_surface(s.mesh, s.z, twice, s.z), Error);
  EXPECT_EQ(certify_surface(s.mesh, std::vector<double>(3, 0), s.mesh, s.z).fault,
            Fault::kIndexOutOfRange);
  EXPECT_EQ(certify_surface(PolygonMesh{}, {}, s.mesh, s.z).fault, Fault::kNoFaces);
}

TEST(CertifySurface, RandomFaces) {
  // Nothing but a verdict or a refusal of the source; a mesh is always its own source.
  std::size_t judged = 0, good = 0;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto random_surface = [&] {
      test::Surface out;
      const std::size_t vertices = 3 + random.below(4), faces = 1 + random.below(3);
      for (std::size_t v = 0; v < vertices; ++v) {
        const auto i = static_cast<double>(v);
        out.add_vertex(i, i * i, static_cast<double>(random.below(2)));
      }
      for (std::size_t f = 0; f < faces; ++f) {
        std::array<VertexId, 3> corners{};
        for (VertexId& v : corners) v = static_cast<VertexId>(random.below(vertices));
        out.mesh.add_face(corners);
      }
      return out;
    };
    const test::Surface mesh = random_surface(), other = random_surface();
    const CertifyOptions options{.corners = 3, .outer_steiner = random.below(2) == 0};
    for (const test::Surface* from : {&mesh, &other}) {
      const test::Surface& source = *from;
      try {
        const Certificate verdict =
            certify_surface(mesh.mesh, mesh.z, source.mesh, source.z, options);
        ++judged;
        good += verdict.ok() ? 1 : 0;
        ASSERT_EQ(verdict.ok(), verdict.sentence.empty());
        if (from == &mesh) {
          ASSERT_TRUE(verdict.ok() || verdict.fault == Fault::kRepeatedCorner) << verdict.sentence;
        }
      } catch (const Error& error) {
        ASSERT_EQ(error.code(), ErrorCode::kBadMesh) << error.what();
      }
    }
  }
  EXPECT_GT(judged, 10000U);
  EXPECT_GT(good, 1000U);
}

}  // namespace
}  // namespace quadloom
