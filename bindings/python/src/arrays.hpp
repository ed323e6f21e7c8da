// The library's vectors as NumPy arrays: views that keep their owner alive, and may not be written to.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/typing.h>

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "quadloom/core.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom::python {

template <typename Scalar, std::size_t Width>
struct ArrayOf {
  using type = nanobind::ndarray<nanobind::numpy, const Scalar,
                                 nanobind::shape<-1, static_cast<nanobind::ssize_t>(Width)>>;
};
template <typename Scalar>
struct ArrayOf<Scalar, 1> {
  using type = nanobind::ndarray<nanobind::numpy, const Scalar, nanobind::shape<-1>>;
};
/// Shape (n, Width), or (n,) for Width 1.
template <typename Scalar, std::size_t Width = 1>
using Array = typename ArrayOf<Scalar, Width>::type;

/// How many numbers of which type an element of a vector is.
template <typename T>
struct Element {
  using scalar = T;
  static constexpr std::size_t width = 1;
};
template <>
struct Element<Point> {
  using scalar = double;
  static constexpr std::size_t width = 2;
  static_assert(sizeof(Point) == 2 * sizeof(double));
};
template <>
struct Element<Segment> {
  using scalar = VertexId;
  static constexpr std::size_t width = 2;
  static_assert(sizeof(Segment) == 2 * sizeof(VertexId));
};
template <typename T, std::size_t N>
struct Element<std::array<T, N>> {
  using scalar = T;
  static constexpr std::size_t width = N;
};

/// A view of `count` rows; without an owner the return policy decides who that is.
template <typename Scalar, std::size_t Width>
Array<Scalar, Width> view_rows(const void* data, std::size_t count, nanobind::handle owner = {}) {
  static const Scalar nothing{};
  const std::size_t shape[2] = {count, Width};
  return Array<Scalar, Width>(data != nullptr ? data : &nothing, Width == 1 ? 1 : 2, shape, owner);
}

/// A contiguous container of elements as rows; flat lists of corners (of scalars) are cut into rows of Width.
template <std::size_t Width = 1, typename Container>
auto view(const Container& elements, nanobind::handle owner = {}) {
  using E = Element<std::remove_cv_t<typename Container::value_type>>;
  static_assert(Width == 1 || E::width == 1);
  return view_rows<typename E::scalar, Width * E::width>(elements.data(), elements.size() / Width,
                                                         owner);
}

/// An array that owns the vector.
template <std::size_t Width = 1, typename T>
auto own(std::vector<T> elements) {
  auto* const kept = new std::vector<T>(std::move(elements));
  const nanobind::capsule owner(kept,
                                [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return view<Width>(*kept, owner);
}

/// x, y and z of each point.
inline std::vector<double> interleaved(std::span<const Point> points, std::span<const double> z) {
  std::vector<double> out;
  out.reserve(3 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    out.insert(out.end(), {points[i].x, points[i].y, z[i]});
  }
  return out;
}

/// A list of rings, float64 (k, 2) each, the outer one first.
using Rings = nanobind::typed<nanobind::list, Array<double, 2>>;
inline Rings rings_of(const Polygon& polygon) {
  nanobind::list out;
  for (const std::vector<Point>& ring : polygon.rings) out.append(own(std::vector(ring)));
  return nanobind::borrow<Rings>(out);
}

}  // namespace quadloom::python
