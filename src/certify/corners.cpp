#include "certify/corners.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <string>
#include <utility>

#include "certify/blocks.hpp"
#include "certify/layout.hpp"
#include "certify/wording.hpp"

namespace quadloom::certify {
namespace {

constexpr std::size_t kMostVertices = std::size_t{1} << 31;

bool judge_count(const PolygonMesh& mesh, std::size_t f, const CertifyOptions& options,
                 Certificate& out) {
  const std::size_t corners = mesh.face(f).size();
  if (corners == options.corners) return true;
  if (corners != 3) {
    return fail(out, Fault::kCornerCount,
                face_text(mesh, f) + " has " + std::to_string(corners) + " corners, expected " +
                    std::to_string(options.corners),
                {f});
  }
  if (++out.triangles <= options.triangles_allowed) return true;
  return fail(out, Fault::kTooManyTriangles,
              face_text(mesh, f) + " is triangle number " + std::to_string(out.triangles) + ", " +
                  std::to_string(options.triangles_allowed) + " allowed",
              {f});
}

std::vector<std::size_t> faces_of(const PolygonMesh& mesh, VertexId edge_from, VertexId edge_to) {
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < mesh.face_count() && faces.size() < 2; ++f) {
    const auto corners = mesh.face(f);
    const auto from = std::ranges::find(corners, edge_from);
    if (from == corners.end()) continue;
    if ((from + 1 == corners.end() ? corners.front() : *(from + 1)) == edge_to) faces.push_back(f);
  }
  return faces;
}

/// Few corners are compared by pairs: a quad's six comparisons cost less than sorting it.
bool names_twice(std::span<const VertexId> corners) {
  constexpr std::size_t few = 8;
  if (corners.size() <= few) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (corners[i] == corners[j]) return true;
      }
    }
    return false;
  }
  std::vector<VertexId> sorted(corners.begin(), corners.end());
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) != sorted.end();
}

/// Faces first to last - 1. Blocks of them may mark the same vertices at once.
bool judge_faces(const PolygonMesh& mesh, std::size_t first, std::size_t last,
                 const CertifyOptions& options, Certificate& out, std::vector<std::uint8_t>& used) {
  for (std::size_t f = first; f < last; ++f) {
    ++out.faces;
    if (!judge_count(mesh, f, options, out)) return false;
    for (const VertexId v : mesh.face(f)) {
      if (v >= mesh.points.size()) {
        return fail(out, Fault::kIndexOutOfRange,
                    face_text(mesh, f) + " names a vertex that is not there (" +
                        std::to_string(mesh.points.size()) + " vertices)",
                    {f});
      }
      std::atomic_ref(used[v]).store(1, std::memory_order_relaxed);
    }
    if (names_twice(mesh.face(f))) {
      return fail(out, Fault::kRepeatedCorner, face_text(mesh, f) + " names a vertex twice", {f});
    }
  }
  return true;
}

}  // namespace

bool judge_corners(const PolygonMesh& mesh, const CertifyOptions& options, Certificate& out,
                   std::vector<std::uint8_t>& used) {
  if (!layout_fits(mesh)) {
    return fail(out, Fault::kIndexOutOfRange,
                "the faces' beginnings do not fit the list of corners", {});
  }
  if (mesh.face_count() == 0) return fail(out, Fault::kNoFaces, "the mesh has no faces", {});
  used.assign(mesh.points.size(), 0);
  const auto parts = judge_in_blocks(mesh.face_count(),
                                     [&](std::size_t first, std::size_t last, Certificate& part) {
                                       judge_faces(mesh, first, last, options, part, used);
                                     });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool triangles_fit = out.triangles + parts[i].triangles <= options.triangles_allowed;
    if (!parts[i].ok() || !triangles_fit) {  // again, to count up to the fault
      const std::size_t first = i * kFacesOfBlock;
      return judge_faces(mesh, first, std::min(first + kFacesOfBlock, mesh.face_count()), options,
                         out, used);
    }
    out.faces += parts[i].faces;
    out.triangles += parts[i].triangles;
  }
  return true;
}

void check_options(const CertifyOptions& options) {
  if (options.corners >= 3) return;
  throw Error(ErrorCode::kBadOption,
              "faces have three corners at least, not " + std::to_string(options.corners));
}

void require_few_vertices(const PolygonMesh& mesh) {
  if (mesh.points.size() < kMostVertices) return;
  throw Error(ErrorCode::kTooManyPoints, "a mesh may have fewer than 2^31 vertices");
}

void report_repeated_edge(const PolygonMesh& mesh, VertexId from, VertexId to, Certificate& out) {
  const auto faces = faces_of(mesh, from, to);
  fail(out, Fault::kRepeatedEdge,
       "the edge from " + vertex_text(mesh, from) + " to " + vertex_text(mesh, to) + " is in " +
           face_text(mesh, faces.at(0)) + " and in " + face_text(mesh, faces.at(1)),
       {from, to});
}

}  // namespace quadloom::certify
