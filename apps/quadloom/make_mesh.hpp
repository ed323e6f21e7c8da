// From points to a judged mesh: what quadrangulate does once and compare for every method.
#pragma once

#include <optional>
#include <vector>

#include "quadloom/certify.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::app {

struct MadeMesh {
  io::MeshFile file;  // with z if the points have it, "added" per vertex and "shape" per face
  std::vector<SteinerPoint> steiner;
  std::size_t input_points = 0;
  std::size_t input_vertices = 0;  // distinct ones
  std::size_t other_z = 0;  // repeated points whose z differs from the first one's, which is kept
  PointStatistics statistics;
  Certificate certificate;
  Quality quality;
  double total_edge_length = 0;
  double seconds = 0;  // of the algorithm alone
  double certify_seconds = 0;
};

/// Faces of k corners; k = 4 by the method of the options, more by the spiral.
MadeMesh make_mesh(const io::PointTable& table, const PointOptions& options, std::size_t k);

/// More points were added than Bose and Toussaint's bound for faces of k > 4 corners, k - 3.
bool beyond_bound(const MadeMesh& made, std::size_t k);

std::vector<VertexId> steiner_vertices(const MadeMesh& made);

}  // namespace quadloom::app
