// The subdivision of triangulations, mixed meshes, polygons and surfaces: strictly convex quads, on every
// kind of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "kernel/chart.hpp"
#include "quadloom/quadloom.hpp"
#include "quadrangulate/subdivision.hpp"

namespace quadloom {
namespace {

TriangleResult subdivide(const TriangleMesh& mesh) {
  return quadrangulate_triangles(mesh, {.method = TriangleMethod::kSubdivide});
}

std::size_t count_edges(const Triangulation& mesh) {
  std::size_t edges = 0;
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone || h < mesh.twin[h]) ++edges;
  }
  return edges;
}

/// A quad that is split into four counts once in `split`.
void expect_counts(const TriangleMesh& source, const TriangleResult& result, std::size_t split) {
  const std::size_t triangles = source.mesh.triangle_count() - 2 * split;
  const std::size_t edges = count_edges(source.mesh) - split;
  ASSERT_EQ(result.input_vertices, source.mesh.points.size());
  ASSERT_EQ(result.mesh.triangle_count(), 0U);
  ASSERT_EQ(result.mesh.quad_count(), 3 * triangles + 4 * split);
  ASSERT_EQ(result.steiner.size(), edges + triangles + split);
  ASSERT_EQ(result.mesh.points.size(), result.input_vertices + result.steiner.size());
  ASSERT_EQ(result.z.size(), source.z.empty() ? 0 : result.mesh.points.size());
  ASSERT_EQ(result.statistics.triangles, source.mesh.triangle_count());
  ASSERT_EQ(result.statistics.boundary_edges,
            static_cast<std::size_t>(std::ranges::count(source.mesh.twin, kNone)));
  for (std::size_t v = 0; v < result.input_vertices; ++v) {
    ASSERT_EQ(result.mesh.points[v], source.mesh.points[v]);
  }
}

/// Parents are an edge's ends or a triangle's corners, each edge has one point, and kinds are true.
void expect_steiner(const TriangleMesh& source, const TriangleResult& result) {
  std::map<std::pair<VertexId, VertexId>, int> edge_points;
  std::size_t on_boundary = 0;
  for (std::size_t i = 0; i < result.steiner.size(); ++i) {
    const SteinerPoint& s = result.steiner[i];
    ASSERT_EQ(s.vertex, result.input_vertices + i);
    ASSERT_LT(std::max(s.parents[0], s.parents[1]), result.input_vertices);
    if (s.parents[2] != kNone) {
      ASSERT_LT(s.parents[2], result.input_vertices);
      ASSERT_EQ(s.kind, SteinerKind::kInner);
      continue;
    }
    ASSERT_EQ((edge_points[std::minmax(s.parents[0], s.parents[1])]++), 0);
    if (s.kind == SteinerKind::kInner) continue;
    ++on_boundary;
    if (!source.z.empty()) continue;
    const int side = orient2d(result.mesh.points[s.parents[0]], result.mesh.points[s.parents[1]],
                              result.mesh.points[s.vertex]);
    ASSERT_EQ(side, s.kind == SteinerKind::kOnEdge ? 0 : -1);
  }
  ASSERT_EQ(on_boundary, result.statistics.boundary_edges);
}

/// Each quad has one corner of the source, which its source triangles have too; together they have each
/// triangle three times or its given quad four times.
void expect_sources(const TriangleMesh& source, const TriangleResult& result) {
  ASSERT_EQ(result.quad_source.size(), result.mesh.quad_count());
  std::map<std::array<TriangleId, 2>, std::set<VertexId>> corners;
  for (QuadId q = 0; q < result.mesh.quad_count(); ++q) {
    std::vector<VertexId> given;
    for (QuadId i = 4 * q; i < 4 * q + 4; ++i) {
      if (result.mesh.quad_vertex[i] < result.input_vertices)
        given.push_back(result.mesh.quad_vertex[i]);
    }
    ASSERT_EQ(given.size(), 1U);
    corners[result.quad_source[q]].insert(given[0]);
  }
  for (const auto& [triangles, found] : corners) {
    std::set<VertexId> wanted;
    for (const TriangleId t : triangles) {
      if (t == kNone) continue;
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) wanted.insert(source.mesh.origin(h));
    }
    ASSERT_EQ(found, wanted);
  }
}

void expect_sound(const TriangleMesh& source, const TriangleResult& result, std::size_t split) {
  ASSERT_NO_FATAL_FAILURE(expect_counts(source, result, split));
  ASSERT_NO_FATAL_FAILURE(expect_steiner(source, result));
  ASSERT_NO_FATAL_FAILURE(expect_sources(source, result));
}

constexpr CertifyOptions kWanted = {.outer_steiner = true, .strictly_convex = true};

void expect_planar(const TriangleMesh& source, const TriangleResult& result,
                   std::size_t split = 0) {
  ASSERT_NO_FATAL_FAILURE(expect_sound(source, result, split));
  const Certificate verdict =
      certify_mesh(to_polygon_mesh(result.mesh), to_polygon_mesh(source.mesh), kWanted);
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
}

PlanarResult subdivide(const std::vector<Polygon>& polygons) {
  PlanarInput input;
  input.polygons = polygons;
  return quadrangulate_polygons(input, {.method = TriangleMethod::kSubdivide});
}

void expect_polygon(const Polygon& polygon, std::size_t* outside = nullptr) {
  const PlanarResult result = subdivide(std::vector{polygon});
  TriangleMesh source;
  source.mesh = result.triangulation.mesh;
  ASSERT_NO_FATAL_FAILURE(expect_planar(source, result.quads));
  const Certificate verdict =
      certify_polygons(to_polygon_mesh(result.quads.mesh), std::array{polygon}, {}, kWanted);
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
  ASSERT_EQ(result.quads.statistics.parts, 1U);
  for (const SteinerPoint& p : result.quads.steiner) {
    if (outside != nullptr && p.kind == SteinerKind::kOutside) ++*outside;
  }
}

Polygon mapped(const Polygon& polygon, auto&& map) {
  Polygon out = polygon;
  for (auto& ring : out.rings) {
    for (Point& p : ring) p = map(p);
  }
  return out;
}

TEST(SubdivideMesh, EveryPolygonGenerator) {
  for (const PolygonGenerator& kind : polygon_generators()) {
    for (const std::size_t n : {5U, 12U, 60U, 400U}) {
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(n) + " seed " +
                     std::to_string(seed));
        const Polygon polygon = kind.make(n, seed);
        ASSERT_NO_FATAL_FAILURE(expect_polygon(polygon));
        ASSERT_NO_FATAL_FAILURE(expect_polygon(with_holes(polygon, n / 4, seed)));
      }
    }
  }
}

// Turned by an angle, corners have no short coordinates any more: about half of the edges have no double
// on them, and straight runs are not straight.
TEST(SubdivideMesh, TurnedPolygonsOfEveryMagnitude) {
  std::size_t outside = 0;
  for (const PolygonGenerator& kind : polygon_generators()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      for (const int exponent : {-900, -40, 0, 900}) {
        SCOPED_TRACE(std::string(kind.name) + " seed " + std::to_string(seed) + " times 2^" +
                     std::to_string(exponent));
        const double angle = 0.1 + static_cast<double>(seed);
        const double c = std::cos(angle), s = std::sin(angle);
        const Polygon polygon = mapped(with_holes(kind.make(60, seed), 10, seed), [=](Point p) {
          return Point{std::ldexp(c * p.x - s * p.y, exponent),
                       std::ldexp(s * p.x + c * p.y, exponent)};
        });
        ASSERT_NO_FATAL_FAILURE(expect_polygon(polygon, &outside));
      }
    }
  }
  EXPECT_GT(outside, 0U);
}

// Two parts with a gap of one unit in the last place: their points must not meet in it.
TEST(SubdivideMesh, ThinGapsStayOpen) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto coordinate = [&] { return 1 + random.uniform(); };
    const Point a{coordinate(), coordinate()}, b{coordinate() + 2, coordinate()};
    const auto above = [](Point p, int steps) {
      for (int i = 0; i < steps; ++i) p.y = std::nextafter(p.y, 10);
      return p;
    };
    const int gap = 2 + static_cast<int>(random.below(6));
    const std::vector<Polygon> parts = {{{{a, {3, -4}, b}}},
                                        {{{above(a, gap), above(b, gap), {3, 8}}}}};
    try {
      const PlanarResult result = subdivide(parts);
      const Certificate verdict =
          certify_polygons(to_polygon_mesh(result.quads.mesh), parts, {}, kWanted);
      ASSERT_TRUE(verdict.ok()) << verdict.sentence;
      ASSERT_EQ(result.quads.statistics.parts, 2U);
    } catch (const Error& error) {
      ++refused;
      ASSERT_EQ(error.code(), ErrorCode::kGuarantee) << error.what();
      ASSERT_EQ(error.culprits().size(), 2U);
    }
  }
  EXPECT_LT(refused, 20);
}

// A hole of some units in the last place, all three sides of which may need a point in it: they must
// not cross.
TEST(SubdivideMesh, TinyHolesStayOpen) {
  int refused = 0, several = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double unit = 0x1p-52, size = std::ldexp(unit, 2 + static_cast<int>(seed % 5));
    const auto near = [&] {
      return Point{1.5 + unit * std::floor(size / unit * random.uniform()),
                   1.5 + unit * std::floor(size / unit * random.uniform())};
    };
    const std::vector<Point> hole = {near(), near(), near()};
    if (orient2d(hole[0], hole[1], hole[2]) == 0) continue;
    const std::vector<Polygon> polygons = {{{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, hole}}};
    try {
      const PlanarResult result = subdivide(polygons);
      const Certificate verdict =
          certify_polygons(to_polygon_mesh(result.quads.mesh), polygons, {}, kWanted);
      ASSERT_TRUE(verdict.ok()) << verdict.sentence;
      several += std::ranges::count_if(result.quads.steiner, [](const SteinerPoint& s) {
                   return s.kind == SteinerKind::kOutside;
                 }) > 1;
    } catch (const Error& error) {
      ++refused;
      ASSERT_EQ(error.code(), ErrorCode::kGuarantee) << error.what();
    }
  }
  EXPECT_GT(several, 50);
  EXPECT_LT(refused, 200);
}

// ---- Meshes with given quads, regions and edges to keep. ----

/// Delaunay triangles of which some pairs are given quads, convex or not.
TriangleMesh mixed_mesh(const char* kind, std::size_t n, std::uint64_t seed) {
  TriangleMesh out;
  out.mesh = delaunay(generate_points(kind, n, seed)).mesh;
  out.given_pair.assign(out.mesh.triangle_count(), kNone);
  Random random(seed);
  for (HalfedgeId h = 0; h < out.mesh.twin.size(); ++h) {
    const HalfedgeId back = out.mesh.twin[h];
    if (back == kNone || random.below(3) == 0) continue;
    if (out.given_pair[triangle_of(h)] != kNone || out.given_pair[triangle_of(back)] != kNone)
      continue;
    out.given_pair[triangle_of(h)] = h;
    out.given_pair[triangle_of(back)] = back;
  }
  return out;
}

/// The halfedges, one a quad, inside given quads that are strictly convex.
std::vector<HalfedgeId> convex_diagonals(const TriangleMesh& source) {
  std::vector<HalfedgeId> out;
  for (TriangleId t = 0; t < source.given_pair.size(); ++t) {
    const HalfedgeId h = source.given_pair[t];
    if (h == kNone || source.mesh.twin[h] < h) continue;
    const auto at = [&](VertexId v) { return source.mesh.points[v]; };
    const Point a = at(source.mesh.origin(h)), b = at(source.mesh.apex(source.mesh.twin[h])),
                c = at(source.mesh.target(h)), d = at(source.mesh.apex(h));
    if (orient2d(d, a, b) > 0 && orient2d(b, c, d) > 0) out.push_back(h);
  }
  return out;
}

TEST(SubdivideMesh, GivenQuadsIntoFour) {
  for (const char* kind : {"uniform", "grid", "lines", "circle", "clusters"}) {
    for (const std::size_t n : {4U, 10U, 300U}) {
      for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(std::string(kind) + " " + std::to_string(n) + " seed " + std::to_string(seed));
        const TriangleMesh source = mixed_mesh(kind, n, seed);
        const TriangleResult result = subdivide(source);
        ASSERT_NO_FATAL_FAILURE(expect_planar(source, result, convex_diagonals(source).size()));
        EXPECT_EQ(result.statistics.parts, 1U);
      }
    }
  }
}

// A quad with a reflex corner counts as its two triangles, and so does one that is convex by so little
// that its halved edges are not.
TEST(SubdivideMesh, QuadsThatAreNotConvexEnough) {
  TriangleMesh source;
  source.mesh.tri_vertex = {0, 1, 3, 1, 2, 3};
  source.mesh.twin = {kNone, 5, kNone, kNone, kNone, 1};
  source.given_pair = {1, 5};
  source.mesh.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  ASSERT_NO_FATAL_FAILURE(expect_planar(source, subdivide(source), 1));
  source.mesh.points[2] = {1, 1};  // reflex there
  source.mesh.points[1] = {4, 0};
  source.mesh.tri_vertex = {0, 1, 2, 0, 2, 3};
  source.mesh.twin = {kNone, kNone, 3, 2, kNone, kNone};
  source.given_pair = {2, 3};
  ASSERT_NO_FATAL_FAILURE(expect_planar(source, subdivide(source), 0));
  source.mesh.points[2] = {2, 2};  // flat there
  ASSERT_NO_FATAL_FAILURE(expect_planar(source, subdivide(source), 0));
  source.mesh.points[2] = {std::nextafter(2.0, 3.0),
                           2};  // as good as flat, the quad's sides have no room
  const TriangleResult result = subdivide(source);
  ASSERT_NO_FATAL_FAILURE(expect_planar(source, result, result.mesh.quad_count() == 4 ? 1 : 0));
}

// Every edge of the source but the diagonals of split quads is two edges of the result, so that nothing
// reaches over edges to keep or borders; and parts are counted by them.
TEST(SubdivideMesh, EdgesAreSplitInTwo) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TriangleMesh source = mixed_mesh("uniform", 100, seed);
    Random random(seed);
    for (TriangleId t = 0; t < source.mesh.triangle_count(); ++t) {
      const HalfedgeId h = source.given_pair[t];
      const TriangleId other = h == kNone ? t : triangle_of(source.mesh.twin[h]);
      source.region.push_back(other < t ? source.region[other]
                                        : static_cast<std::uint32_t>(random.below(4)));
    }
    const TriangleResult result = subdivide(source);
    ASSERT_NO_FATAL_FAILURE(expect_planar(source, result, convex_diagonals(source).size()));
    for (const auto& [t, u] : result.quad_source) {
      ASSERT_TRUE(u == kNone || source.region[t] == source.region[u]);
    }
    std::set<std::pair<VertexId, VertexId>> edges;
    for (std::size_t i = 0; i < result.mesh.quad_vertex.size(); ++i) {
      const std::size_t next = i % 4 == 3 ? i - 3 : i + 1;
      edges.insert({result.mesh.quad_vertex[i], result.mesh.quad_vertex[next]});
    }
    for (const SteinerPoint& s : result.steiner) {
      if (s.parents[2] != kNone) continue;
      ASSERT_TRUE(edges.contains({s.parents[0], s.vertex}));
      ASSERT_TRUE(edges.contains({s.vertex, s.parents[1]}));
    }

    TriangleMesh kept = source;  // the same borders as edges to keep, on one side
    kept.region.clear();
    for (HalfedgeId h = 0; h < source.mesh.twin.size(); ++h) {
      const HalfedgeId back = source.mesh.twin[h];
      const bool border = back != kNone && h < back &&
                          source.region[triangle_of(h)] != source.region[triangle_of(back)];
      kept.keep.push_back(border ? 1 : 0);
    }
    const TriangleResult same = subdivide(kept);
    EXPECT_EQ(same.mesh.quad_vertex, result.mesh.quad_vertex);
    EXPECT_EQ(same.statistics.parts, result.statistics.parts);
    EXPECT_GT(same.statistics.parts, 4U);
  }
}

TEST(SubdivideMesh, VerticesWithoutTrianglesStay) {
  TriangleMesh source;
  source.mesh.points = {{9, 9}, {0, 0}, {3, 0}, {9, 1}, {0, 3}};
  source.mesh.tri_vertex = {1, 2, 4};
  source.mesh.twin = {kNone, kNone, kNone};
  const TriangleResult result = subdivide(source);
  ASSERT_NO_FATAL_FAILURE(expect_planar(source, result));
  EXPECT_EQ(result.mesh.quad_count(), 3U);
  EXPECT_EQ(result.steiner[0].vertex, 5U);
}

// ---- Needles. ----

// Triangles flatter than the rounding of their midpoints, also next to the boundary.
TEST(SubdivideMesh, NeedlesAreStraightened) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("rotated-grid, seed " + std::to_string(seed));
    TriangleMesh source;
    source.mesh = delaunay(generate_points("rotated-grid", 20 + 5 * seed, seed)).mesh;
    ASSERT_NO_FATAL_FAILURE(expect_planar(source, subdivide(source)));
  }
}

// A few units in the last place from a line there may be no room: certified, or a refusal that names
// the culprits.
TEST(SubdivideMesh, PointsNextToALine) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TriangleMesh source;
    source.mesh = delaunay(generate_points("near-line", 3 + seed % 10, seed)).mesh;
    try {
      ASSERT_NO_FATAL_FAILURE(expect_planar(source, subdivide(source)));
    } catch (const Error& error) {
      ++refused;
      ASSERT_EQ(error.code(), ErrorCode::kGuarantee) << error.what();
      ASSERT_GE(error.culprits().size(), 2U);
    }
  }
  EXPECT_LT(refused, 100);
}

// ---- Surfaces in space. ----

/// Strictly convex in the chart of its source face: decided again.
void expect_convex_in_space(const TriangleMesh& source, const TriangleResult& result) {
  const kernel::Places before{source.mesh.points, source.z};
  const kernel::Places after{result.mesh.points, result.z};
  for (QuadId q = 0; q < result.mesh.quad_count(); ++q) {
    kernel::Vector3 area;
    for (const TriangleId t : result.quad_source[q]) {
      if (t == kNone) continue;
      area = area + before.area(source.mesh.tri_vertex[3 * t], source.mesh.tri_vertex[3 * t + 1],
                                source.mesh.tri_vertex[3 * t + 2]);
    }
    const kernel::Chart chart(area);
    std::array<Point, 4> p;
    for (QuadId i = 0; i < 4; ++i) p[i] = after.seen(chart, result.mesh.quad_vertex[4 * q + i]);
    for (QuadId i = 0; i < 4; ++i) ASSERT_GT(orient2d(p[i], p[(i + 1) % 4], p[(i + 2) % 4]), 0);
  }
}

/// Inner points are in the plane of their triangle up to rounding.
void expect_near_triangles(const TriangleMesh& source, const TriangleResult& result) {
  const kernel::Places at{result.mesh.points, result.z};
  for (const SteinerPoint& s : result.steiner) {
    if (s.parents[2] == kNone || !source.given_pair.empty()) continue;
    const auto [a, b, c] = s.parents;
    const kernel::Vector3 area = at.area(a, b, c);
    const double size = std::sqrt(kernel::dot(area, area));
    const double off = kernel::dot(area, at.at(s.vertex) - at.at(a)) / size;
    ASSERT_LT(std::fabs(off), 1e-12 * std::sqrt(size));
  }
}

void expect_surface(const TriangleMesh& source, const TriangleResult& result,
                    std::size_t split = 0) {
  ASSERT_NO_FATAL_FAILURE(expect_sound(source, result, split));
  ASSERT_NO_FATAL_FAILURE(expect_convex_in_space(source, result));
  ASSERT_NO_FATAL_FAILURE(expect_near_triangles(source, result));
  const PolygonMesh mesh = to_polygon_mesh(result.mesh);
  std::set<std::pair<VertexId, VertexId>> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(edges.insert({mesh.face(f)[i], mesh.face(f)[(i + 1) % 4]}).second);
    }
  }
  const auto open = static_cast<std::size_t>(std::ranges::count_if(edges, [&](const auto& e) {
    return !edges.contains({e.second, e.first});
  }));
  ASSERT_EQ(open, 2 * result.statistics.boundary_edges);
  const Certificate verdict = certify_surface(mesh, result.z, to_polygon_mesh(source.mesh),
                                              source.z, {.outer_steiner = true});
  ASSERT_TRUE(verdict.ok()) << verdict.sentence;
}

struct Place3 {
  double x, y, z;
};

enum class Cells { kTriangles, kQuads };
enum class Shape { kSheet, kTube, kTorus };

/// A grid of wide x high cells; in a tube the last column is the first, in a torus the last row too.
TriangleMesh grid_surface(VertexId wide, VertexId high, Shape shape, Cells cells, auto&& place) {
  const VertexId columns = shape == Shape::kSheet ? wide + 1 : wide,
                 rows = shape == Shape::kTorus ? high : high + 1;
  PolygonMesh faces;
  std::vector<double> z;
  for (VertexId j = 0; j < rows; ++j) {
    for (VertexId i = 0; i < columns; ++i) {
      const Place3 p = place(i, j);
      faces.points.push_back({p.x, p.y});
      z.push_back(p.z);
    }
  }
  for (VertexId j = 0; j < high; ++j) {
    for (VertexId i = 0; i < wide; ++i) {
      const VertexId right = (i + 1) % columns, up = (j + 1) % rows;
      const VertexId a = j * columns + i, b = j * columns + right, c = up * columns + right,
                     d = up * columns + i;
      if (cells == Cells::kQuads) {
        faces.add_face(std::array{a, b, c, d});
      } else {
        faces.add_face(std::array{a, b, c});
        faces.add_face(std::array{a, c, d});
      }
    }
  }
  return connect_triangles(faces, z, {.space = Space::kSurface}).triangles;
}

Place3 on_torus(VertexId i, VertexId j) {
  const double u = i * std::numbers::pi / 12, v = j * std::numbers::pi / 8;
  return {(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)};
}

TEST(SubdivideMesh, SurfacesOpenAndClosed) {
  for (const Cells cells : {Cells::kTriangles, Cells::kQuads}) {
    for (const Shape shape : {Shape::kSheet, Shape::kTube, Shape::kTorus}) {
      SCOPED_TRACE("cells " + std::to_string(static_cast<int>(cells)) + ", shape " +
                   std::to_string(static_cast<int>(shape)));
      const TriangleMesh source = grid_surface(24, 16, shape, cells, on_torus);
      const TriangleResult result = subdivide(source);
      ASSERT_NO_FATAL_FAILURE(expect_surface(source, result, cells == Cells::kQuads ? 384 : 0));
      const std::size_t border = shape == Shape::kSheet ? 80 : shape == Shape::kTube ? 48 : 0;
      EXPECT_EQ(result.statistics.boundary_edges, border);
    }
  }
}

// Rough ground seen from every side, as steep as it gets.
TEST(SubdivideMesh, RoughSurfaces) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double steep = std::ldexp(1.0, static_cast<int>(seed % 12) - 4);
    const TriangleMesh source =
        grid_surface(12, 9, Shape::kSheet, Cells::kTriangles, [&](VertexId i, VertexId j) {
          const double x = i + random.uniform() / 3, y = j + random.uniform() / 3,
                       z = steep * random.uniform();
          return seed % 3 == 0   ? Place3{x, y, z}
                 : seed % 3 == 1 ? Place3{z, x, y}
                                 : Place3{y, z, x};
        });
    ASSERT_NO_FATAL_FAILURE(expect_surface(source, subdivide(source)));
  }
}

// ---- Refusals and reports. ----

TEST(SubdivideMesh, MoreThan32Bits) {
  using quadrangulate::check_subdivision_size;
  constexpr std::size_t kHalf = std::size_t{1} << 31, kEighth = std::size_t{1} << 29;
  EXPECT_NO_THROW(check_subdivision_size(kHalf - 2, kEighth));
  for (const auto& [points, triangles] : {std::pair{kHalf - 1, kEighth},
                                          {std::size_t{3}, 2 * kEighth},
                                          {std::size_t{kNone}, std::size_t{1}}}) {
    try {
      check_subdivision_size(points, triangles);
      FAIL() << points << " points, " << triangles << " triangles";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kTooManyPoints);
    }
  }
}

TEST(SubdivideMesh, ProgressCanStop) {
  TriangleMesh source;
  source.mesh = delaunay(generate_points("uniform", 50, 1)).mesh;
  double last = 0;
  TriangleOptions options{.method = TriangleMethod::kSubdivide};
  options.progress = [&](std::string_view stage, double done) {
    if (stage == "subdividing") last = done;
    return true;
  };
  quadrangulate_triangles(source, options);
  EXPECT_EQ(last, 1.0);
  options.progress = [](std::string_view stage, double) { return stage != "subdividing"; };
  try {
    quadrangulate_triangles(source, options);
    FAIL() << "not stopped";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace quadloom
