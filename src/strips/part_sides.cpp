#include "strips/part_sides.hpp"

#include <algorithm>

#include "quadloom/kernel.hpp"

namespace quadloom::strips {

PartSides::PartSides(const PolygonMesh& parts) : parts_(parts) {
  const auto count = static_cast<SideId>(parts.face_vertex.size());
  for (PartId f = 0; f < parts.face_count(); ++f) part_.resize(parts.face_begin[f + 1], f);
  twin_.assign(count, kNone);
  std::vector<SideId> sorted(count);
  for (SideId s = 0; s < count; ++s) sorted[s] = s;
  const auto ends = [&](SideId s) { return std::minmax({origin(s), target(s)}); };
  std::sort(sorted.begin(), sorted.end(), [&](SideId s, SideId t) {
    const auto a = ends(s), b = ends(t);
    return a != b ? a < b : s < t;
  });
  for (SideId i = 1; i < count; ++i) {
    const SideId s = sorted[i - 1], t = sorted[i];
    if (origin(s) != target(t) || target(s) != origin(t)) continue;
    twin_[s] = t;
    twin_[t] = s;
  }
}

SideId PartSides::next(SideId s) const {
  return s + 1 == parts_.face_begin[part_[s] + 1] ? parts_.face_begin[part_[s]] : s + 1;
}

SideId PartSides::previous(SideId s) const {
  return s == parts_.face_begin[part_[s]] ? parts_.face_begin[part_[s] + 1] - 1 : s - 1;
}

std::vector<SideId> PartSides::others(SideId s) const {
  std::vector<SideId> out;
  for (SideId t = next(s); t != s; t = next(t)) out.push_back(t);
  return out;
}

int PartSides::orient2d_of(SideId s, SideId then) const {
  return orient2d(at(origin(s)), at(target(s)), at(target(then)));
}

}  // namespace quadloom::strips
