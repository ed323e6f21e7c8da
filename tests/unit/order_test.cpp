#include <gtest/gtest.h>

#include <numeric>

#include "quadloom/certify.hpp"
#include "quadloom/strips.hpp"

namespace quadloom {
namespace {

PolygonMesh triangles(std::size_t points, const std::vector<std::array<VertexId, 3>>& faces) {
  PolygonMesh mesh;
  mesh.points.resize(points);
  for (const auto& f : faces) mesh.add_face(f);
  return mesh;
}

/// A strip of `count` triangles over the vertices 0, 1, 2, ...
PolygonMesh strip(VertexId count) {
  PolygonMesh mesh;
  mesh.points.resize(count + 2);
  for (VertexId i = 0; i < count; ++i) {
    if (i % 2 == 0) mesh.add_face(std::array{i, i + 1, i + 2});
    if (i % 2 == 1) mesh.add_face(std::array{i + 1, i, i + 2});
  }
  return mesh;
}

TEST(CertifyOrder, AcceptsAStripAsSequential) {
  for (VertexId count = 1; count < 9; ++count) {
    EXPECT_TRUE(certify_order(strip(count), OrderKind::kPath).ok());
    const Certificate verdict = certify_order(strip(count), OrderKind::kSequential);
    EXPECT_TRUE(verdict.ok()) << verdict.sentence;
    EXPECT_EQ(verdict.faces, count);
    EXPECT_EQ(certify_order(strip(count), OrderKind::kCycle).fault, Fault::kOrder);
  }
}

TEST(CertifyOrder, AcceptsAWheelAsACycleThatIsNotSequential) {
  const PolygonMesh wheel = triangles(5, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  EXPECT_TRUE(certify_order(wheel, OrderKind::kPath).ok());
  EXPECT_TRUE(certify_order(wheel, OrderKind::kCycle).ok());
  const Certificate verdict = certify_order(wheel, OrderKind::kSequential);
  EXPECT_EQ(verdict.fault, Fault::kTurns);
  EXPECT_EQ(verdict.culprits, (std::vector<std::size_t>{3}));
}

TEST(CertifyOrder, NamesTrianglesThatShareNoEdge) {
  const PolygonMesh jump = triangles(5, {{0, 1, 4}, {2, 3, 4}, {1, 2, 4}});
  const Certificate verdict = certify_order(jump, OrderKind::kPath);
  EXPECT_EQ(verdict.fault, Fault::kOrder);
  EXPECT_EQ(verdict.culprits, (std::vector<std::size_t>{0, 1}));
  // The same edge in the same direction is none that they share.
  const PolygonMesh turned = triangles(4, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(certify_order(turned, OrderKind::kPath).fault, Fault::kOrder);
}

TEST(CertifyOrder, WantsTriangles) {
  PolygonMesh mesh = strip(2);
  mesh.add_face(std::array<VertexId, 4>{0, 1, 3, 2});
  EXPECT_EQ(certify_order(mesh, OrderKind::kPath).fault, Fault::kCornerCount);
  EXPECT_EQ(certify_order({}, OrderKind::kPath).fault, Fault::kNoFaces);
  EXPECT_EQ(certify_order(triangles(2, {{0, 1, 2}}), OrderKind::kPath).fault,
            Fault::kIndexOutOfRange);
}

TEST(ReorderTriangles, KeepsNeighbours) {
  const std::vector<Point> grid = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}};
  const Triangulation mesh = delaunay(grid).mesh;
  std::vector<TriangleId> order(mesh.triangle_count());
  std::iota(order.rbegin(), order.rend(), 0U);
  const Triangulation turned = reorder_triangles(mesh, order);
  for (HalfedgeId h = 0; h < turned.twin.size(); ++h) {
    EXPECT_EQ(turned.origin(h), mesh.origin(3 * order[h / 3] + h % 3));
    if (turned.twin[h] == kNone) continue;
    EXPECT_EQ(turned.twin[turned.twin[h]], h);
    EXPECT_EQ(turned.origin(turned.twin[h]), turned.target(h));
  }
  order[0] = order[1];
  EXPECT_THROW(reorder_triangles(mesh, order), Error);
  order.pop_back();
  EXPECT_THROW(reorder_triangles(mesh, order), Error);
}

}  // namespace
}  // namespace quadloom
