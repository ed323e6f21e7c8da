#include <cstdio>
#include <quadloom/quadloom.hpp>
#include <vector>

int main() {
  const std::vector<quadloom::Point> places = {{0, 0}, {4, 0}, {8, 1}, {9, 5}, {5, 8},
                                               {1, 6}, {3, 3}, {6, 4}, {4, 5}, {2, 2}};
  const quadloom::PointResult result = quadloom::quadrangulate_points(places);
  for (std::size_t q = 0; q < result.mesh.quad_count(); ++q) {
    const quadloom::VertexId* corner = &result.mesh.quad_vertex[4 * q];
    std::printf("quad %u %u %u %u\n", corner[0], corner[1], corner[2], corner[3]);
  }
  const quadloom::Certificate verdict =
      quadloom::certify_points(quadloom::to_polygon_mesh(result.mesh), places);
  std::printf("%zu points added, %s\n", result.steiner.size(),
              verdict.ok() ? "certified" : verdict.sentence.c_str());
  return verdict.ok() ? 0 : 1;
}
