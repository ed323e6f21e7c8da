#include "witness.hpp"

#include <fmt/format.h>

#include <cmath>

#include "facts.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::app {
namespace {

constexpr std::size_t kMostNamed = 8;

bool is_half_of_quad(const TriangleMesh& input, TriangleId t) {
  return !input.given_pair.empty() && input.given_pair[t] != kNone;
}

// Edges that no quad may reach over; the halves of a given quad have each other alone.
std::vector<std::uint8_t> forbidden_edges(const TriangleMesh& input) {
  const Triangulation& mesh = input.mesh;
  std::vector<std::uint8_t> forbidden = input.keep;
  forbidden.resize(mesh.tri_vertex.size(), 0);
  for (HalfedgeId h = 0; h < mesh.twin.size(); ++h) {
    const HalfedgeId twin = mesh.twin[h];
    if (twin == kNone) continue;
    const TriangleId a = triangle_of(h), b = triangle_of(twin);
    const bool regions = !input.region.empty() && input.region[a] != input.region[b];
    const bool quad = is_half_of_quad(input, a) && input.given_pair[a] != h;
    if (regions || quad || mesh.apex(h) == mesh.apex(twin)) forbidden[h] = 1;
  }
  return forbidden;
}

// The pairs that the options allow, but for given quads, which are allowed whatever their shape.
DualGraph allowed_pairs(const TriangleMesh& input, const TriangleOptions& options) {
  const DualGraph graph = dual_graph(input.mesh, forbidden_edges(input));
  constexpr double kWeightScale = 65535;  // of shape_weights
  const std::int32_t least =
      options.min_quality > 0
          ? 1 + static_cast<std::int32_t>(std::ceil(options.min_quality * kWeightScale))
      : options.pairs == PairKind::kConvex ? 1
                                           : 0;
  if (least == 0) return graph;
  std::vector<std::int32_t> weight = shape_weights(input.mesh, input.z);
  for (const HalfedgeId h : input.given_pair) {
    if (h != kNone) weight[h] = least;
  }
  return heavy_edges(graph, weight, least);
}

// Marks the parts with an odd number of triangles, the barrier's triangles left out; counts them.
std::size_t mark_odd_parts(const DualGraph& graph, std::vector<std::uint8_t>& group) {
  std::vector<std::uint8_t> seen(group.begin(), group.end());
  std::vector<TriangleId> part;
  std::size_t odd = 0;
  for (TriangleId first = 0; first < graph.node_count(); ++first) {
    if (seen[first] != 0) continue;
    part = {first};
    seen[first] = 1;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (HalfedgeId h = 3 * part[i]; h < 3 * part[i] + 3; ++h) {
        if (graph.twin[h] == kNone || seen[graph.across(h)] != 0) continue;
        seen[graph.across(h)] = 1;
        part.push_back(graph.across(h));
      }
    }
    if (part.size() % 2 == 0) continue;
    ++odd;
    for (const TriangleId t : part) group[t] = 2;
  }
  return odd;
}

}  // namespace

Witness find_witness(const SourceMesh& source, std::vector<TriangleId> barrier,
                     std::size_t unmatched, const TriangleOptions& options) {
  Witness witness;
  witness.unmatched = unmatched;
  witness.barrier = std::move(barrier);
  witness.all_pairs = options.min_quality == 0 && options.pairs != PairKind::kConvex;
  const DualGraph graph = allowed_pairs(source.triangles, options);
  witness.group.assign(graph.node_count(), 0);
  for (const TriangleId t : witness.barrier) witness.group[t] = 1;
  witness.odd_parts = mark_odd_parts(graph, witness.group);
  witness.proves = witness.odd_parts == unmatched + witness.barrier.size();
  return witness;
}

std::string in_words(const Witness& w, const std::vector<std::uint32_t>& source_face) {
  std::string out = fmt::format(
      "{} {} unmatched whatever is done{}", counted(w.unmatched, "triangle"),
      w.unmatched == 1 ? "stays" : "stay", w.all_pairs ? "" : " with the pairs allowed");
  if (!w.proves) return out;
  const std::string parts = counted(w.odd_parts, "part") + " with an odd number of triangles";
  if (w.barrier.empty()) return out + ": there " + (w.odd_parts == 1 ? "is " : "are ") + parts;
  std::string names;
  for (std::size_t i = 0; i < std::min(kMostNamed, w.barrier.size()); ++i) {
    names += (i > 0 ? ", " : " ") + std::to_string(source_face[w.barrier[i]]);
  }
  return out + fmt::format(": taking the {}{}{} away leaves {}",
                           counted(w.barrier.size(), "triangle"), names,
                           w.barrier.size() > kMostNamed ? ", ..." : "", parts);
}

}  // namespace quadloom::app
