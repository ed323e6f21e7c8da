#include "elevation.hpp"

#include "interpolate.hpp"

namespace quadloom::app {

Elevation carry_elevation(std::span<const double> input_z,
                          std::span<const VertexId> input_to_vertex, std::span<const Point> points,
                          std::span<const SteinerPoint> steiner) {
  Elevation out;
  out.z.assign(points.size(), 0);
  std::vector<bool> known(points.size(), false);
  for (std::size_t i = 0; i < input_z.size(); ++i) {
    const VertexId v = input_to_vertex[i];
    if (!known[v]) {
      out.z[v] = input_z[i];
      known[v] = true;
    } else if (out.z[v] != input_z[i]) {
      ++out.other_z;
    }
  }
  interpolate(blends(steiner, points), out.z);
  return out;
}

}  // namespace quadloom::app
