#include "quadrangulate/face_range.hpp"

#include <algorithm>

namespace quadloom::quadrangulate {
namespace {

/// About three in a hundred faces of a range are next to another one, and wait until the ranges are done.
constexpr std::size_t kFacesOfARange = std::size_t{1} << 16;

}  // namespace

std::vector<FaceRange> face_ranges(std::size_t faces) {
  std::vector<FaceRange> ranges;
  if (faces < 2 * kFacesOfARange) return ranges;
  for (std::size_t begin = 0; begin < faces; begin += kFacesOfARange) {
    ranges.push_back({static_cast<std::uint32_t>(begin),
                      static_cast<std::uint32_t>(std::min(faces, begin + kFacesOfARange))});
  }
  return ranges;
}

}  // namespace quadloom::quadrangulate
