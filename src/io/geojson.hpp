// GeoJSON as a stream: geometries and the numbers of their features, without a tree in memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/source.hpp"

namespace quadloom::io {

/// A "coordinates" value: brackets and numbers in the order of the text.
struct CoordinateTape {
  enum class Kind : std::uint8_t { kOpen, kClose, kNumber };
  std::vector<Kind> kind;
  std::vector<double> number;  ///< one for each kNumber

  void clear();
  void add(Kind k) { kind.push_back(k); }
  void add(double value);
};

/// A position with or without a height.
struct Position {
  double x = 0;
  double y = 0;
  double z = 0;
  bool has_z = false;
};
using Ring = std::vector<Position>;

/// The positions of the tape of a Point or MultiPoint.
std::vector<Position> positions_of(const Source& source, std::string_view type,
                                   const CoordinateTape& tape);

/// The rings of each polygon of a Polygon or MultiPolygon.
std::vector<std::vector<Ring>> polygons_of(const Source& source, std::string_view type,
                                           const CoordinateTape& tape);

/// Numbers in a feature's properties; null is NaN.
using Properties = std::vector<std::pair<std::string, double>>;

class GeojsonVisitor {
 public:
  virtual ~GeojsonVisitor() = default;
  /// A geometry that has coordinates.
  virtual void geometry(const std::string& type, const CoordinateTape& tape) = 0;
  /// The end of a feature, after its geometries.
  virtual void feature_end(const Properties&) {}
};

/// Walks through a Feature, FeatureCollection, GeometryCollection or geometry. Members of any other
/// name are skipped. Throws Error kParse (with the line for faults of the text) and kNotFinite (a
/// number too big for a double).
void visit_geojson(const Source& source, GeojsonVisitor& visitor);

/// A JSON string with its quotes.
std::string json_string(std::string_view text);

}  // namespace quadloom::io
