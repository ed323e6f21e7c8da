// Polygons, lines and points from GeoJSON: everything in it, in order. A feature's numbers are those
// of its polygons; a polygon whose feature lacks one has NaN there.

#include <fmt/format.h>

#include <limits>
#include <map>

#include "io/geojson.hpp"
#include "io/planar_readers.hpp"

namespace quadloom::io {
namespace {

class PlanarCollector : public GeojsonVisitor {
 public:
  explicit PlanarCollector(const Source& source) : source_(source) {}

  void geometry(const std::string& type, const CoordinateTape& tape) override {
    if (type == "Polygon" || type == "MultiPolygon") {
      for (const auto& rings : polygons_of(source_, type, tape)) add_polygon(rings);
    } else if (type == "Point" || type == "MultiPoint") {
      for (const Position& p : positions_of(source_, type, tape)) add_point(p);
    } else if (type == "LineString") {
      add_line(positions_of(source_, type, tape));
    } else if (type == "MultiLineString") {
      // Nested as the rings of a polygon are.
      for (const auto& lines : polygons_of(source_, "Polygon", tape)) {
        for (const Ring& line : lines) add_line(line);
      }
    } else {
      fail_in(source_, fmt::format("it holds a {}, which is no geometry known", in_quotes(type)));
    }
  }

  void feature_end(const Properties& properties) override {
    const std::size_t polygons = file_.input.polygons.size();
    for (const auto& [name, value] : properties) {
      if (polygons == feature_begin_) break;
      if (!data_.contains(name) && file_.polygon_data.size() == kMostProperties) continue;
      const auto [at, is_new] = data_.try_emplace(name, file_.polygon_data.size());
      if (is_new) file_.polygon_data.push_back({name, {}});
      auto& values = file_.polygon_data[at->second].values;
      if (values.size() > feature_begin_) continue;  // the name a second time
      values.resize(feature_begin_, kMissing);
      values.resize(polygons, value);
    }
    feature_begin_ = polygons;
  }

  PlanarFile finish() {
    if (file_.input.polygons.empty() && file_.input.points.empty()) {
      fail_in(source_, "no polygons, lines or points", ErrorCode::kTooFewPoints);
    }
    for (Attribute& data : file_.polygon_data) {
      data.values.resize(file_.input.polygons.size(), kMissing);
    }
    if (all_have_z_) {
      file_.z = std::move(corner_z_);
      file_.z.insert(file_.z.end(), point_z_.begin(), point_z_.end());
    }
    return std::move(file_);
  }

 private:
  static constexpr std::size_t kMostProperties = 256;
  static constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

  void add_polygon(const std::vector<Ring>& rings) {
    Polygon polygon;
    for (Ring ring : rings) {
      if (ring.size() > 1 && ring.front().x == ring.back().x && ring.front().y == ring.back().y) {
        ring.pop_back();
      }
      auto& corners = polygon.rings.emplace_back();
      for (const Position& p : ring) {
        corners.push_back({p.x, p.y});
        corner_z_.push_back(p.z);
        all_have_z_ = all_have_z_ && p.has_z;
      }
    }
    file_.input.polygons.push_back(std::move(polygon));
  }

  void add_point(const Position& p) {
    file_.input.points.push_back({p.x, p.y});
    point_z_.push_back(p.z);
    all_have_z_ = all_have_z_ && p.has_z;
  }

  void add_line(const std::vector<Position>& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto end = static_cast<VertexId>(file_.input.points.size());
      if (i > 0) file_.input.segments.push_back({end - 1, end});
      add_point(line[i]);
    }
  }

  const Source& source_;
  PlanarFile file_;
  std::vector<double> corner_z_;
  std::vector<double> point_z_;
  bool all_have_z_ = true;
  std::size_t feature_begin_ = 0;  // the first polygon of the feature being read
  std::map<std::string, std::size_t> data_;
};

}  // namespace

PlanarFile read_geojson_planar(const Source& source) {
  if (source.text.empty()) fail_in(source, "the file is empty", ErrorCode::kTooFewPoints);
  PlanarCollector collector(source);
  visit_geojson(source, collector);
  return collector.finish();
}

}  // namespace quadloom::io
