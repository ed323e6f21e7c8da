// Meshes of several blocks of faces: the boundary of all faces together, against a count edge by edge,
// faults with what is counted up to them, and quality, against each face alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "certify/edge_sums.hpp"
#include "certify/edges.hpp"
#include "core/random.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/quadrangulate.hpp"
#include "support/on_threads.hpp"
#include "support/quality_checks.hpp"

namespace quadloom {
namespace {

using Edges = std::vector<std::pair<VertexId, VertexId>>;

Edges pairs_of(const std::vector<certify::DirectedEdge>& edges) {
  Edges out;
  for (const auto [from, to] : edges) out.emplace_back(from, to);
  return out;
}

Edges counted_one_by_one(const PolygonMesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, int> sums;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const VertexId from = face[i], to = face[(i + 1) % face.size()];
      sums[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  Edges out;
  for (const auto& [edge, sum] : sums) {
    for (int i = 0; i < sum; ++i) out.push_back(edge);
    for (int i = 0; i > sum; --i) out.emplace_back(edge.second, edge.first);
  }
  return out;
}

/// Faces that take any vertices: edges are in many of them, on either side.
PolygonMesh any_faces(std::size_t faces, VertexId vertices, Random& random) {
  PolygonMesh mesh;
  mesh.points.resize(vertices);
  std::vector<VertexId> corners;
  while (mesh.face_count() < faces) {
    corners.clear();
    while (corners.size() < 3 + mesh.face_count() % 5) {
      const auto v = static_cast<VertexId>(random.below(vertices));
      if (std::ranges::find(corners, v) == corners.end()) corners.push_back(v);
    }
    mesh.add_face(corners);
  }
  return mesh;
}

TEST(BoundaryChain, CountsTheSidesOfAnyFaces) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto vertices = static_cast<VertexId>(8 + random.below(seed % 2 == 0 ? 20 : 3000));
    // Some have many blocks, and some tables are left with more than their faces' own edges.
    const PolygonMesh mesh = any_faces(seed <= 36 ? random.below(3000) : 80'000, vertices, random);
    EXPECT_EQ(pairs_of(certify::boundary_chain(mesh)), counted_one_by_one(mesh));
  }
}

TEST(BoundaryChain, OneFaceOfManyCorners) {
  PolygonMesh mesh;
  mesh.points.resize(100'000);
  std::vector<VertexId> corners(mesh.points.size());
  for (VertexId v = 0; v < corners.size(); ++v) corners[v] = v;
  mesh.add_face(corners);
  EXPECT_EQ(pairs_of(certify::boundary_chain(mesh)), counted_one_by_one(mesh));
  std::ranges::reverse(corners);
  mesh.add_face(corners);
  EXPECT_TRUE(certify::boundary_chain(mesh).empty());
}

TEST(BoundaryChain, IsTheBoundaryOfAMeshInAnyOrderOfItsFaces) {
  const auto points = generate_points("uniform", 60'000, 7);
  const PolygonMesh mesh = to_polygon_mesh(quadrangulate_points(points).mesh);
  const Edges wanted = pairs_of(certify::match_edges(mesh).alone);
  EXPECT_EQ(pairs_of(certify::boundary_chain(mesh)), wanted);

  std::vector<std::size_t> order(mesh.face_count());
  for (std::size_t f = 0; f < order.size(); ++f) order[f] = f;
  Random random(8);
  for (std::size_t f = order.size(); f > 1; --f) std::swap(order[f - 1], order[random.below(f)]);
  PolygonMesh shuffled;
  shuffled.points = mesh.points;
  for (const std::size_t f : order) shuffled.add_face(mesh.face(f));
  EXPECT_EQ(pairs_of(certify::boundary_chain(shuffled)), wanted);
}

/// 90,000 unit squares in three blocks of faces.
PolygonMesh squares() {
  constexpr VertexId side = 300;
  PolygonMesh mesh;
  for (VertexId y = 0; y <= side; ++y) {
    for (VertexId x = 0; x <= side; ++x) {
      mesh.points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  for (VertexId y = 0; y < side; ++y) {
    for (VertexId x = 0; x < side; ++x) {
      const VertexId v = y * (side + 1) + x;
      mesh.add_face(std::array{v, v + 1, v + side + 2, v + side + 1});
    }
  }
  return mesh;
}

/// The verdict, which must be the same on any number of threads.
Certificate judged(const PolygonMesh& mesh, const CertifyOptions& options = {}) {
  const auto judge = [&] { return certify_points(mesh, mesh.points, options); };
  const Certificate one = on_threads(1, judge);
  for (const int threads : {2, 4}) {
    const Certificate other = on_threads(threads, judge);
    EXPECT_EQ(other.fault, one.fault);
    EXPECT_EQ(other.sentence, one.sentence);
    EXPECT_EQ(other.culprits, one.culprits);
    EXPECT_EQ(other.faces, one.faces);
    EXPECT_EQ(other.triangles, one.triangles);
    EXPECT_EQ(other.strictly_convex, one.strictly_convex);
    EXPECT_EQ(other.flat_cornered, one.flat_cornered);
    EXPECT_EQ(other.non_convex, one.non_convex);
  }
  return one;
}

using Culprits = std::vector<std::size_t>;

TEST(CertifyBlocks, CountAllFaces) {
  const Certificate verdict = judged(squares());
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
  EXPECT_EQ(verdict.faces, 90'000U);
  EXPECT_EQ(verdict.strictly_convex, 90'000U);
  EXPECT_EQ(verdict.boundary, 1200U);
  EXPECT_EQ(verdict.points, 301U * 301U);
}

TEST(CertifyBlocks, TheFirstFaultIsNamedAndCountedUpTo) {
  PolygonMesh twice = squares();
  for (const std::size_t f : {80'000U, 40'000U})
    twice.face_vertex[4 * f] = twice.face_vertex[4 * f + 1];
  const Certificate corners = judged(twice);
  EXPECT_EQ(corners.fault, Fault::kRepeatedCorner);
  EXPECT_EQ(corners.culprits, Culprits{40'000});
  EXPECT_EQ(corners.faces, 40'001U);

  PolygonMesh crossed = squares();
  for (const std::size_t f : {70'000U, 89'000U}) {
    std::swap(crossed.face_vertex[4 * f], crossed.face_vertex[4 * f + 1]);
  }
  const Certificate shapes = judged(crossed);
  EXPECT_EQ(shapes.fault, Fault::kNotSimple);
  EXPECT_EQ(shapes.culprits, Culprits{70'000});
  EXPECT_EQ(shapes.faces, 90'000U);
  EXPECT_EQ(shapes.strictly_convex, 70'000U);
}

/// The mesh with a fault in each of these faces: one that a face's numbers show, or its places.
PolygonMesh damaged(const PolygonMesh& mesh, const std::map<std::size_t, std::size_t>& fault_of,
                    bool of_numbers) {
  PolygonMesh out;
  out.points = mesh.points;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto v = mesh.face(f);
    const auto at = fault_of.find(f);
    std::vector<VertexId> corners(v.begin(), v.end());
    if (at != fault_of.end() && of_numbers) {
      if (at->second == 0) corners[1] = corners[3];
      if (at->second == 1) corners[2] = static_cast<VertexId>(mesh.points.size());
      if (at->second == 2) corners.insert(corners.begin(), corners[0] == 0 ? 7 : 0);
    } else if (at != fault_of.end()) {
      if (at->second == 0) std::swap(corners[0], corners[1]);
      if (at->second == 1) std::ranges::reverse(corners);
      if (at->second == 2) corners = {v[0], v[0] + 1, v[0] + 2, v[3]};  // flat
    }
    out.add_face(corners);
  }
  return out;
}

TEST(CertifyBlocks, LaterFaultsInAnyBlockDoNotMatter) {
  const PolygonMesh mesh = squares();
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const bool of_numbers = seed % 2 == 0;
    Random random(seed);
    std::map<std::size_t, std::size_t> faults;
    for (std::size_t i = 2 + random.below(6); i > 0; --i) {
      std::size_t f = random.below(mesh.face_count());
      if (f % 300 == 299) --f;  // no flat one at the end of a row
      faults[f] = random.below(3);
    }
    const auto [first, kind] = *faults.begin();
    const CertifyOptions options = {.strictly_convex = true};
    const Certificate all = judged(damaged(mesh, faults, of_numbers), options);
    const Certificate alone = judged(damaged(mesh, {{first, kind}}, of_numbers), options);
    EXPECT_EQ(all.fault, alone.fault);
    EXPECT_EQ(all.sentence, alone.sentence);
    EXPECT_EQ(all.culprits, Culprits{first});
    EXPECT_EQ(all.faces, of_numbers ? first + 1 : mesh.face_count());
    EXPECT_EQ(all.strictly_convex, of_numbers ? 0 : first);
    EXPECT_EQ(all.flat_cornered, !of_numbers && kind == 2 ? 1U : 0U);
    EXPECT_EQ(all.non_convex, 0U);
  }
}

TEST(CertifyBlocks, TrianglesAreAllowedForTheWholeMesh) {
  const PolygonMesh all = squares();
  PolygonMesh mesh;
  mesh.points = all.points;
  for (std::size_t f = 0; f < all.face_count(); ++f) {
    const auto v = all.face(f);
    if (f % 40'000 == 1) {  // one in each block
      mesh.add_face(std::array{v[0], v[1], v[2]});
      mesh.add_face(std::array{v[0], v[2], v[3]});
    } else {
      mesh.add_face(v);
    }
  }
  EXPECT_TRUE(judged(mesh, {.triangles_allowed = 6}).ok());
  const Certificate verdict = judged(mesh, {.triangles_allowed = 5});
  EXPECT_EQ(verdict.fault, Fault::kTooManyTriangles);
  EXPECT_EQ(verdict.culprits, Culprits{80'004});
  EXPECT_EQ(verdict.triangles, 6U);
  EXPECT_EQ(verdict.faces, 80'005U);
}

/// Any quads and triangles of points that make all figures different numbers.
PolygonMesh any_shapes(std::size_t faces) {
  Random random(9);
  PolygonMesh mesh;
  while (mesh.points.size() < 1000) mesh.points.push_back({random.uniform(), random.uniform()});
  while (mesh.face_count() < faces) {
    std::array<VertexId, 4> corners;
    for (VertexId& v : corners) v = static_cast<VertexId>(random.below(mesh.points.size()));
    mesh.add_face(std::span(corners).first(mesh.face_count() % 7 == 0 ? 3 : 4));
  }
  return mesh;
}

TEST(QualityBlocks, MeasureAllFacesOnAnyNumberOfThreads) {
  const std::array<VertexId, 4> corners = {0, 1, 2, 3};
  for (const std::size_t faces : {16'384U, 16'385U, 50'000U}) {  // a block, and one face more
    SCOPED_TRACE(faces);
    const PolygonMesh mesh = any_shapes(faces);
    Quality sum;  // of each face alone
    double shape = 0;
    for (std::size_t f = 0; f < faces; ++f) {
      PolygonMesh one;
      for (const VertexId v : mesh.face(f)) one.points.push_back(mesh.points[v]);
      one.add_face(std::span(corners).first(one.points.size()));
      const Quality q = measure_quality(one);
      sum.quads += q.quads;
      sum.triangles += q.triangles;
      sum.strictly_convex += q.strictly_convex;
      sum.non_convex += q.non_convex;
      sum.max_edge = std::max(sum.max_edge, q.max_edge);
      sum.max_angle = std::max(sum.max_angle, q.max_angle);
      for (std::size_t i = 0; i < 36; ++i) sum.angle_histogram[i] += q.angle_histogram[i];
      for (std::size_t i = 0; i < 10; ++i) sum.shape_histogram[i] += q.shape_histogram[i];
      shape += q.mean_shape;
    }
    const Quality one = on_threads(1, [&] { return measure_quality(mesh); });
    test::expect_same_counts(one, sum);
    EXPECT_EQ(one.max_edge, sum.max_edge);
    EXPECT_EQ(one.max_angle, sum.max_angle);
    EXPECT_NEAR(one.mean_shape, shape / static_cast<double>(sum.quads), 1e-12);
    for (const int threads : {2, 4}) {
      const Quality other = on_threads(threads, [&] { return measure_quality(mesh); });
      EXPECT_EQ(other.mean_shape, one.mean_shape);
      EXPECT_EQ(other.mean_edge, one.mean_edge);
      EXPECT_EQ(other.median_aspect, one.median_aspect);
      EXPECT_EQ(other.max_aspect, one.max_aspect);
      EXPECT_EQ(other.edges, one.edges);
    }
  }
}

TEST(QualityBlocks, TheEdgesOfSquares) {
  const Quality q = measure_quality(squares());
  EXPECT_EQ(q.edges, 2U * 300 * 301);
  EXPECT_EQ(q.mean_edge, 1);
  EXPECT_EQ(q.min_shape, 1);
  EXPECT_EQ(q.median_aspect, 1);
}

TEST(QualityBlocks, TheFirstFaceThatIsNoneIsNamed) {
  PolygonMesh mesh = squares();
  for (const std::size_t f : {80'000U, 40'000U}) mesh.face_vertex[4 * f + 2] = 1'000'000;
  for (const int threads : {1, 2, 4}) {
    try {
      on_threads(threads, [&] { return measure_quality(mesh); });
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kIndexOutOfRange);
      EXPECT_EQ(error.culprits(), (Culprits{40'000, 1'000'000}));
    }
  }
}

TEST(CertifyBlocks, AFaceTwiceIsARepeatedEdge) {
  PolygonMesh mesh = squares();
  const std::vector<VertexId> copy(mesh.face(3).begin(), mesh.face(3).end());
  mesh.add_face(copy);
  EXPECT_EQ(judged(mesh).fault, Fault::kRepeatedEdge);
}

}  // namespace
}  // namespace quadloom
