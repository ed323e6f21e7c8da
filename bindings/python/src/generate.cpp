// include/quadloom/generate.hpp: named point sets and polygons.
#include "quadloom/generate.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include "bind.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
void bind_generate(nb::module_& m) {
  Fields<Generator>(m, "Generator", "One kind of point set.")
      .value("name", &Generator::name, "What generate_points knows it by.")
      .value("what", &Generator::what, "One line for a help text.")
      .value("min_points", &Generator::min_points, "The least n.")
      .done();
  Fields<PolygonGenerator>(m, "PolygonGenerator", "One kind of simple polygon.")
      .value("name", &PolygonGenerator::name, "What generate_polygon knows it by.")
      .value("what", &PolygonGenerator::what, "One line for a help text.")
      .value("min_corners", &PolygonGenerator::min_corners, "The least n.")
      .done();
  m.def(
      "generators",
      [] {
        const auto all = generators();
        return std::vector<Generator>(all.begin(), all.end());
      },
      "All kinds of point sets.");
  m.def(
      "polygon_generators",
      [] {
        const auto all = polygon_generators();
        return std::vector<PolygonGenerator>(all.begin(), all.end());
      },
      "All kinds of polygons.");
  m.def(
      "generate_points",
      [](const std::string& kind, std::size_t n, std::uint64_t seed) {
        return own(without_gil([&] { return generate_points(kind, n, seed); }));
      },
      "kind"_a, "n"_a, "seed"_a = 1,
      R"(n points (as near to n as the kind allows) of the kind of that name, float64 (n, 2), never all on one line; the
same n and seed give the same numbers on every platform.

Raises Error: bad-option for an unknown name (the sentence lists the names) or an n that is too small.)");
  m.def(
      "generate_polygon",
      [](const std::string& kind, std::size_t n, std::uint64_t seed) {
        return rings_of(without_gil([&] { return generate_polygon(kind, n, seed); }));
      },
      "kind"_a, "n"_a, "seed"_a = 1,
      R"(A simple polygon of n corners (as near to n as the kind allows) with whole coordinates below 2^32: a list of one
ring, float64 (n, 2).

Raises Error as generate_points.)");
  m.def(
      "with_holes",
      [](const PolygonsLike& polygon, std::size_t holes, std::uint64_t seed) {
        const Polygon given = polygon_from(polygon);
        return rings_of(without_gil([&] { return with_holes(given, holes, seed); }));
      },
      "polygon"_a, "holes"_a, "seed"_a = 1,
      "The polygon eight times as big and with triangles cut out of it, at most `holes` and one "
      "from each of "
      "the triangles that constrained_delaunay gives: a list of rings, the outer one first. Whole "
      "coordinates stay whole.");
}

}  // namespace quadloom::python
