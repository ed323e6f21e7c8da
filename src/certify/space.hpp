// Faces in space, seen in coordinate planes, where predicates are exact.
#pragma once

#include <span>

#include "kernel/chart.hpp"

namespace quadloom::certify {

/// Twice the face's area, along its normal; up to rounding.
kernel::Vector3 area_of(const kernel::Places& places, std::span<const VertexId> face);

/// All corners on one line, exactly.
bool on_a_line(const kernel::Places& places, std::span<const VertexId> face);

/// In the coordinate plane that the face is nearest to: PolygonVerdict::smallest_turn, -1 if it is
/// not simple there.
int smallest_turn_in_chart(const kernel::Places& places, std::span<const VertexId> face);

/// The angle at b of a, b, c in degrees, [0, 180]; plain floating point, without overflow.
double angle_in_space(kernel::Vector3 a, kernel::Vector3 b, kernel::Vector3 c);

}  // namespace quadloom::certify
