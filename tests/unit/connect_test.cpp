#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "quadloom/kernel.hpp"
#include "support/connected_checks.hpp"
#include "support/surfaces.hpp"

namespace quadloom {
namespace {

using test::check_connected;

PolygonMesh faces(std::vector<Point> points, const std::vector<std::vector<VertexId>>& faces) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  test::set_faces(mesh, faces);
  return mesh;
}

struct Refusal {
  ErrorCode code = ErrorCode::kCancelled;
  std::string sentence;
  std::vector<std::size_t> culprits;
};

/// The error that the mesh is refused with; kCancelled if it is not.
Refusal refusal(const PolygonMesh& mesh, const std::vector<double>& z = {},
                const ConnectOptions& options = {}) {
  try {
    connect_triangles(mesh, z, options);
  } catch (const Error& error) {
    return {error.code(), error.what(), error.culprits()};
  }
  return {};
}

const std::vector<Point> kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST(Connect, TwoTrianglesAndAQuad) {
  const auto mesh = faces({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}, {2, 0}, {2, 1}},
                          {{0, 1, 2}, {2, 3, 0}, {1, 5, 6, 2}});
  const auto out = connect_triangles(mesh);
  check_connected(out, 7);
  EXPECT_EQ(out.triangles.mesh.points, mesh.points);
  EXPECT_EQ(out.source_face, (std::vector<std::uint32_t>{0, 1, 2, 2}));
  EXPECT_EQ(out.unused_vertices, 1U);
  EXPECT_EQ(out.components, 1U);
  EXPECT_EQ(out.boundary_cycles, 1U);
  EXPECT_EQ(out.boundary_edges, 6U);
  EXPECT_EQ(out.triangles.given_pair[0], kNone);
  EXPECT_NE(out.triangles.given_pair[2], kNone);
  EXPECT_EQ(connect_triangles(faces(kSquare, {{0, 1, 2}})).triangles.given_pair.size(), 0U);
}

TEST(Connect, QuadsAreCutInside) {
  // A dart at each corner, both ways around; a flat corner; the diagonal of Delaunay.
  const std::vector<Point> dart = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    std::vector<VertexId> q = {i, (i + 1) % 4, (i + 2) % 4, (i + 3) % 4};
    for (int turned = 0; turned < 2; ++turned) {
      const auto out = connect_triangles(faces(dart, {q}));
      check_connected(out, 4);
      EXPECT_EQ(out.turned_faces, static_cast<std::size_t>(turned));
      EXPECT_EQ(out.triangles.mesh.triangle_count(), 2U);
      std::reverse(q.begin(), q.end());
    }
  }
  check_connected(connect_triangles(faces({{0, 0}, {1, 0}, {2, 0}, {1, 2}}, {{0, 1, 2, 3}})), 4);
  const auto out = connect_triangles(faces({{-9, 0}, {0, -1}, {9, 0}, {0, 1}}, {{0, 1, 2, 3}}));
  const HalfedgeId diagonal = out.triangles.given_pair[0];
  EXPECT_EQ(out.triangles.mesh.origin(diagonal) % 2, 1U);
}

TEST(Connect, QuadsThatAreNone) {
  EXPECT_EQ(refusal(faces(kSquare, {{0, 2, 1, 3}})).culprits, (std::vector<std::size_t>{0}));
  EXPECT_EQ(refusal(faces({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {{0, 1, 2, 3}})).code,
            ErrorCode::kBadMesh);
  EXPECT_EQ(refusal(faces({{0, 0}, {2, 0}, {1, 0}, {1, 2}}, {{0, 1, 2, 3}})).code,
            ErrorCode::kBadMesh);
  EXPECT_EQ(refusal(faces(kSquare, {{0, 1, 0, 2}})).code, ErrorCode::kBadMesh);
}

TEST(Connect, TrianglesWrittenAsQuads) {
  for (const auto& q :
       {std::vector<VertexId>{0, 1, 2, 2}, {0, 0, 1, 2}, {0, 1, 1, 2}, {0, 1, 2, 0}}) {
    const auto out = connect_triangles(faces(kSquare, {q}), {}, {.faulty = FaultyFaces::kRefuse});
    check_connected(out, 4);
    EXPECT_EQ(out.triangles.mesh.triangle_count(), 1U);
    EXPECT_EQ(connect_triangles(faces(kSquare, {q}), std::vector<double>{0, 0, 1, 0}).space,
              Space::kPlane);
  }
}

TEST(Connect, RefusesWithTheCulprit) {
  EXPECT_EQ(refusal(PolygonMesh{}).code, ErrorCode::kTooFewPoints);
  EXPECT_EQ(refusal(faces(kSquare, {{0, 1, 2}}), {1, 2}).code, ErrorCode::kBadMesh);
  EXPECT_EQ(refusal(faces(kSquare, {{0, 1, 2}, {0, 1}})).culprits, (std::vector<std::size_t>{1}));
  auto out_of_range = refusal(faces(kSquare, {{0, 1, 7}}));
  EXPECT_EQ(out_of_range.code, ErrorCode::kIndexOutOfRange);
  EXPECT_EQ(out_of_range.culprits, (std::vector<std::size_t>{0, 7}));
  auto mesh = faces(kSquare, {{0, 1, 2}});
  mesh.points[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(mesh).code, ErrorCode::kNotFinite);
  EXPECT_EQ(refusal(mesh).culprits, (std::vector<std::size_t>{3}));
  EXPECT_EQ(refusal(faces(kSquare, {{0, 1, 2}}), {0, 0, 0, HUGE_VAL}).code, ErrorCode::kNotFinite);
  mesh = faces(kSquare, {{0, 1, 2}});
  mesh.face_begin.back() = 2;
  EXPECT_EQ(refusal(mesh).code, ErrorCode::kBadMesh);
}

TEST(Connect, EdgesOfThreeFacesAndTwoOnOneSide) {
  const std::vector<Point> p = {{0, 0}, {2, 0}, {1, 1}, {1, -1}, {1, 2}};
  EXPECT_EQ(refusal(faces(p, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})).culprits,
            (std::vector<std::size_t>{0, 1}));
  const auto one_side = refusal(faces(p, {{0, 1, 2}, {0, 4, 1}}));
  EXPECT_EQ(one_side.culprits, (std::vector<std::size_t>{0, 1}));
  EXPECT_NE(one_side.sentence.find("one side"), std::string::npos) << one_side.sentence;
}

TEST(Connect, EqualVertices) {
  // Two triangles of a square, each with its own vertices.
  const auto mesh =
      faces({{0, 0}, {2, 0}, {2, 2}, {0, 0}, {2, 2}, {0, 2}, {-0.0, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const auto refused = refusal(mesh);
  EXPECT_EQ(refused.culprits, (std::vector<std::size_t>{0, 3}));
  EXPECT_NE(refused.sentence.find("merging"), std::string::npos);
  const auto merged = connect_triangles(mesh, {}, {.equal = EqualVertices::kMerge});
  check_connected(merged, 7);
  EXPECT_EQ(merged.input_to_vertex, (std::vector<VertexId>{0, 1, 2, 0, 2, 3, 0}));
  EXPECT_EQ(merged.components, 1U);
  EXPECT_EQ(merged.boundary_edges, 4U);
  // Unused vertices may be anywhere, used ones at the same place in space too.
  EXPECT_EQ(connect_triangles(faces({{0, 0}, {2, 0}, {2, 2}, {0, 0}}, {{0, 1, 2}})).components, 1U);
  const auto seam = connect_triangles(mesh, {}, {.space = Space::kSurface});
  check_connected(seam, 7);
  EXPECT_EQ(seam.components, 2U);
}

TEST(Connect, MergedFacesThatShrinkToAnEdge) {
  const auto mesh = faces({{0, 0}, {2, 0}, {2, 2}, {0, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto out = connect_triangles(mesh, {}, {.equal = EqualVertices::kMerge});
  EXPECT_EQ(out.flat_faces, 1U);
  EXPECT_EQ(out.source_face, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(
      refusal(mesh, {}, {.faulty = FaultyFaces::kRefuse, .equal = EqualVertices::kMerge}).culprits,
      (std::vector<std::size_t>{1}));
}

TEST(Connect, SpaceOfItself) {
  const auto mesh = faces(kSquare, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(connect_triangles(mesh).space, Space::kPlane);
  EXPECT_EQ(connect_triangles(mesh, std::vector<double>{5, 5, 5, 5}).space, Space::kPlane);
  EXPECT_EQ(connect_triangles(mesh, std::vector<double>{5, 6, 5, 7}).space, Space::kPlane);
  const auto turned = faces(kSquare, {{0, 1, 2}, {0, 3, 2}});
  EXPECT_EQ(connect_triangles(turned).turned_faces, 1U);
  EXPECT_EQ(connect_triangles(turned, std::vector<double>{5, 6, 5, 7}).space, Space::kSurface);
  const auto cube = test::cube(true);
  EXPECT_EQ(connect_triangles(cube.mesh, cube.z).space, Space::kSurface);
  // Two roofs over each other: seen from above both turn left.
  auto roofs = faces({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(connect_triangles(roofs, std::vector<double>{0, 0, 0, 1, 1, 1}).space, Space::kSurface);
  EXPECT_EQ(connect_triangles(mesh, {}, {.space = Space::kSurface}).triangles.z,
            (std::vector<double>{0, 0, 0, 0}));
}

TEST(Connect, SpaceOfFacesOfAnySize) {
  const auto pentagon = faces({{0, 0}, {4, 0}, {4, 2}, {2, 4}, {0, 2}}, {{0, 1, 2, 3, 4}});
  EXPECT_EQ(space_of(pentagon, {}), Space::kPlane);
  EXPECT_EQ(space_of(pentagon, std::vector<double>{1, 2, 3, 4, 5}), Space::kPlane);
  const auto two = faces({{0, 0}, {4, 0}, {4, 2}, {2, 4}, {0, 2}}, {{0, 1, 2, 3, 4}, {1, 0, 2}});
  EXPECT_EQ(space_of(two, std::vector<double>{1, 2, 3, 4, 5}), Space::kSurface);
  EXPECT_THROW(space_of(two, std::vector<double>{1, 2}), Error);
}

TEST(Connect, ClockwiseAsAWhole) {
  const auto mesh = faces(kSquare, {{0, 2, 1}, {0, 3, 2}});
  EXPECT_EQ(connect_triangles(mesh, {}, {.faulty = FaultyFaces::kRefuse}).turned_faces, 2U);
  EXPECT_EQ(refusal(faces(kSquare, {{0, 1, 2}, {0, 3, 2}}), {}, {.faulty = FaultyFaces::kRefuse})
                .culprits,
            (std::vector<std::size_t>{1}));
}

TEST(Connect, ClosedSurfaces) {
  for (const bool quads : {false, true}) {
    const auto cube = test::cube(quads);
    const auto out = connect_triangles(cube.mesh, cube.z);
    check_connected(out, 8);
    EXPECT_EQ(out.boundary_cycles, 0U);
    EXPECT_EQ(test::euler_characteristic(out), 2);
    const auto torus = test::torus(6, 9, quads);
    const auto ring = connect_triangles(torus.mesh, torus.z);
    check_connected(ring, 54);
    EXPECT_EQ(test::euler_characteristic(ring), 0);
    EXPECT_EQ(ring.triangles.given_pair.size(), quads ? 108U : 0U);
  }
}

TEST(Connect, OneSidedSurface) {
  const auto strip = test::moebius_strip(9);
  const auto refused = refusal(strip.mesh, strip.z);
  EXPECT_EQ(refused.code, ErrorCode::kBadMesh);
  EXPECT_EQ(refused.culprits.size(), 2U);
  EXPECT_NE(refused.sentence.find("one side"), std::string::npos);
}

TEST(Connect, BowTiesAndComponents) {
  const auto out =
      connect_triangles(faces({{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 1, 2}, {0, 3, 4}}));
  check_connected(out, 5);
  EXPECT_EQ(out.components, 2U);
  EXPECT_EQ(out.boundary_cycles, 2U);
}

//   3-------2
//   |     / |     1 is in the middle of 0-4, given as a triangle without area
//   |   /   |
//   0---1---4
TEST(Connect, FlatTriangles) {
  const std::vector<Point> p = {{0, 0}, {1, 0}, {2, 2}, {0, 2}, {2, 0}, {1, -3}};
  // Below it a triangle: flipped into that.
  const auto mesh = faces(p, {{0, 1, 2}, {1, 4, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}});
  const auto out = connect_triangles(mesh);
  check_connected(out, 6);
  EXPECT_EQ(out.flat_faces, 1U);
  EXPECT_EQ(out.triangles.mesh.triangle_count(), 5U);
  EXPECT_EQ(out.source_face, (std::vector<std::uint32_t>{0, 1, 2, 4, 4}));
  EXPECT_EQ(out.boundary_edges, 5U);
  EXPECT_EQ(refusal(mesh, {}, {.faulty = FaultyFaces::kRefuse}).culprits,
            (std::vector<std::size_t>{3}));
  // Nothing below it: left out.
  const auto rim = connect_triangles(faces(p, {{0, 1, 2}, {0, 1, 4}, {1, 4, 2}}));
  check_connected(rim, 6);
  EXPECT_EQ(rim.triangles.mesh.triangle_count(), 2U);
  EXPECT_EQ(rim.boundary_edges, 4U);
  // Nothing else at all.
  EXPECT_EQ(refusal(faces(p, {{0, 1, 4}})).code, ErrorCode::kTooFewPoints);
}

TEST(Connect, FlatTriangleAtAQuad) {
  const auto out = connect_triangles(faces({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {1, -1}},
                                           {{0, 2, 3, 4}, {0, 1, 2}, {0, 5, 1}, {1, 5, 2}}));
  check_connected(out, 6);
  EXPECT_EQ(out.triangles.mesh.triangle_count(), 5U);
  EXPECT_TRUE(out.triangles.given_pair.empty());  // the quad has become a pentagon
}

TEST(Connect, FlatTrianglesThatPointAtEachOther) {
  //  0--1-----2    0 1 3 2 on a line in the order of x; triangles 0 1 2 and 2 3 0 share their longest
  //   \____3_/     edge; above and below triangles with the other edges
  const auto out =
      connect_triangles(faces({{0, 0}, {1, 0}, {9, 0}, {5, 0}, {4, 4}, {4, -4}},
                              {{0, 1, 2}, {2, 3, 0}, {0, 4, 1}, {1, 4, 2}, {0, 3, 5}, {3, 2, 5}}));
  check_connected(out, 6);
  EXPECT_EQ(out.flat_faces, 2U);
  EXPECT_EQ(out.triangles.mesh.triangle_count(), 6U);
  EXPECT_EQ(out.boundary_edges, 4U);
}

TEST(Connect, FlatTrianglesInSpace) {
  const auto mesh =
      faces({{0, 0}, {1, 1}, {3, 3}, {0, 2}, {2, 0}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 4}});
  const std::vector<double> z = {0, 2, 6, 1, 1};
  const auto out = connect_triangles(mesh, z);
  EXPECT_EQ(out.space, Space::kSurface);
  check_connected(out, 5);
  EXPECT_EQ(out.flat_faces, 1U);
  EXPECT_EQ(out.triangles.mesh.triangle_count(), 4U);
  EXPECT_EQ(out.boundary_edges, 4U);
  // Not on the line in space, only seen from above: a triangle like others.
  EXPECT_EQ(connect_triangles(mesh, std::vector<double>{0, 2.5, 6, 1, 1}).flat_faces, 0U);
}

TEST(Connect, FlatTrianglesBeyondRepair) {
  // The same three corners twice, both without area.
  EXPECT_EQ(refusal(faces({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}, {2, 1, 0}})).code,
            ErrorCode::kBadMesh);
  // Two corners of a surface at one place.
  const auto refused = refusal(faces({{0, 0}, {1, 0}, {1, 0}, {0, 5}}, {{0, 1, 2}, {0, 2, 3}}),
                               {0, 1, 1, 2}, {.space = Space::kSurface});
  EXPECT_EQ(refused.culprits, (std::vector<std::size_t>{0}));
  EXPECT_NE(refused.sentence.find("merging"), std::string::npos);
}

TEST(Connect, DecidesByTheLastBit) {
  // The middle corner on the diagonal, and one unit in the last place off it on either side.
  for (const double y : {std::nextafter(0.3, 0), 0.3, std::nextafter(0.3, 1)}) {
    const auto mesh =
        faces({{0.1, 0.1}, {0.3, y}, {0.7, 0.7}, {0, 1}}, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}});
    if (y < 0.3) {  // the thin triangle is over the others
      EXPECT_EQ(refusal(mesh).code, ErrorCode::kBadMesh);
      continue;
    }
    const auto out = connect_triangles(mesh);
    check_connected(out, 4);
    EXPECT_EQ(out.flat_faces, y > 0.3 ? 0U : 1U);
    EXPECT_EQ(out.triangles.mesh.triangle_count(), y > 0.3 ? 3U : 2U);
  }
}

TEST(Connect, AtTheEndsOfTheRange) {
  for (const double s : {5e-324, 1e-300, 1.7e308}) {
    const auto mesh = faces({{0, 0}, {s, 0}, {s, s}, {0, s}}, {{0, 1, 2, 3}});
    check_connected(connect_triangles(mesh), 4);
    const auto out =
        connect_triangles(mesh, std::vector<double>{0, s, 0, -s}, {.space = Space::kSurface});
    check_connected(out, 4);
    EXPECT_EQ(out.turned_faces, 0U);
  }
}

TEST(SharpEdges, OfACubeAndInThePlane) {
  const auto cube = test::cube(false);
  auto mesh = connect_triangles(cube.mesh, cube.z).triangles;
  EXPECT_EQ(keep_sharp_edges(mesh, 90), 0U);
  EXPECT_EQ(keep_sharp_edges(mesh, 89.999), 12U);
  EXPECT_EQ(std::ranges::count(mesh.keep, 1), 24);
  for (HalfedgeId h = 0; h < mesh.keep.size(); ++h) {
    EXPECT_EQ(mesh.keep[h], mesh.keep[mesh.mesh.twin[h]]);
  }
  EXPECT_EQ(keep_sharp_edges(mesh, 180), 0U);
  EXPECT_EQ(std::ranges::count(mesh.keep, 1), 24);  // marks are added
  EXPECT_THROW(keep_sharp_edges(mesh, -1), Error);
  EXPECT_THROW(keep_sharp_edges(mesh, std::nan("")), Error);
  auto plane = connect_triangles(faces(kSquare, {{0, 1, 2}, {0, 2, 3}})).triangles;
  EXPECT_EQ(keep_sharp_edges(plane, 0), 0U);
}

TEST(SharpEdges, AtTheEndsOfTheRange) {
  for (const double s : {1e-300, 1.0, 1.5e308}) {
    // A roof: two squares of which one stands up.
    const auto mesh =
        faces({{-s, -s}, {s, -s}, {s, s}, {-s, s}, {s, -s}, {s, s}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
    auto roof = connect_triangles(mesh, std::vector<double>{-s, -s, -s, -s, s, s}).triangles;
    EXPECT_EQ(keep_sharp_edges(roof, 80), 1U) << s;
    EXPECT_EQ(keep_sharp_edges(roof, 95), 0U) << s;
  }
}

}  // namespace
}  // namespace quadloom
