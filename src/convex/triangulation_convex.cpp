// Strictly convex quads of a triangulation: the quads of the pairing, mended inside their parts.
//
// Steps: pair_triangles (quadrangulate/triangulation_pair.hpp), mend_quads (mend.hpp). Borders have no
// twins in the paired mesh, so that no cluster reaches over one. A point that parity puts on a border edge
// is a flat corner there; its quad is mended as any other.
#include <utility>

#include "convex/mend.hpp"
#include "convex/not_convex.hpp"
#include "quadrangulate/triangulation_input.hpp"
#include "quadrangulate/triangulation_pair.hpp"
#include "quadrangulate/triangulation_result.hpp"

namespace quadloom {

using namespace quadrangulate;

ConvexMeshResult convex_quadrangulation(const TriangleMesh& input, const TriangleOptions& options,
                                        std::uint64_t seed) {
  if (options.method != TriangleMethod::kPair || options.leftover == Leftover::kTriangle ||
      options.leftover == Leftover::kError) {
    throw Error(
        ErrorCode::kBadOption,
        "strictly convex quads are made from pairs, with walks or Steiner points for the rest");
  }
  report_progress(options.progress, "input", 0);
  check_triangle_mesh(input);
  if (!input.z.empty()) {
    throw Error(ErrorCode::kBadMesh, "strictly convex quads are made of planar meshes");
  }
  PairedTriangles paired = pair_triangles(input, options);
  ConvexMeshResult result;
  result.mending = convex::mend_quads(paired.mesh, seed, paired.steiner, options.progress,
                                      convex::Improve::kTouched);
  result.quads = to_triangle_result(std::move(paired.mesh), input.mesh.points.size());
  result.quads.steiner = std::move(paired.steiner);
  result.quads.barrier = std::move(paired.barrier);
  result.quads.statistics = paired.statistics;
  result.not_convex = convex::quads_not_convex(result.quads.mesh);
  return result;
}

}  // namespace quadloom
