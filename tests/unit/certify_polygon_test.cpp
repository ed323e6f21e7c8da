// certify_polygons and certify_mesh: good meshes pass, each kind of damage is found.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "certify/outline.hpp"
#include "core/random.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/generate.hpp"

namespace quadloom {
namespace {

CertifyOptions triangles() {
  CertifyOptions options;
  options.corners = 3;
  return options;
}

PolygonMesh mesh_of(const std::vector<Polygon>& polygons, std::vector<Point> inner = {}) {
  PlanarInput input;
  input.polygons = polygons;
  input.points = std::move(inner);
  return to_polygon_mesh(constrained_delaunay(input).mesh);
}

PolygonMesh without_face(const PolygonMesh& mesh, std::size_t gone) {
  PolygonMesh out;
  out.points = mesh.points;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (f != gone) out.add_face(mesh.face(f));
  }
  return out;
}

void expect_fault(const Certificate& c, Fault fault, const std::string& words = {}) {
  EXPECT_EQ(c.fault, fault) << c.sentence;
  EXPECT_NE(c.sentence.find(words), std::string::npos) << c.sentence;
}

std::vector<Point> box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

TEST(CertifyPolygons, TriangulationsOfEveryKind) {
  for (const PolygonGenerator& g : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(std::string(g.name) + " 60, seed " + std::to_string(seed));
      const Polygon polygon = with_holes(g.make(60, seed), 15, seed);
      const PolygonMesh mesh = mesh_of({polygon});
      const std::vector<Polygon> wanted = {polygon};
      const Certificate c = certify_polygons(mesh, wanted, {}, triangles());
      ASSERT_TRUE(c.ok()) << c.sentence;
      std::size_t corners = 0;
      for (const auto& ring : polygon.rings) corners += ring.size();
      EXPECT_EQ(c.boundary, corners);
      EXPECT_EQ(c.points, corners);
      ASSERT_TRUE(certify_mesh(mesh, mesh, triangles()).ok());
      // Any face less is found, by the boundary or since a point is gone.
      Random random(seed);
      const PolygonMesh less = without_face(mesh, random.below(mesh.face_count()));
      const Fault fault = certify_polygons(less, wanted, {}, triangles()).fault;
      EXPECT_TRUE(fault == Fault::kBoundary || fault == Fault::kMissingPoint);
      EXPECT_EQ(certify_mesh(less, mesh, triangles()).fault, fault);
      // So is a face more: with a hole less in the polygon, the hole is not covered.
      std::vector<Polygon> filled = wanted;
      filled[0].rings.pop_back();
      expect_fault(certify_polygons(mesh, filled, {}, triangles()), Fault::kBoundary,
                   "is not on the given boundary");
    }
  }
}

TEST(CertifyPolygons, PartsThatTouchAndShareEdges) {
  const std::vector<Polygon> parts = {{{box(0, 0, 10, 10), {{10, 5}, {7, 6}, {7, 4}}}},
                                      {{box(10, -5, 5, 5)}},
                                      {{box(0, 10, 10, 10)}}};
  const std::vector<Point> inner = {{3, 3}, {5, 15}};
  const PolygonMesh mesh = mesh_of(parts, inner);
  const Certificate c = certify_polygons(mesh, parts, inner, triangles());
  EXPECT_TRUE(c.ok()) << c.sentence;
  EXPECT_EQ(c.boundary, 14U);
  const std::vector<Point> more = {{3, 3}, {5, 15}, {1, 1}};
  expect_fault(certify_polygons(mesh, parts, more, triangles()), Fault::kMissingPoint);
}

// A point on an edge, and one outside it:
//
//    3---2      the square, one triangle and a Steiner point 4
//    | / |  .4
//    0---1
TEST(CertifyPolygons, SteinerPointsOnAndOutsideTheBoundary) {
  const std::vector<Polygon> square = {{{box(0, 0, 4, 4)}}};
  PolygonMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {6, 2}};
  const auto face = [&](std::array<VertexId, 3> corners) { mesh.add_face(corners); };
  face({0, 1, 2});
  face({0, 2, 3});
  face({1, 4, 2});
  expect_fault(certify_polygons(mesh, square, {}, triangles()), Fault::kBoundary,
               "the given boundary edge from (4, 0) to (4, 4) is not");
  CertifyOptions options = triangles();
  options.outer_steiner = true;
  const Certificate outside = certify_polygons(mesh, square, {}, options);
  EXPECT_TRUE(outside.ok()) << outside.sentence;
  EXPECT_EQ(outside.steiner, 1U);

  mesh.points[4] = {4, 1};
  mesh.face_vertex = {0, 1, 4, 0, 2, 3, 0, 4, 2};
  const Certificate on_edge = certify_polygons(mesh, square, {}, triangles());
  EXPECT_TRUE(on_edge.ok()) << on_edge.sentence;
  options = triangles();
  options.steiner_inside = true;
  expect_fault(certify_polygons(mesh, square, {}, options), Fault::kSteinerOnBoundary);
  options = triangles();
  options.steiner_at_most = 0;
  expect_fault(certify_polygons(mesh, square, {}, options), Fault::kTooManySteiner);
}

// A ribbon of squares that goes once around and on over its own beginning: every face is fine and
// every edge fits, but the boundary is that of no region.
TEST(CertifyPolygons, AMeshThatOverlapsItself) {
  PolygonMesh ribbon;
  const std::vector<Point> path = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 1}, {7, 1.5}};
  for (const Point p : path) {
    ribbon.points.push_back({p.x, p.y});
    ribbon.points.push_back({4 + (p.x - 4) * 0.25, 4 + (p.y - 4) * 0.25});
  }
  for (VertexId i = 0; i + 1 < path.size(); ++i) {
    ribbon.add_face(std::array<VertexId, 4>{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  }
  const Certificate c = certify_mesh(ribbon, ribbon);
  expect_fault(c, Fault::kBoundary, "meet");
}

std::vector<certify::DirectedEdge> cycle(VertexId first, VertexId size) {
  std::vector<certify::DirectedEdge> edges;
  for (VertexId i = 0; i < size; ++i) edges.push_back({first + i, first + (i + 1) % size});
  return edges;
}

TEST(CertifyPolygons, WindingNumbers) {
  PolygonMesh mesh;
  for (const auto& ring : {box(0, 0, 9, 9), box(2, 2, 5, 5), box(3, 3, 1, 1)}) {
    mesh.points.insert(mesh.points.end(), ring.begin(), ring.end());
  }
  const auto once = cycle(0, 4);
  EXPECT_EQ(certify::judge_winding(mesh, once).sentence, "");
  auto twice = once;
  for (const auto e : cycle(4, 4)) twice.push_back(e);
  EXPECT_NE(certify::judge_winding(mesh, twice).sentence.find(" 2 times"), std::string::npos);
  auto hole = once;
  for (const auto e : cycle(4, 4)) hole.push_back({e.to, e.from});
  EXPECT_EQ(certify::judge_winding(mesh, hole).sentence, "");
  auto island = hole;
  for (const auto e : cycle(8, 4)) island.push_back(e);
  EXPECT_EQ(certify::judge_winding(mesh, island).sentence, "");
  std::vector<certify::DirectedEdge> clockwise;
  for (const auto e : once) clockwise.push_back({e.to, e.from});
  EXPECT_NE(certify::judge_winding(mesh, clockwise).sentence.find(" -1 times"), std::string::npos);
}

TEST(CertifyPolygons, SourcesThatAreNoMesh) {
  PolygonMesh good = mesh_of({{{box(0, 0, 4, 4)}}});
  PolygonMesh bad = good;
  bad.face_vertex[1] = 77;
  EXPECT_THROW(certify_mesh(good, bad, triangles()), Error);
  bad = good;
  bad.add_face(std::vector<VertexId>(good.face(0).begin(), good.face(0).end()));
  EXPECT_THROW(certify_mesh(good, bad, triangles()), Error);
  EXPECT_THROW(certify_mesh(good, PolygonMesh{}, triangles()), Error);
  EXPECT_THROW(certify_polygons(good, {}, {}, triangles()), Error);
}

}  // namespace
}  // namespace quadloom
