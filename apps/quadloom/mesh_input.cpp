#include "mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "facts.hpp"
#include "keep_lines.hpp"
#include "timer.hpp"

namespace quadloom::app {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

// ---- Meshes. ----

// Data by input vertex as data by vertex of the connected mesh; of merged ones the first counts.
std::vector<double> by_vertex(const std::vector<double>& values,
                              const std::vector<VertexId>& input_to_vertex, std::size_t vertices) {
  std::vector<double> out(vertices, kMissing);
  for (std::size_t i = input_to_vertex.size(); i-- > 0;) {
    if (input_to_vertex[i] != kNone) out[input_to_vertex[i]] = values[i];
  }
  return out;
}

void remark_on_repairs(const ConnectedMesh& connected, std::size_t merged, SourceMesh& source) {
  const auto say = [&](std::size_t n, const std::string& what, const std::string& rest) {
    if (n > 0) source.remarks.push_back(counted(n, what) + ' ' + rest);
  };
  say(merged, "repeated vertex place", "merged");
  say(connected.turned_faces, "face", "turned over to agree with the others");
  say(connected.flat_faces, "triangle", "without area flipped away or left out");
  say(connected.unused_vertices, "unused point", "of the file kept, in no face");
  if (connected.components > 1) {
    source.remarks.push_back(
        fmt::format("the mesh has {}", counted(connected.components, "component")));
  }
}

SourceMesh connect(io::MeshFile file, const MeshReading& reading) {
  ConnectOptions options = reading.connect;
  if (file.z_is_data && options.space == Space::kAuto) options.space = Space::kPlane;
  ConnectedMesh connected = connect_triangles(file.mesh, file.z, options);
  SourceMesh source;
  source.input_count = file.mesh.points.size();
  source.face_count = file.mesh.face_count();
  const std::size_t vertices = connected.triangles.mesh.points.size();
  const std::size_t merged = source.input_count - vertices;
  remark_on_repairs(connected, merged, source);
  const auto carried = [&](std::vector<double> values) {
    return merged == 0 ? std::move(values) : by_vertex(values, connected.input_to_vertex, vertices);
  };
  if (!file.z.empty()) source.z = carried(std::move(file.z));
  for (io::Attribute& data : file.vertex_data) {
    source.vertex_data.push_back({std::move(data.name), carried(std::move(data.values))});
  }
  for (const Segment s : file.edges) {
    source.lines.push_back({connected.input_to_vertex[s.from], connected.input_to_vertex[s.to]});
  }
  source.face_data = std::move(file.face_data);
  const bool as_given = merged == 0 && connected.turned_faces == 0 && connected.flat_faces == 0 &&
                        connected.triangles.mesh.triangle_count() ==  // no quad that is a triangle
                            file.mesh.face_vertex.size() - 2 * file.mesh.face_count();
  source.faces = as_given ? std::move(file.mesh) : to_polygon_mesh(connected.triangles.mesh);
  source.space = connected.space;
  source.components = connected.components;
  source.boundary_edges = connected.boundary_edges;
  source.boundary_cycles = connected.boundary_cycles;
  source.source_face = std::move(connected.source_face);
  source.triangles = std::move(connected.triangles);
  return source;
}

// ---- Polygons. ----

std::size_t corner_count(const PlanarInput& input) {
  std::size_t corners = 0;
  for (const Polygon& polygon : input.polygons) {
    for (const auto& ring : polygon.rings) corners += ring.size();
  }
  return corners;
}

// Numbers by polygon or region as numbers by triangle.
std::vector<double> by_part(const std::vector<double>& values,
                            const std::vector<std::uint32_t>& part) {
  std::vector<double> out;
  out.reserve(part.size());
  for (const std::uint32_t p : part) out.push_back(p < values.size() ? values[p] : kMissing);
  return out;
}

void add_part_data(const io::PlanarFile& file, const std::vector<std::uint32_t>& part,
                   SourceMesh& source) {
  for (const auto* data : {&file.polygon_data, &file.region_data}) {
    for (const auto& [name, values] : *data) {
      source.face_data.push_back({name, by_part(values, part)});
    }
  }
  if (find_data(source.face_data, "part") != nullptr) return;
  io::Attribute number{"part", {}};
  for (const std::uint32_t p : part) number.values.push_back(p == kNone ? -1.0 : p);
  source.face_data.push_back(std::move(number));
}

// The edges of the input as edges to keep, the segments also as lines.
void keep_input_edges(const ConstrainedResult& result, std::size_t corners, bool keep,
                      SourceMesh& source) {
  for (HalfedgeId h = 0; h < result.edge.size(); ++h) {
    if (keep) source.triangles.keep.push_back(result.edge[h] != kNone);
    const HalfedgeId twin = result.mesh.twin[h];
    if (result.edge[h] == kNone || (twin != kNone && twin < h)) continue;
    if (keep && twin != kNone) ++source.kept_edges;
    if (result.edge[h] >= corners) {
      source.lines.push_back({result.mesh.origin(h), result.mesh.target(h)});
    }
  }
}

SourceMesh triangulate(io::PlanarFile file, const MeshReading& reading) {
  ConstrainedResult result = constrained_delaunay(file.input);
  const std::size_t corners = corner_count(file.input), points = file.input.points.size();
  const std::size_t vertices = result.mesh.points.size();
  SourceMesh source;
  source.input_count = corners + points;
  source.face_count = result.mesh.triangle_count();
  keep_input_edges(result, corners, reading.keep != "none", source);
  add_part_data(file, result.part, source);
  if (!file.z.empty()) source.z = by_vertex(file.z, result.input_to_vertex, vertices);
  const std::vector<VertexId> point_vertex(
      result.input_to_vertex.begin() + static_cast<std::ptrdiff_t>(corners),
      result.input_to_vertex.end());
  for (const auto& [name, values] : file.point_data) {
    source.vertex_data.push_back({name, by_vertex(values, point_vertex, vertices)});
  }
  for (std::size_t i = 0; i < points; ++i) {
    if (point_vertex[i] != kNone) source.inner.push_back(file.input.points[i]);
  }
  const auto outside = points - source.inner.size();
  if (outside > 0) source.remarks.push_back(counted(outside, "point") + " outside left out");
  if (file.input.polygons.empty()) {
    source.faces = to_polygon_mesh(result.mesh);
  } else {
    source.polygons = std::move(file.input);
  }
  for (TriangleId t = 0; t < result.mesh.triangle_count(); ++t) source.source_face.push_back(t);
  source.boundary_edges =
      static_cast<std::size_t>(std::count(result.mesh.twin.begin(), result.mesh.twin.end(), kNone));
  if (reading.regions == "auto") source.triangles.region = std::move(result.part);
  source.triangles.mesh = std::move(result.mesh);
  return source;
}

// ---- Regions. ----

// One label a value; all NaN are one value.
std::vector<std::uint32_t> labels(const std::vector<double>& face_value,
                                  const std::vector<std::uint32_t>& source_face) {
  std::map<double, std::uint32_t> label;
  std::vector<std::uint32_t> out;
  out.reserve(source_face.size());
  for (const std::uint32_t f : source_face) {
    const double value = face_value[f];
    out.push_back(
        std::isnan(value)
            ? kNone
            : label.try_emplace(value, static_cast<std::uint32_t>(label.size())).first->second);
  }
  return out;
}

void add_regions(const MeshReading& reading, SourceMesh& source) {
  if (reading.regions == "none") return;
  const std::vector<double>* values = nullptr;
  if (reading.regions == "auto") {
    if (!source.triangles.region.empty()) return;  // the parts of polygons
    for (const char* name : {"region", "physical", "material", "part", "attribute0"}) {
      if (values == nullptr) values = find_data(source.face_data, name);
    }
    if (values == nullptr) return;
  } else {
    values = find_data(source.face_data, reading.regions);
    if (values == nullptr) {
      std::string names;
      for (const auto& data : source.face_data) names += (names.empty() ? "" : ", ") + data.name;
      throw Error(ErrorCode::kBadOption,
                  fmt::format("--regions: the faces have no numbers called '{}'; there {}",
                              reading.regions, names.empty() ? "are none" : "is " + names));
    }
  }
  source.triangles.region = labels(*values, source.source_face);
}

// ---- Edges to keep. ----

class Keeper {
 public:
  explicit Keeper(SourceMesh& source) : source_(source), paths_(source.triangles.mesh) {}

  bool keep(VertexId a, VertexId b, bool straight) {
    path_.clear();
    if (!paths_.follow(a, b, straight, path_)) return false;
    auto& keep = source_.triangles.keep;
    const auto& twin = source_.triangles.mesh.twin;
    if (keep.empty()) keep.assign(twin.size(), 0);
    for (const HalfedgeId h : path_) {
      if (twin[h] == kNone) continue;
      if (keep[h] == 0 && keep[twin[h]] == 0) ++source_.kept_edges;
      keep[h] = keep[twin[h]] = 1;
    }
    return true;
  }

 private:
  SourceMesh& source_;
  EdgePaths paths_;
  std::vector<HalfedgeId> path_;
};

void keep_lines_of_mesh(SourceMesh& source) {
  if (source.lines.empty()) return;
  Keeper keeper(source);
  std::size_t astray = 0;
  for (const Segment s : source.lines) {
    if (!keeper.keep(s.from, s.to, source.space == Space::kPlane)) ++astray;
  }
  if (astray > 0) {
    source.remarks.push_back(counted(astray, "line") +
                             " of the file along no edges of the mesh; nothing to keep there");
  }
}

std::string place(Point p) { return fmt::format("({}, {})", p.x, p.y); }

// Segments and rings of a file of lines.
std::vector<std::array<Point, 2>> pieces(const PlanarInput& lines) {
  std::vector<std::array<Point, 2>> out;
  for (const Polygon& polygon : lines.polygons) {
    for (const auto& ring : polygon.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        out.push_back({ring[i], ring[(i + 1) % ring.size()]});
      }
    }
  }
  for (const Segment s : lines.segments) out.push_back({lines.points[s.from], lines.points[s.to]});
  return out;
}

void keep_lines_of_file(const std::string& path, SourceMesh& source) {
  if (source.space == Space::kSurface) {
    throw Error(ErrorCode::kBadOption,
                "--keep: lines from a file are for planar meshes, this one is a surface in space");
  }
  const auto lines = pieces(io::read_planar(path).input);
  std::vector<Point> ends;
  for (const auto& [a, b] : lines) ends.insert(ends.end(), {a, b});
  const std::vector<VertexId> vertex = vertices_at(source.triangles.mesh.points, ends);
  Keeper keeper(source);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const VertexId a = vertex[2 * i], b = vertex[2 * i + 1];
    const auto fail = [&](const std::string& why) {
      throw Error(ErrorCode::kBadMesh,
                  fmt::format("{}: the line from {} to {} {}", path, place(lines[i][0]),
                              place(lines[i][1]), why),
                  {i});
    };
    if (a == kNone) fail("begins at no vertex of the mesh");
    if (b == kNone) fail("ends at no vertex of the mesh");
    if (!keeper.keep(a, b, true)) fail("does not follow edges of the mesh");
  }
}

void add_kept_edges(const MeshReading& reading, InputKind kind, SourceMesh& source) {
  if (reading.keep == "lines") {
    if (kind == InputKind::kMesh) keep_lines_of_mesh(source);
  } else if (reading.keep != "none") {
    keep_lines_of_file(reading.keep, source);
  }
  if (reading.keep_angle && source.space != Space::kSurface) {
    source.remarks.push_back(
        "no edge kept by its angle: the mesh is planar, not a surface in space");
  } else if (reading.keep_angle) {
    source.kept_edges += keep_sharp_edges(source.triangles, *reading.keep_angle);
  }
}

}  // namespace

const std::vector<double>* find_data(const std::vector<io::Attribute>& data,
                                     const std::string& name) {
  for (const io::Attribute& attribute : data) {
    if (attribute.name == name) return &attribute.values;
  }
  return nullptr;
}

SourceMesh read_source(const MeshReading& reading, FoundInput input) {
  SourceMesh source;
  const Timer reading_time;
  if (input.kind == InputKind::kMesh) {
    io::MeshFile file = io::read_mesh(reading.path, reading.format);
    const double seconds = reading_time.seconds();
    const Timer timer;
    source = connect(std::move(file), reading);
    source.read_seconds = seconds;
    source.connect_seconds = timer.seconds();
  } else {
    if (!input.planar) input.planar = io::read_planar(reading.path, reading.format);
    const double seconds = input.read_seconds + reading_time.seconds();
    const Timer timer;
    source = triangulate(std::move(*input.planar), reading);
    source.read_seconds = seconds;
    source.connect_seconds = timer.seconds();
  }
  const Timer timer;
  add_regions(reading, source);
  add_kept_edges(reading, input.kind, source);
  source.connect_seconds += timer.seconds();
  return source;
}

}  // namespace quadloom::app
