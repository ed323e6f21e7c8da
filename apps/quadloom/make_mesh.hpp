// From points to a judged mesh: what quadrangulate does once and compare for every method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "quadloom/certify.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::app {

/// How a mesh of points is made.
struct PointRun {
  PointOptions making;
  std::size_t k = 4;    // corners of the faces: 4 by the method of the options, more by the spiral
  bool convex = false;  // strictly convex quads by convex_quadrangulation, or kSubdivide
  ConvexMethod convex_method = ConvexMethod::kDelaunay;  // of convex, but for kSubdivide
  bool exact = false;  // convex: without added points, or the answer that there is no such mesh
};

struct MadeMesh {
  io::MeshFile file;  // with z if the points have it
  std::vector<SteinerPoint> steiner;
  std::size_t input_points = 0;
  std::size_t input_vertices = 0;  // distinct ones
  std::size_t other_z = 0;  // repeated points whose z differs from the first one's, which is kept
  PointStatistics statistics;
  std::optional<ConvexStatistics> convex;  // made by convex_quadrangulation
  std::vector<QuadId> not_convex;          // PointRun::convex: quads that are not
  Certificate certificate;
  Quality quality;
  double total_edge_length = 0;
  double seconds = 0;  // of the algorithm alone
  double certify_seconds = 0;
};

/// Throws Error kBadOption for PointRun::convex with OddBoundary::kOnEdge;
/// kGuarantee for PointRun::exact if there is no such mesh, or if that is not known.
MadeMesh make_mesh(const io::PointTable& table, const PointRun& run);

/// Adds what files tell beside the mesh: "added" per vertex and "shape" per face.
void add_attributes(MadeMesh& made);

/// As on the command line.
std::string method_name(const PointRun& run);

/// More points were added than Bose and Toussaint's bound for faces of k > 4 corners, k - 3.
bool beyond_bound(const MadeMesh& made, std::size_t k);

std::vector<VertexId> steiner_vertices(const MadeMesh& made);

}  // namespace quadloom::app
