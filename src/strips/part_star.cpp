#include "strips/part_star.hpp"

#include "quadrangulate/place_in_kernel.hpp"

namespace quadloom::strips {
namespace {

constexpr std::size_t kMostSides = 48;  // the search for a place is quadratic

/// With the part beyond a side, if there is one and a place. Around a hole a part may have two sides at
/// the star: then both sides of an edge are in it, and no point sees both.
std::optional<PartStar> with_neighbour(const PartSides& sides,
                                       const std::vector<std::uint8_t>& taken, const PartStar& star,
                                       std::size_t i) {
  const SideId beyond = sides.twin(star.sides[i]);
  if (beyond == kNone || taken[sides.part(beyond)] != 0) return std::nullopt;
  const std::vector<SideId> others = sides.others(beyond);
  if (star.sides.size() + others.size() > kMostSides) return std::nullopt;
  PartStar grown = star;
  const auto at = grown.sides.erase(grown.sides.begin() + static_cast<std::ptrdiff_t>(i));
  grown.sides.insert(at, others.begin(), others.end());
  grown.parts.push_back(sides.part(beyond));
  grown.place = quadrangulate::place_in_kernel(corners_of(sides, grown));
  if (!grown.place) return std::nullopt;
  return grown;
}

}  // namespace

std::vector<Point> corners_of(const PartSides& sides, const PartStar& star) {
  std::vector<Point> corners;
  for (const SideId s : star.sides) corners.push_back(sides.at(sides.origin(s)));
  corners.insert(corners.end(), star.closing.begin(), star.closing.end());
  return corners;
}

void grow_star(const PartSides& sides, std::vector<std::uint8_t>& taken, PartStar& star) {
  for (std::size_t i = 0; i < star.sides.size();) {
    auto grown = with_neighbour(sides, taken, star, i);
    if (!grown) {
      ++i;
      continue;
    }
    taken[grown->parts.back()] = 1;
    star = std::move(*grown);
  }
}

}  // namespace quadloom::strips
