#include "quadrangulate/inner_place.hpp"

#include "quadrangulate/place_inside.hpp"

namespace quadloom::quadrangulate {

std::optional<kernel::Vector3> place_in_face(const kernel::Places& places, VertexId a, VertexId b,
                                             VertexId c) {
  const kernel::Chart chart = places.chart(a, b, c);
  const Point pa = places.seen(chart, a), pb = places.seen(chart, b), pc = places.seen(chart, c);
  const auto place = place_inside(pa, pb, pc);
  if (!place || places.planar()) {
    return place ? std::optional(kernel::Vector3{place->x, place->y, 0}) : std::nullopt;
  }
  return chart.lift(*place, {places.at(a), places.at(b), places.at(c)});
}

}  // namespace quadloom::quadrangulate
