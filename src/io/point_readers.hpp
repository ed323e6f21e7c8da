// The readers of points, from text in memory. One file each; points.cpp chooses.
#pragma once

#include "io/line_blocks.hpp"
#include "io/source.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

// Tables are read in blocks of about so many bytes; what comes out does not depend on that.

/// Fields separated by commas, semicolons or tabs (whichever the first line has), quotes allowed.
PointTable read_csv_points(const Source& source, const std::string& columns,
                           std::size_t block_bytes = kBlockBytes);

/// Numbers separated by blanks, commas, semicolons or tabs.
PointTable read_xyz_points(const Source& source, const std::string& columns,
                           std::size_t block_bytes = kBlockBytes);

/// Every Point and MultiPoint of a GeoJSON text.
PointTable read_geojson_points(const Source& source);

/// The points of Triangle's .node, in order; without line numbers.
PointTable read_node_points(const Source& source);

/// By the name of the format: "csv", "xyz", "geojson", "node". Throws as read_points does.
PointTable read_points_text(const Source& source, const std::string& format,
                            const std::string& columns = {});

}  // namespace quadloom::io
