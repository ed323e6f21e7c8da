// Cycles of triangles made into paths.
#pragma once

#include <cstdint>
#include <vector>

#include "quadloom/dual.hpp"
#include "strips/way_tables.hpp"

namespace quadloom::strips {

/// By halfedge: whether the edge is on a path or cycle, that is used from both of its sides. O(n).
std::vector<std::uint8_t> used_edges(const DualGraph& graph, const std::vector<Way>& way);

/// Makes ways say no more than what is used, then opens every cycle where it costs least: into the
/// end of a path beside it, into a cycle beside it, or by itself. O(n).
void open_cycles(const DualGraph& graph, const WayTables& tables, std::vector<Way>& way);

}  // namespace quadloom::strips
