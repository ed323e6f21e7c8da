// Which part each triangle of a constrained triangulation belongs to.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/planar_edges.hpp"

namespace quadloom::kernel {

/// The polygon that each triangle is in, kNone outside. `edge` is as in ConstrainedResult;
/// `also` maps an input edge to a second one with the same ends, of another polygon. Throws Error
/// kBadPolygon. Linear.
std::vector<std::uint32_t> polygon_parts(
    const Triangulation& mesh, std::span<const std::uint32_t> edge, const PlanarEdges& edges,
    const std::unordered_map<std::uint32_t, std::uint32_t>& also);

/// Where there are no polygons: `inside` of each triangle is 1 if segments separate it from the
/// outside and no hole's place is in its part; `part` is the region whose place is there.
struct EnclosedParts {
  std::vector<std::uint8_t> inside;
  std::vector<std::uint32_t> part;
};

/// Throws Error kBadOption (a place on an edge).
EnclosedParts enclosed_parts(const Triangulation& mesh, std::span<const std::uint32_t> edge,
                             const PlanarInput& input);

}  // namespace quadloom::kernel
