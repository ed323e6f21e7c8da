// What every room shares: points, indices, meshes, errors, progress, threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace quadloom {

/// A point of the plane. Any finite doubles; -0.0 and 0.0 are the same coordinate.
struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Lexicographic order, x first; the order in which ties are broken everywhere.
inline bool lex_less(Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

using VertexId = std::uint32_t;
using TriangleId = std::uint32_t;
using QuadId = std::uint32_t;
using HalfedgeId = std::uint32_t;

/// "No such vertex, triangle, quad or halfedge".
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// The most points that the 32-bit indices allow: a triangulation of n points has fewer than 6 n
/// halfedges, and kNone stays free.
inline constexpr std::size_t kMaxPoints = (std::size_t{1} << 32) / 6 - 16;

/// The other halfedges of a triangle, and the triangle. Sums, since which of the three h is cannot be predicted.
inline HalfedgeId next_halfedge(HalfedgeId h) { return h + 1 - 3 * HalfedgeId{h % 3 == 2}; }
inline HalfedgeId previous_halfedge(HalfedgeId h) { return h - 1 + 3 * HalfedgeId{h % 3 == 0}; }
inline TriangleId triangle_of(HalfedgeId h) { return h / 3; }

/// A triangulation. Triangle t has the corners tri_vertex[3t], tri_vertex[3t + 1], tri_vertex[3t +
/// 2], counter-clockwise. Halfedge h = 3t + i goes from corner i of t to the next corner and has t
/// on its left; twin[h] is the same edge in the neighbouring triangle, kNone on the boundary.
struct Triangulation {
  std::vector<Point> points;
  std::vector<VertexId> tri_vertex;
  std::vector<HalfedgeId> twin;

  std::size_t triangle_count() const { return tri_vertex.size() / 3; }
  VertexId origin(HalfedgeId h) const { return tri_vertex[h]; }
  VertexId target(HalfedgeId h) const { return tri_vertex[next_halfedge(h)]; }
  VertexId apex(HalfedgeId h) const { return tri_vertex[previous_halfedge(h)]; }
};

/// A mesh of quadrilaterals, quad q with the corners quad_vertex[4q + 0..3], counter-clockwise, and
/// the triangles that were left over (none or one, unless a result says otherwise), tri_vertex[3t +
/// 0..2]. The input's vertices come first, Steiner points follow.
struct Quadrangulation {
  std::vector<Point> points;
  std::vector<VertexId> quad_vertex;
  std::vector<VertexId> tri_vertex;

  std::size_t quad_count() const { return quad_vertex.size() / 4; }
  std::size_t triangle_count() const { return tri_vertex.size() / 3; }
};

/// Any mesh of polygons; face f has the corners face_vertex[face_begin[f] .. face_begin[f + 1]),
/// counter-clockwise. What files hold, and what certify judges.
struct PolygonMesh {
  std::vector<Point> points;
  std::vector<std::uint32_t> face_begin = {0};
  std::vector<VertexId> face_vertex;

  std::size_t face_count() const { return face_begin.size() - 1; }
  std::span<const VertexId> face(std::size_t f) const {
    return {face_vertex.data() + face_begin[f], face_vertex.data() + face_begin[f + 1]};
  }
  void add_face(std::span<const VertexId> corners) {
    face_vertex.insert(face_vertex.end(), corners.begin(), corners.end());
    face_begin.push_back(static_cast<std::uint32_t>(face_vertex.size()));
  }
};

/// A mesh of triangles that is to be converted, and what must stay of it. Corners counter-clockwise
/// in the plane, consistent on a surface; vertices that no triangle uses are allowed and stay. See
/// connect_triangles, which makes one from the faces of a file.
struct TriangleMesh {
  Triangulation mesh;
  std::vector<double> z;               ///< per vertex: a surface in space; empty: a planar mesh
  std::vector<std::uint32_t> region;   ///< per triangle: a label; empty: one region. Faces never
                                       ///< reach from one label into another
  std::vector<std::uint8_t> keep;      ///< per halfedge: != 0 on either side is an edge that stays;
                                       ///< empty: none
  std::vector<HalfedgeId> given_pair;  ///< per triangle: the halfedge inside its quad, where the
                                       ///< source had a quad, else kNone; empty: triangles only
};

/// What the order of a mesh's triangles promises: in all of them consecutive triangles share an edge.
enum class OrderKind {
  kPath,        ///< no more than that: a Hamiltonian path of the dual graph
  kCycle,       ///< the last triangle and the first share one, too; at least three triangles
  kSequential,  ///< triangle i has the vertices i, i + 1 and i + 2 of one sequence of vertices, so that
                ///< left and right turns alternate
};

/// The same mesh as polygons: quads first, then triangles.
PolygonMesh to_polygon_mesh(const Quadrangulation& mesh);
PolygonMesh to_polygon_mesh(const Triangulation& mesh);

enum class ErrorCode {
  kBadOption,        ///< an option out of its range, or options that exclude each other
  kNotFinite,        ///< a coordinate is NaN or infinite; culprits: the point
  kTooFewPoints,     ///< fewer than three distinct points
  kAllCollinear,     ///< all points on one line
  kTooManyPoints,    ///< more than the 32-bit indices can number
  kIndexOutOfRange,  ///< a face names a vertex that is not there; culprits: face, index
  kBadMesh,          ///< not a manifold mesh; culprits: the edge's vertices or the face
  kCrossing,         ///< input edges that cross or overlap; culprits: the two edges
  kBadPolygon,       ///< rings that bound no region; culprits: two edges, or the ring
  kParse,            ///< unreadable text; culprits: the line
  kFile,             ///< a file cannot be opened, read or written
  kGuarantee,        ///< what was asked for does not exist for this input
  kCancelled,        ///< the progress callback asked to stop
};

/// The one exception type: a code, a sentence for people, and the indices of the culprits.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence, std::vector<std::size_t> culprits = {})
      : std::runtime_error(sentence), code_(code), culprits_(std::move(culprits)) {}
  ErrorCode code() const { return code_; }
  const std::vector<std::size_t>& culprits() const { return culprits_; }

 private:
  ErrorCode code_;
  std::vector<std::size_t> culprits_;
};

/// Called now and then during long work with the stage's name and how much of the stage is done, in
/// [0, 1]; returning false stops the work (Error, kCancelled). Empty: no reports.
using Progress = std::function<bool(std::string_view stage, double done)>;

/// Reports to an optional callback; throws Error kCancelled when it asks to stop.
void report_progress(const Progress& progress, std::string_view stage, double done);

/// While it lives, the library works on at most so many threads in all of the process; of several
/// limits the least holds. Without one it takes all cores. Results do not depend on it. Throws Error
/// kBadOption for 0. A library built without threads takes one whatever the limit.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace quadloom
