// What kind of thing an input file holds.
#pragma once

#include <optional>
#include <string>

#include "quadloom/io.hpp"

namespace quadloom::app {

enum class InputKind { kAuto, kPoints, kPolygons, kMesh };

struct FoundInput {
  InputKind kind = InputKind::kPoints;
  std::optional<io::PlanarFile> planar;  ///< read on the way, to tell what a GeoJSON holds
  double read_seconds = 0;               ///< what that took
};

/// By the name of the format (empty: the file's ending): points, a mesh or polygons; a GeoJSON is
/// read, points if it has nothing else, polygons if it has. Standard input without a format and
/// unknown endings are points, whose reader says what is wrong. Anything but kAuto is `asked`'s.
FoundInput find_input(const std::string& path, const std::string& format, InputKind asked);

}  // namespace quadloom::app
