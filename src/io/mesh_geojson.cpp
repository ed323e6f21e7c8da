// Meshes as GeoJSON: a polygon a face, face data as its properties (read back are numbers that every
// feature has, null for NaN). GeoJSON has no vertices of its
// own: corners at the same place are one vertex, numbered in the order of the text, with the height
// of the first.

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "io/geojson.hpp"
#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::io {
namespace {

/// Collects the faces of all polygons, and the numbers of their features.
class FaceCollector : public GeojsonVisitor {
 public:
  explicit FaceCollector(const Source& source) : source_(source) {}

  void geometry(const std::string& type, const CoordinateTape& tape) override {
    if (type != "Polygon" && type != "MultiPolygon") {
      fail_in(source_, fmt::format("it holds a {}, expected Polygon and MultiPolygon only", type));
    }
    for (const auto& rings : polygons_of(source_, type, tape)) add_polygon(rings);
  }

  /// Numbers that every feature so far has become face data.
  void feature_end(const Properties& properties) override {
    const std::size_t faces = face_begin_.size() - 1;
    for (const auto& [name, value] : properties) {
      if (feature_begin_ == 0 && !data_.contains(name) && attributes_.size() < kMostProperties) {
        data_.emplace(name, attributes_.size());
        attributes_.push_back({name, {}});
      }
      const auto at = data_.find(name);
      if (at == data_.end()) continue;
      auto& values = attributes_[at->second].values;
      if (values.size() == feature_begin_) values.resize(faces, value);
    }
    feature_begin_ = faces;
  }

  MeshFile finish() {
    if (face_begin_.size() == 1) fail_in(source_, "no polygons");
    const auto distinct = distinct_points(points_);
    std::vector<double> z(distinct.points.size());
    for (std::size_t i = points_.size(); i-- > 0;) z[distinct.input_to_vertex[i]] = z_[i];
    MeshBuilder mesh(source_);
    for (std::size_t v = 0; v < distinct.points.size(); ++v) {
      mesh.add_vertex(distinct.points[v].x, distinct.points[v].y, z[v]);
    }
    std::vector<std::uint64_t> corners;
    for (std::size_t f = 0; f + 1 < face_begin_.size(); ++f) {
      corners.assign(
          distinct.input_to_vertex.begin() + static_cast<std::ptrdiff_t>(face_begin_[f]),
          distinct.input_to_vertex.begin() + static_cast<std::ptrdiff_t>(face_begin_[f + 1]));
      mesh.add_face(corners, 0);
    }
    MeshFile out = mesh.finish();
    std::erase_if(attributes_, [&](const Attribute& attribute) {
      return attribute.values.size() != out.mesh.face_count();
    });
    out.face_data = std::move(attributes_);
    return out;
  }

 private:
  static constexpr std::size_t kMostProperties = 256;

  void add_polygon(const std::vector<Ring>& rings) {
    const std::size_t face = face_begin_.size() - 1;
    if (rings.size() != 1) {
      fail_in(source_, fmt::format("polygon {} has {} rings, a face has one", face, rings.size()));
    }
    const Ring& ring = rings[0];
    if (ring.size() < 4 || ring.front().x != ring.back().x || ring.front().y != ring.back().y) {
      fail_in(source_, fmt::format("the ring of polygon {} is not closed or has fewer than three "
                                   "corners",
                                   face));
    }
    for (const Position& p : std::span(ring).first(ring.size() - 1)) {
      points_.push_back({p.x, p.y});
      z_.push_back(p.z);
    }
    face_begin_.push_back(points_.size());
  }

  const Source& source_;
  std::vector<Point> points_;  // the corners of all faces
  std::vector<double> z_;
  std::vector<std::size_t> face_begin_ = {0};
  std::size_t feature_begin_ = 0;  // the first face of the feature being read
  std::map<std::string, std::size_t> data_;
  std::vector<Attribute> attributes_;
};

void write_number(TextBuffer& out, double value) {
  if (std::isfinite(value)) {
    out << value;
  } else {
    out << "null";
  }
}

void write_position(TextBuffer& out, const MeshFile& file, VertexId v) {
  out << '[' << file.mesh.points[v].x << ',' << file.mesh.points[v].y;
  if (!file.z.empty()) out << ',' << file.z[v];
  out << ']';
}

}  // namespace

MeshFile read_geojson_mesh(const Source& source) {
  FaceCollector collector(source);
  visit_geojson(source, collector);
  return collector.finish();
}

void write_geojson_mesh(Output& out, const MeshFile& file) {
  std::vector<std::string> keys;
  for (const auto& attribute : file.face_data) keys.push_back(json_string(attribute.name));
  out << R"({"type":"FeatureCollection","features":[)";
  out.each(file.mesh.face_count(), [&](TextBuffer& to, std::size_t f) {
    to << (f == 0 ? "\n" : ",\n") << R"({"type":"Feature","properties":{)";
    for (std::size_t i = 0; i < keys.size(); ++i) {
      to << (i == 0 ? "" : ",") << keys[i] << ':';
      write_number(to, file.face_data[i].values[f]);
    }
    to << R"(},"geometry":{"type":"Polygon","coordinates":[[)";
    for (const VertexId v : file.mesh.face(f)) {
      write_position(to, file, v);
      to << ',';
    }
    write_position(to, file, file.mesh.face(f).front());
    to << "]]}}";
  });
  out << "\n]}\n";
}

}  // namespace quadloom::io
