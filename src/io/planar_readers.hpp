// The readers of polygons and segments, from text in memory. planar.cpp chooses.
#pragma once

#include <functional>
#include <string>

#include "io/source.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

PlanarFile read_geojson_planar(const Source& source);

/// Triangle's .poly. `read_nodes` is called for the text of the .node file that holds the points, if
/// the .poly has none.
PlanarFile read_poly(const Source& source, const std::function<std::string()>& read_nodes);

/// By the name of the format: "geojson", "json", "poly".
PlanarFile read_planar_text(const Source& source, const std::string& format,
                            const std::function<std::string()>& read_nodes);

}  // namespace quadloom::io
