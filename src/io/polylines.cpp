// Polylines, rings and polygons as GeoJSON.

#include <cmath>

#include "io/geojson.hpp"
#include "io/output.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {
namespace {

void write_position(Output& out, Point p) { out << '[' << p.x << ',' << p.y << ']'; }

void write_line(Output& out, const Polyline& line, const std::string& key) {
  out << R"({"type":"Feature","properties":{)" << key << ':';
  if (std::isfinite(line.value)) {
    out << line.value;
  } else {
    out << "null";
  }
  out << (line.closed ? R"(},"geometry":{"type":"Polygon","coordinates":[[)"
                      : R"(},"geometry":{"type":"LineString","coordinates":[)");
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (i > 0) out << ',';
    write_position(out, line.points[i]);
  }
  if (line.closed && !line.points.empty()) {
    out << ',';
    write_position(out, line.points[0]);
  }
  out << (line.closed ? "]]}}" : "]}}");
}

// The first corner again at the end, as GeoJSON has it.
void write_ring(Output& out, std::span<const Point> ring) {
  out << '[';
  for (const Point p : ring) {
    write_position(out, p);
    out << ',';
  }
  write_position(out, ring[0]);
  out << ']';
}

}  // namespace

void write_polygons(const std::string& path, std::span<const Polygon> polygons) {
  Output out(path);
  out << R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n")
        << R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[)";
    for (std::size_t r = 0; r < polygons[i].rings.size(); ++r) {
      if (polygons[i].rings[r].empty()) {
        throw Error(ErrorCode::kBadPolygon, "a ring without corners cannot be written", {i, r});
      }
      if (r > 0) out << ',';
      write_ring(out, polygons[i].rings[r]);
    }
    out << "]}}";
  }
  out << "\n]}\n";
  out.commit();
}

void write_polylines(const std::string& path, std::span<const Polyline> lines,
                     const std::string& name) {
  const std::string key = json_string(name);
  Output out(path);
  out << R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n");
    write_line(out, lines[i], key);
  }
  out << "\n]}\n";
  out.commit();
}

}  // namespace quadloom::io
