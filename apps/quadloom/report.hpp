// Figures as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "make_mesh.hpp"

namespace quadloom::app {

using Json = nlohmann::ordered_json;

Json certificate_json(const Certificate& certificate);
Json quality_json(const Quality& quality);

/// One run: method, counts, added points, certificate, quality, seconds.
Json mesh_json(const MadeMesh& made, const PointRun& run);

/// The head of every report: program, version, the input and its size.
Json report_head(const std::string& verb, const std::string& input, std::size_t points);

}  // namespace quadloom::app
