// Fans and components by joining: the two faces at an edge join their corners at each of its ends.
//
//        \  |  /
//      c1 \ | / c0     corners at v; the edge up from v joins c0 and c1
//      ----v----       what is joined in the end is a fan
#include "certify/topology.hpp"

#include <numeric>

#include "certify/edges.hpp"

namespace quadloom::certify {
namespace {

/// Sets of numbers that are joined, with path halving; the smallest number stands for its set.
class Joined {
 public:
  explicit Joined(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i < j) {
      parent_[j] = i;
    } else {
      parent_[i] = j;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

Topology topology_of(const PolygonMesh& mesh) {
  const std::vector<std::uint32_t> reverse = reverse_edges(mesh);
  Joined corners(mesh.face_vertex.size()), faces(mesh.face_count());
  std::vector<std::uint32_t> face_of(mesh.face_vertex.size());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) face_of[c] = f;
  }
  const auto next = [&](std::uint32_t c) {
    const std::uint32_t f = face_of[c];
    return c + 1 == mesh.face_begin[f + 1] ? mesh.face_begin[f] : c + 1;
  };
  for (std::uint32_t c = 0; c < reverse.size(); ++c) {
    if (reverse[c] == kNone) continue;
    corners.join(c, next(reverse[c]));
    faces.join(face_of[c], face_of[reverse[c]]);
  }

  Topology out;
  std::vector<std::uint32_t> component(mesh.face_count(), kNone);
  for (std::uint32_t f = 0; f < component.size(); ++f) {
    if (faces.find(f) == f) {
      component[f] = static_cast<std::uint32_t>(out.euler.size());
      out.euler.push_back(0);
    }
    component[f] = component[faces.find(f)];
    ++out.euler[component[f]];
  }
  out.fans.assign(mesh.points.size(), 0);
  out.component.assign(mesh.points.size(), kNone);
  for (std::uint32_t c = 0; c < reverse.size(); ++c) {
    const std::uint32_t at = component[face_of[c]];
    if (reverse[c] == kNone || c < reverse[c]) --out.euler[at];
    if (corners.find(c) != c) continue;
    ++out.euler[at];
    ++out.fans[mesh.face_vertex[c]];
    out.component[mesh.face_vertex[c]] = at;
  }
  return out;
}

}  // namespace quadloom::certify
