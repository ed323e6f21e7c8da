// The closing lines and the report of a conversion.
#pragma once

#include <string>

#include "convert_mesh.hpp"
#include "report.hpp"

namespace quadloom::app {

/// "3,070 points and 5,780 triangles: 2,890 quads, no triangle, ..., 0.05 s", then a line on what was
/// left over and how it went, and one for each of the first points added on the boundary.
std::string conversion_facts(const SourceMesh& source, const Conversion& made,
                             const ConversionOptions& options);

/// What was found in the source, one remark a line; a witness where triangles were left over.
std::string conversion_remarks(const SourceMesh& source, const Conversion& made,
                               const ConversionOptions& options);

std::string conversion_verdict(const SourceMesh& source, const Conversion& made);

/// "certified: ..." or "NOT CERTIFIED: ..." of a mesh against its source.
std::string source_verdict(const Certificate& certificate, const SourceMesh& source,
                           bool with_outer_points);

Json conversion_json(const SourceMesh& source, const Conversion& made,
                     const ConversionOptions& options);

}  // namespace quadloom::app
