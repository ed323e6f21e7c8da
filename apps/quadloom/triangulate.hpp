// quadloom triangulate: what its parts, one for each kind of input, share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "convert_mesh.hpp"
#include "mesh_input.hpp"
#include "options.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/strips.hpp"

namespace quadloom::app {

enum class TriangulationKind {
  kDelaunay,
  kHamiltonianPath,
  kHamiltonianCycle,
  kSerpentine,
  kSequential,
};
std::string name_of(TriangulationKind kind);

/// Whether an order of triangles may need points that are not the input's. kAuto is resolved before the
/// parts see it: allowed for Hamiltonian cycles of meshes, else none.
enum class Added { kAuto, kNone, kAllowed };

struct TriangulateOptions {
  InputOptions input;
  InputKind input_kind = InputKind::kAuto;
  TriangulationKind kind = TriangulationKind::kDelaunay;
  std::optional<Splitter> splitter;  // given: hamiltonian-cycle of points alone
  std::uint64_t seed = 1;            // likewise
  Added added = Added::kAuto;
  MeshReading reading;                 // meshes alone
  std::optional<std::uint64_t> limit;  // of searches; none: the library's
  std::string output, output_format, picture;
};

/// Triangles, judged but for their order.
struct MadeTriangles {
  io::MeshFile file;
  std::optional<OrderKind> order;  // what the order of the triangles promises; none: nothing
  std::vector<std::uint32_t>
      piece_begin;                // where each order begins, and the end of the last one, if
                                  // there are several, one for each component; else empty
  std::vector<VertexId> steiner;  // added points
  std::string remarks;            // sentences, one a line
  Certificate certificate;
  std::string verdict;
  double seconds = 0;  // of the algorithm alone
};

MadeTriangles triangulate_points(const TriangulateOptions& options, const io::PointTable& table);
MadeTriangles triangulate_polygons(const TriangulateOptions& options, FoundInput found);
MadeTriangles triangulate_mesh(const TriangulateOptions& options, FoundInput found);

/// What is promised of triangles: three corners, and so many added points.
CertifyOptions triangles_alone(std::size_t steiner_at_most);

/// Error kBadOption: there is no such kind for that input; `kinds` are those that there are.
[[noreturn]] void no_such_kind(TriangulationKind kind, const std::string& input,
                               const std::string& kinds);

}  // namespace quadloom::app
