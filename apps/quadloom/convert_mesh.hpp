// From the source of a conversion to a judged mesh.
#pragma once

#include "carry_data.hpp"
#include "quadloom/certify.hpp"
#include "quadloom/convex.hpp"
#include "witness.hpp"

namespace quadloom::app {

struct ConversionOptions {
  TriangleOptions triangles;
  std::string weight = "shape";  // shape, convexity, or the name of vertex data
  bool convex = false;           // strictly convex quads: kPair by convex_quadrangulation
  std::uint64_t seed = 1;        // convex: see ConvexOptions
};

struct Conversion {
  io::MeshFile file;
  TriangleResult result;
  std::optional<MendStatistics> mending;  // made by convex_quadrangulation
  std::vector<QuadId> not_convex;         // ConversionOptions::convex: quads that are not
  Certificate certificate;
  std::string lost;  // what was to stay and has not: see lost_feature
  Quality quality;
  double convert_seconds = 0, certify_seconds = 0;

  bool ok() const { return certificate.ok() && lost.empty(); }
};

/// Converts, carries the data over and certifies with what the method promises. Throws as
/// quadrangulate_triangles and convex_quadrangulation; kBadOption for a weight that is not there or not
/// finite.
Conversion convert_mesh(const SourceMesh& source, const ConversionOptions& options);

/// What has no perfect matching, by Leftover::kTriangle in place of kError.
Witness explain_leftover(const SourceMesh& source, const ConversionOptions& options);

/// A mesh against its source: certify_mesh, certify_polygons or certify_surface, as the source is.
Certificate certify_against(const io::MeshFile& file, const SourceMesh& source,
                            const CertifyOptions& options);

}  // namespace quadloom::app
