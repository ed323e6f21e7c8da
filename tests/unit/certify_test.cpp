#include "quadloom/certify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "certify/boundary.hpp"
#include "certify/polygon.hpp"
#include "support/grid_mesh.hpp"

namespace quadloom {
namespace {

using test::grid_mesh;
using Face = std::vector<VertexId>;

PolygonMesh make_mesh(std::vector<Point> points, const std::vector<Face>& faces) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  for (const auto& f : faces) mesh.add_face(f);
  return mesh;
}

/// Three by three points and four quads; vertex 4 is the middle.
PolygonMesh four_quads() { return grid_mesh(2, 2); }

void expect_fault(const PolygonMesh& mesh, Fault fault, const std::string& words,
                  const std::vector<std::size_t>& culprits, const CertifyOptions& options = {},
                  std::span<const Point> input = {}) {
  const auto verdict = certify_points(mesh, input, options);
  EXPECT_FALSE(verdict.ok());
  EXPECT_EQ(verdict.fault, fault) << verdict.sentence;
  EXPECT_NE(verdict.sentence.find(words), std::string::npos) << verdict.sentence;
  EXPECT_EQ(verdict.culprits, culprits) << verdict.sentence;
}

TEST(Certify, AcceptsAGrid) {
  const auto mesh = four_quads();
  const auto verdict = certify_points(mesh, mesh.points);
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
  EXPECT_EQ(verdict.points, 9U);
  EXPECT_EQ(verdict.faces, 4U);
  EXPECT_EQ(verdict.triangles, 0U);
  EXPECT_EQ(verdict.boundary, 8U);
  EXPECT_EQ(verdict.steiner, 0U);
  EXPECT_EQ(verdict.strictly_convex, 4U);
  EXPECT_EQ(verdict.sentence, "");
}

TEST(Certify, CountsFlatAndReflexQuads) {
  // A reflex quad under a flat-cornered one and a convex one beside them.
  const auto mesh = make_mesh({{0, 0}, {4, 0}, {4, 2}, {2, 0.5}, {0, 2}, {2, 2}, {8, 0}, {8, 2}},
                              {{0, 1, 2, 3}, {0, 3, 5, 4}, {1, 6, 7, 2}});
  const auto verdict = certify_points(mesh, {}, {.triangles_allowed = 1});
  EXPECT_EQ(verdict.fault, Fault::kBoundary) << verdict.sentence;  // triangle 2 5 3 is not there
  const auto whole = make_mesh(mesh.points, {{0, 1, 2, 3}, {0, 3, 5, 4}, {1, 6, 7, 2}, {3, 2, 5}});
  const auto better = certify_points(whole, {}, {.triangles_allowed = 1});
  EXPECT_TRUE(better.ok()) << better.sentence;
  EXPECT_EQ(better.triangles, 1U);
  EXPECT_EQ(better.strictly_convex, 2U);
  EXPECT_EQ(better.non_convex, 1U);
  const auto flat = make_mesh({{0, 0}, {1, 0}, {2, 0}, {1, 2}}, {{0, 1, 2, 3}});
  EXPECT_EQ(certify_points(flat, {}).flat_cornered, 1U);
}

TEST(Certify, DuplicatesUnusedVerticesAndNegativeZerosAreWelcome) {
  auto mesh = four_quads();
  const auto input = [&] {
    auto points = mesh.points;
    points.push_back({-0.0, -0.0});
    points.push_back(points[3]);
    return points;
  }();
  mesh.points.push_back(mesh.points[3]);
  mesh.points.push_back({std::nan(""), 0});
  const auto verdict = certify_points(mesh, input);
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
  EXPECT_EQ(verdict.points, 9U);
}

TEST(Certify, CountsSteinerPoints) {
  const auto mesh = four_quads();
  const auto input = std::span(mesh.points).first(8);
  EXPECT_EQ(certify_points(mesh, input).steiner, 1U);
  expect_fault(mesh, Fault::kTooManySteiner, "1 vertices are no input points, 0 allowed", {},
               {.steiner_at_most = 0}, input);
  expect_fault(mesh, Fault::kSteinerOnBoundary, "vertex 8", {8}, {.steiner_inside = true}, input);
  auto without_middle = mesh.points;
  without_middle.erase(without_middle.begin() + 4);
  EXPECT_TRUE(certify_points(mesh, without_middle, {.steiner_inside = true}).ok());
}

TEST(Certify, OtherCornerCounts) {
  const auto hexagon = make_mesh({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 1}, {0, 2}, {1, 3}},
                                 {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 6}});
  EXPECT_EQ(certify_points(hexagon, {}, {.corners = 6}).fault, Fault::kCornerCount);
  const auto fan = make_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  const auto verdict = certify_points(fan, {}, {.corners = 3, .strictly_convex = true});
  EXPECT_TRUE(verdict.ok()) << verdict.sentence;
  EXPECT_EQ(verdict.triangles, 0U);
  EXPECT_EQ(verdict.strictly_convex, 2U);
  EXPECT_THROW(certify_points(fan, {}, {.corners = 2}), Error);
}

TEST(CertifyFaults, FacesAndIndices) {
  expect_fault({}, Fault::kNoFaces, "no faces", {});
  auto mesh = four_quads();
  mesh.face_vertex[5] = 9;
  expect_fault(mesh, Fault::kIndexOutOfRange, "face 1 (vertices 1 9", {1});
  mesh.face_vertex[5] = 1;
  expect_fault(mesh, Fault::kRepeatedCorner, "face 1", {1});
  mesh = four_quads();
  mesh.face_begin[2] = 99;
  expect_fault(mesh, Fault::kIndexOutOfRange, "beginnings", {});
  mesh.face_begin.clear();
  expect_fault(mesh, Fault::kIndexOutOfRange, "beginnings", {});
  mesh = four_quads();
  mesh.add_face(Face{0, 1, 2, 3, 4});
  expect_fault(mesh, Fault::kCornerCount, "face 4 (vertices 0 1 2 3 4) has 5 corners, expected 4",
               {4});
  mesh = four_quads();
  mesh.add_face(Face{});
  expect_fault(mesh, Fault::kCornerCount, "has 0 corners", {4});
  mesh.face_begin.back() += 2;
  mesh.face_vertex.insert(mesh.face_vertex.end(), {0, 1});
  expect_fault(mesh, Fault::kCornerCount, "has 2 corners", {4});
  mesh = four_quads();
  mesh.points[4].x = std::numeric_limits<double>::infinity();
  expect_fault(mesh, Fault::kNotFinite, "vertex 4", {4});
}

TEST(CertifyFaults, Shapes) {
  const std::vector<Point> p = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {4, 0}};
  expect_fault(make_mesh(p, {{3, 2, 1, 0}}), Fault::kNotSimple, "face 0", {0});  // clockwise
  expect_fault(make_mesh(p, {{0, 2, 1, 3}}), Fault::kNotSimple, "face 0", {0});  // bow tie
  expect_fault(make_mesh(p, {{0, 1, 5}}), Fault::kNotSimple, "(4, 0)", {0},      // no area
               {.triangles_allowed = 1});
  expect_fault(make_mesh(p, {{0, 4, 2, 4}}), Fault::kRepeatedCorner, "face 0", {0});
  expect_fault(make_mesh(p, {{0, 5, 1, 3}}), Fault::kNotSimple, "face 0", {0});  // folds back
  expect_fault(make_mesh(p, {{0, 2, 4, 3}}), Fault::kNotSimple, "face 0", {0});  // folds back
  expect_fault(make_mesh(p, {{0, 1, 2, 4}}), Fault::kNotStrictlyConvex, "flat corner", {0},
               {.strictly_convex = true});
  const std::vector<Point> dart = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
  expect_fault(make_mesh(dart, {{0, 1, 2, 3}}), Fault::kNotStrictlyConvex, "is not convex", {0},
               {.strictly_convex = true});
}

TEST(CertifyFaults, EdgesAndVertices) {
  auto mesh = four_quads();
  mesh.add_face(Face{0, 1, 4, 3});
  expect_fault(mesh, Fault::kRepeatedEdge, "face 0 (vertices 0 1 4 3) and in face 4", {0, 1});
  mesh = four_quads();  // face 3 with a vertex of its own at the middle
  mesh.points.push_back(mesh.points[4]);
  mesh.face_vertex[12] = 9;
  expect_fault(mesh, Fault::kRepeatedVertex, "vertex 4 (3, 4) and vertex 9", {4, 9});
}

TEST(CertifyFaults, MissingPoints) {
  const auto mesh = four_quads();
  auto input = mesh.points;
  input[2].x = std::nextafter(input[2].x, 9);
  input.push_back({std::nan(""), 1});
  expect_fault(mesh, Fault::kMissingPoint, "input point 2 (4.000000000000001, 2) is no vertex",
               {2, 9}, {}, input);
}

TEST(CertifyFaults, Triangles) {
  const auto mesh = make_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  expect_fault(mesh, Fault::kTooManyTriangles, "face 1", {1}, {.triangles_allowed = 1});
  EXPECT_TRUE(certify_points(mesh, {}, {.triangles_allowed = 2}).ok());
}

TEST(CertifyFaults, Boundary) {
  auto mesh = four_quads();  // a notch
  mesh.face_begin.pop_back();
  mesh.face_vertex.resize(12);
  expect_fault(mesh, Fault::kBoundary, "turns right at vertex 4", {4});
  mesh = make_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {3, 0}, {3, 1}, {2, 1}},
                   {{0, 1, 2, 3}, {4, 5, 6, 7}});
  expect_fault(mesh, Fault::kBoundary, "several cycles", {0, 4});
  mesh = make_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}},
                   {{0, 1, 2, 3}, {2, 4, 5, 6}});
  expect_fault(mesh, Fault::kBoundary, "twice through vertex 2", {2});
  mesh = grid_mesh(3, 3);  // a hole
  mesh.face_vertex.erase(mesh.face_vertex.begin() + 16, mesh.face_vertex.begin() + 20);
  mesh.face_begin.pop_back();
  expect_fault(mesh, Fault::kBoundary, "several cycles", {0, 6});
}

TEST(CertifyFaults, TwiceAroundACentre) {
  // Six triangles around vertex 0 that turn by two full turns: each face is right, the boundary
  // only turns left, and everything is covered twice.
  const auto mesh = make_mesh({{0, 0}, {8, 0}, {-5, 8}, {-5, -8}, {9, 0}, {-6, 9}, {-6, -9}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
  expect_fault(mesh, Fault::kBoundary, "more than once", {3}, {.corners = 3});
}

TEST(CertifyFaults, OneUlp) {
  // A side of three points bent inwards, and outwards, by the least that doubles can tell.
  const double least = std::numeric_limits<double>::denorm_min();
  const auto mesh_with = [](double y) {
    return make_mesh({{0, 0}, {1, y}, {2, 0}, {1, 1}}, {{0, 1, 2, 3}});
  };
  EXPECT_EQ(certify_points(mesh_with(0), {}).flat_cornered, 1U);
  EXPECT_EQ(certify_points(mesh_with(-least), {}).strictly_convex, 1U);
  expect_fault(mesh_with(least), Fault::kBoundary, "turns right at vertex 1", {1});
}

TEST(CertifyBoundary, FoldingBackAndOpenPaths) {
  const auto mesh = make_mesh({{0, 0}, {3, 0}, {4, 0}, {2, 2}}, {});
  EXPECT_NE(certify::judge_boundary(mesh, {{0, 2}, {2, 1}, {1, 3}, {3, 0}}).sentence.find("folds"),
            std::string::npos);
  EXPECT_NE(certify::judge_boundary(mesh, {{0, 2}, {2, 1}}).sentence.find("not a closed cycle"),
            std::string::npos);
  EXPECT_NE(certify::judge_boundary(mesh, {}).sentence.find("no boundary"), std::string::npos);
}

TEST(JudgePolygon, ManyCorners) {
  // A comb of 200 teeth, then one tooth longer than the comb is high.
  std::vector<Point> comb;
  const int teeth = 200;
  for (int i = 0; i < teeth; ++i) {
    comb.push_back({2.0 * i, 0});
    comb.push_back({2.0 * i + 1, 9});
  }
  comb.push_back({2.0 * teeth, 10});
  comb.push_back({-1, 10});
  const auto verdict = certify::judge_polygon(comb);
  EXPECT_TRUE(verdict.simple);
  EXPECT_EQ(verdict.smallest_turn, -1);
  auto broken = comb;
  broken[201].y = 10;  // touches the top from below
  EXPECT_FALSE(certify::judge_polygon(broken).simple);
  broken[201].y = std::nextafter(10.0, 0.0);
  EXPECT_TRUE(certify::judge_polygon(broken).simple);
  std::ranges::reverse(comb);
  EXPECT_FALSE(certify::judge_polygon(comb).simple);
}

}  // namespace
}  // namespace quadloom
