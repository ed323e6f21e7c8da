// Weights of pairs of triangles by shape.
//
// quad_shape is 1 - (2/pi) max |pi/2 - angle|, so (2/pi) acos of the greatest |cosine|, which
// squareness gives. The arc cosine is a polynomial (Abramowitz and Stegun 4.4.46, error 2e-8), since
// that of the standard library may differ from platform to platform.
#include <cmath>
#include <string>

#include "dual/pair_shape.hpp"
#include "quadloom/dual.hpp"

namespace quadloom {
namespace {

constexpr double kTwoOverPi = 0.63661977236758134;

/// For x in [0, 1].
double arc_cosine(double x) {
  constexpr double kCoefficients[] = {-0.0012624911, 0.0066700901, -0.0170881256, 0.0308918810,
                                      -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050};
  double sum = 0;
  for (const double coefficient : kCoefficients) sum = sum * x + coefficient;
  return std::sqrt(1 - x) * sum;
}

}  // namespace

std::vector<std::int32_t> shape_weights(const Triangulation& mesh, std::span<const double> z) {
  if (!z.empty() && z.size() != mesh.points.size()) {
    throw Error(ErrorCode::kBadOption, std::to_string(z.size()) + " heights for " +
                                           std::to_string(mesh.points.size()) + " vertices");
  }
  const kernel::Places places{mesh.points, z};
  std::vector<std::int32_t> weight(mesh.twin.size());
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == kNone || mesh.twin[h] < h) continue;
    const double squareness =
        z.empty() ? dual::pair_squareness(mesh, h) : dual::pair_squareness(mesh, places, h);
    if (squareness < 0) continue;
    const double shape = kTwoOverPi * arc_cosine(1 - squareness);
    weight[h] = 1 + static_cast<std::int32_t>(shape * 65535);
    weight[mesh.twin[h]] = weight[h];
  }
  return weight;
}

std::vector<std::int32_t> shape_weights(const TriangleMesh& mesh) {
  return shape_weights(mesh.mesh, mesh.z);
}

}  // namespace quadloom
