// The steps of connect_triangles, one file each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kernel/chart.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::kernel {

/// What the steps work on. Triangles are those of `out`; until orient_faces they go around as
/// given, and given_pair has one entry a triangle.
struct Connecting {
  const PolygonMesh& input;
  std::span<const double> z;
  const ConnectOptions& options;
  ConnectedMesh out = {};
  std::vector<VertexId> vertex_to_input = {};  // vertices merged; empty: the numbers are the same

  Triangulation& mesh() { return out.triangles.mesh; }
  const Triangulation& mesh() const { return out.triangles.mesh; }
  Places places() const { return {mesh().points, out.triangles.z}; }
  bool repairs() const { return options.faulty == FaultyFaces::kRepair; }

  /// Throw Error kBadMesh: "face 7 (vertices 1 2 3) WHAT", "the edge from vertex 1 (0, 0) to vertex
  /// 2 (1, 0) WHAT". Numbers are those of the input.
  [[noreturn]] void refuse_face(std::size_t face, const std::string& what) const;
  [[noreturn]] void refuse_edge(VertexId from, VertexId to, const std::string& what) const;
};

/// Per vertex the first vertex at the same place. O(n log n).
std::vector<VertexId> first_at_place(const Places& places);

/// Fills Connecting::space, or leaves what was asked for.
void decide_space(Connecting& work);

/// Merges vertices at the same place or, in the plane, refuses them.
void place_vertices(Connecting& work);

/// Makes triangles of the faces.
void split_faces(Connecting& work);

/// How a quad, seen in a plane, is cut in two.
struct QuadCut {
  int turn = 0;        ///< of both halves: 1 counter-clockwise, -1 clockwise; 0: not simple
  bool from_a = true;  ///< the diagonal is a-c, else b-d
};
QuadCut cut_quad(Point a, Point b, Point c, Point d);

/// Per halfedge the other one between the same two vertices, whichever way it goes; kNone if there
/// is none. The diagonals of quads are each other's. Throws Error kBadMesh for a third face.
/// Linear, but for sorting the edges at a vertex.
std::vector<HalfedgeId> match_sides(const Connecting& work,
                                    const char* crowded = "has three faces");

/// Turns triangles around until both sides of each edge go opposite ways, and sets the twins.
void orient_faces(Connecting& work, std::span<const HalfedgeId> other);

/// Repairs triangles without area.
void repair_flat_triangles(Connecting& work);

/// Whether the corners are on one line, exactly, and which of them is between the others; -1 if two
/// are at the same place.
bool is_flat(const Places& places, std::span<const VertexId, 3> corners);
int middle_corner(const Places& places, std::span<const VertexId, 3> corners);

}  // namespace quadloom::kernel
