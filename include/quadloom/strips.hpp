// Triangles in order: Hamiltonian and sequential triangulations, strips, spiral polygons.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadloom/convex.hpp"
#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom {

// ---- Point sets. ----

// ---- Polygons. ----

// ---- Triangulations. ----

/// The same triangulation, its triangle order[i] now triangle i; the corners keep their turn. Throws
/// Error kBadOption if `order` has not each triangle once. O(n).
Triangulation reorder_triangles(const Triangulation& mesh, std::span<const TriangleId> order);

/// Whether the last triangle of an order is beside the first.
enum class Closure {
  kOpen,
  kCycle,           ///< they share an edge
  kSequentialCycle  ///< so, and the left and right turns go on alternating across it
};

/// An order of all triangles of a mesh such that left and right turns alternate.
struct SequentialOrder {
  std::vector<TriangleId> order;
  std::vector<VertexId> sequence;  ///< two more than triangles: triangle order[i] has the vertices
                                   ///< sequence[i], sequence[i + 1], sequence[i + 2]
  Closure closure = Closure::kOpen;
};

/// Decides whether a triangulation, in the plane or of a surface, is sequential (Arkin, Held, Mitchell
/// and Skiena, theorem 4.3), and gives an order if it is: of all there are one that closes best, in a tie
/// the first found from triangle 0. Only tri_vertex and twin are looked at. Throws Error kBadMesh for
/// twins that do not agree. O(n).
std::optional<SequentialOrder> sequential_order(const Triangulation& mesh);

// ---- Strips and their encodings. ----

}  // namespace quadloom
