// A place inside a triangle of a planar mesh or of a surface.
#pragma once

#include <optional>

#include "kernel/chart.hpp"

namespace quadloom::quadrangulate {

/// Strictly inside the counter-clockwise triangle, exactly in the plane; on a surface exactly in its
/// chart and on its plane up to rounding. Empty if there is no such double near.
std::optional<kernel::Vector3> place_in_face(const kernel::Places& places, VertexId a, VertexId b,
                                             VertexId c);

}  // namespace quadloom::quadrangulate
