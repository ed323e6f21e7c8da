// Points from GeoJSON: the Points and MultiPoints of anything that holds them, in order.

#include <fmt/format.h>

#include "io/geojson.hpp"
#include "io/point_readers.hpp"

namespace quadloom::io {
namespace {

class PointCollector : public GeojsonVisitor {
 public:
  explicit PointCollector(const Source& source) : source_(source) {}

  void geometry(const std::string& type, const CoordinateTape& tape) override {
    if (type != "Point" && type != "MultiPoint") {
      fail_in(source_, fmt::format("it holds a {}, expected Point and MultiPoint only", type));
    }
    for (const Position& p : positions_of(source_, type, tape)) {
      table.points.push_back({p.x, p.y});
      table.z.push_back(p.z);
      all_have_z = all_have_z && p.has_z;
    }
  }

  PointTable table;
  bool all_have_z = true;

 private:
  const Source& source_;
};

}  // namespace

PointTable read_geojson_points(const Source& source) {
  if (source.text.empty()) fail_in(source, "the file is empty", ErrorCode::kTooFewPoints);
  PointCollector collector(source);
  visit_geojson(source, collector);
  if (!collector.all_have_z) collector.table.z.clear();
  if (collector.table.points.empty()) {
    fail_in(source, "the file holds no points", ErrorCode::kTooFewPoints);
  }
  return std::move(collector.table);
}

}  // namespace quadloom::io
