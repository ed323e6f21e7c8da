#include "carry_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace quadloom::app {
namespace {

using Ends = std::pair<VertexId, VertexId>;
using TrianglePairs = std::span<const std::array<TriangleId, 2>>;

Ends sorted(VertexId a, VertexId b) { return std::minmax(a, b); }

// Edges of a source as chains of edges of the result.
//
//        a---------b           a----s----b       s is an added point that was made from a-b
class SplitEdges {
 public:
  explicit SplitEdges(const TriangleResult& result) {
    const auto add = [&](const std::vector<VertexId>& corner, std::size_t corners) {
      for (std::size_t i = 0; i < corner.size(); ++i) {
        const std::size_t next = i % corners == corners - 1 ? i + 1 - corners : i + 1;
        edges_.push_back(sorted(corner[i], corner[next]));
      }
    };
    add(result.mesh.quad_vertex, 4);
    add(result.mesh.tri_vertex, 3);
    std::sort(edges_.begin(), edges_.end());
    for (const SteinerPoint& s : result.steiner) {
      if (s.parents[1] == kNone || s.parents[2] != kNone) continue;
      splits_.push_back({sorted(s.parents[0], s.parents[1]), s.vertex});
    }
    std::sort(splits_.begin(), splits_.end());
  }

  /// The chain from a to b; nothing if there is none.
  std::optional<std::vector<Segment>> chain(VertexId a, VertexId b) const {
    std::vector<Segment> out, open = {{a, b}};
    while (!open.empty()) {
      const Segment s = open.back();
      open.pop_back();
      const Ends ends = sorted(s.from, s.to);
      if (std::binary_search(edges_.begin(), edges_.end(), ends)) {
        out.push_back(s);
        continue;
      }
      const auto at =
          std::lower_bound(splits_.begin(), splits_.end(), std::pair{ends, VertexId{0}});
      if (at == splits_.end() || at->first != ends) return {};
      open.push_back({at->second, s.to});
      open.push_back({s.from, at->second});
    }
    return out;
  }

 private:
  std::vector<Ends> edges_;
  std::vector<std::pair<Ends, VertexId>> splits_;
};

bool is_ours(const std::string& name) {
  static const std::set<std::string> kOurs = {"added", "shape", "source0", "source1"};
  return kOurs.contains(name);
}

void carry_vertex_data(const SourceMesh& source, const TriangleResult& result, io::MeshFile& out) {
  const std::size_t vertices = result.mesh.points.size();
  const bool surface = !result.z.empty();
  const std::vector<Blend> shares = blends(result.steiner, result.mesh.points, result.z);
  const auto carried = [&](std::vector<double> values) {
    values.resize(vertices, 0);
    interpolate(shares, values);
    return values;
  };
  if (surface) {
    out.z = result.z;
  } else if (!source.z.empty()) {
    out.z = carried(source.z);
  }
  for (const auto& [name, values] : source.vertex_data) {
    if (!is_ours(name)) out.vertex_data.push_back({name, carried(values)});
  }
  io::Attribute added{"added", std::vector<double>(vertices, 0)};
  for (const SteinerPoint& s : result.steiner) added.values[s.vertex] = 1;
  out.vertex_data.push_back(std::move(added));
}

// The source faces of each face of the result, quads first; kNone where there is no second one.
std::vector<std::array<std::uint32_t, 2>> face_sources(const SourceMesh& source,
                                                       const TriangleResult& result,
                                                       TrianglePairs triangle_sources) {
  std::vector<std::array<std::uint32_t, 2>> out;
  out.reserve(result.quad_source.size() + result.triangle_source.size());
  const auto face = [&](TriangleId t) { return t == kNone ? kNone : source.source_face[t]; };
  const auto add = [&](TrianglePairs pairs) {
    for (const auto& [first, second] : pairs) {
      std::array<std::uint32_t, 2> faces = {face(first), face(second)};
      if (faces[0] == kNone) std::swap(faces[0], faces[1]);
      if (faces[1] == faces[0]) faces[1] = kNone;
      out.push_back(faces);
    }
  };
  add(result.quad_source);
  add(triangle_sources);
  if (!triangle_sources.empty()) return out;
  for (const TriangleId t : result.triangle_source) out.push_back({face(t), kNone});
  return out;
}

double carried_value(const std::vector<double>& values, const std::array<std::uint32_t, 2>& faces) {
  if (faces[0] == kNone) return std::nan("");
  const double first = values[faces[0]];
  if (faces[1] == kNone) return first;
  const double second = values[faces[1]];
  return first == second ? first : first / 2 + second / 2;
}

void carry_face_data(const SourceMesh& source, const TriangleResult& result,
                     TrianglePairs triangle_sources, io::MeshFile& out) {
  const auto faces = face_sources(source, result, triangle_sources);
  for (const auto& [name, values] : source.face_data) {
    if (is_ours(name)) continue;
    io::Attribute& data = out.face_data.emplace_back(io::Attribute{name, {}});
    data.values.reserve(faces.size());
    for (const auto& pair : faces) data.values.push_back(carried_value(values, pair));
  }
  for (const std::size_t i : {0, 1}) {
    io::Attribute& data =
        out.face_data.emplace_back(io::Attribute{i == 0 ? "source0" : "source1", {}});
    data.values.reserve(faces.size());
    for (const auto& pair : faces) data.values.push_back(pair[i] == kNone ? -1.0 : pair[i]);
  }
}

void add_shape(const TriangleResult& result, io::MeshFile& out) {
  io::Attribute shape{"shape", {}};
  shape.values.reserve(out.mesh.face_count());
  for (std::size_t f = 0; f < out.mesh.face_count(); ++f) {
    const auto v = out.mesh.face(f);
    const auto at = [&](std::size_t i) { return out.mesh.points[v[i]]; };
    shape.values.push_back(v.size() != 4      ? 0
                           : result.z.empty() ? quad_shape(at(0), at(1), at(2), at(3))
                                              : shape_in_space(out.mesh, result.z, f));
  }
  out.face_data.push_back(std::move(shape));
}

void carry_lines(const SourceMesh& source, const TriangleResult& result, io::MeshFile& out) {
  if (source.lines.empty()) return;
  const SplitEdges edges(result);
  for (const Segment line : source.lines) {
    const auto chain = edges.chain(line.from, line.to);
    if (chain) {
      out.edges.insert(out.edges.end(), chain->begin(), chain->end());
    } else {
      out.edges.push_back(line);  // it followed several edges, or none
    }
  }
}

}  // namespace

double shape_in_space(const PolygonMesh& mesh, std::span<const double> z, std::size_t face) {
  using Vector = std::array<double, 3>;
  const auto v = mesh.face(face);
  std::array<Vector, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = {mesh.points[v[i]].x, mesh.points[v[i]].y, z[v[i]]};
  }
  const auto minus = [](const Vector& a, const Vector& b) {
    return Vector{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto unit = [&](const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? Vector{a[0] / length, a[1] / length, a[2] / length} : Vector{};
  };
  const Vector normal = unit(cross(minus(p[2], p[0]), minus(p[3], p[1])));
  const Vector diagonal = minus(p[2], p[0]);
  const Vector right = unit(diagonal), up = cross(normal, right);
  std::array<Point, 4> seen;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector d = minus(p[i], p[0]);
    seen[i] = {dot(d, right), dot(d, up)};
  }
  return quad_shape(seen[0], seen[1], seen[2], seen[3]);
}

io::MeshFile carry_data(const SourceMesh& source, const TriangleResult& result,
                        TrianglePairs triangle_sources) {
  io::MeshFile out;
  out.mesh = to_polygon_mesh(result.mesh);
  carry_vertex_data(source, result, out);
  carry_face_data(source, result, triangle_sources, out);
  add_shape(result, out);
  carry_lines(source, result, out);
  return out;
}

std::string lost_feature(const SourceMesh& source, const TriangleResult& result) {
  const auto& region = source.triangles.region;
  for (std::size_t q = 0; !region.empty() && q < result.quad_source.size(); ++q) {
    const auto [a, b] = result.quad_source[q];
    if (a == kNone || b == kNone || region[a] == region[b]) continue;
    return fmt::format("face {} is of two regions, from the triangles {} and {}", q, a, b);
  }
  const auto& keep = source.triangles.keep;
  if (std::find(keep.begin(), keep.end(), 1) == keep.end()) return {};
  const SplitEdges edges(result);
  const Triangulation& mesh = source.triangles.mesh;
  for (HalfedgeId h = 0; h < keep.size(); ++h) {
    if (keep[h] == 0 || edges.chain(mesh.origin(h), mesh.target(h))) continue;
    return fmt::format("the edge from vertex {} to {}, which was to stay, is no edge of the mesh",
                       mesh.origin(h), mesh.target(h));
  }
  return {};
}

}  // namespace quadloom::app
