// Buckets by x, then a sort in each: a third of the time of sorting indices for a million points.
//
// The bucket is a rounded, but monotone, function of x; what is decided by comparing is decided by the
// coordinates.
#include "kernel/lex_order.hpp"

#include <algorithm>
#include <cstdint>

namespace quadloom::kernel {
namespace {

constexpr std::size_t kPerBucket = 4;

struct Item {
  Point at;
  VertexId index;
};

bool before(const Item& a, const Item& b) {
  return lex_less(a.at, b.at) || (!lex_less(b.at, a.at) && a.index < b.index);
}

/// Buckets per unit of x; 0, one bucket, if the extent is 0 or too large or too small for it.
double scale_of(double left, double right, std::size_t buckets) {
  const double scale = static_cast<double>(buckets - 1) / (right - left);
  return right - left <= 0x1p1000 && right - left >= 0x1p-900 ? scale : 0;
}

}  // namespace

LexOrder lex_order(std::span<const Point> points) {
  LexOrder order;
  if (points.empty()) return order;
  const auto [least, greatest] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
  const double left = least->x;
  const std::size_t buckets = points.size() / kPerBucket + 1;
  const double scale = scale_of(left, greatest->x, buckets);
  const auto bucket = [&](Point p) {
    return scale == 0 ? 0 : static_cast<std::size_t>((p.x - left) * scale);
  };

  std::vector<std::uint32_t> end(buckets + 1, 0);
  for (const Point p : points) ++end[bucket(p) + 1];
  for (std::size_t b = 0; b < buckets; ++b) end[b + 1] += end[b];
  std::vector<Item> items(points.size());
  for (VertexId v = 0; v < points.size(); ++v) items[end[bucket(points[v])]++] = {points[v], v};

  order.points.reserve(points.size());
  order.index.reserve(points.size());
  for (std::size_t b = 0, begin = 0; b < buckets; begin = end[b++]) {
    std::sort(items.begin() + static_cast<std::ptrdiff_t>(begin), items.begin() + end[b], before);
  }
  for (const Item& item : items) {
    order.points.push_back(item.at);
    order.index.push_back(item.index);
  }
  return order;
}

}  // namespace quadloom::kernel
