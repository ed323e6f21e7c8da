// The predicates of include/quadloom/kernel.hpp, for one evaluation or many.
#include <nanobind/stl/string.h>

#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bind.hpp"
#include "inputs.hpp"
#include "progress.hpp"
#include "quadloom/kernel.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

// One point, or one for each of many evaluations.
class Operand {
 public:
  explicit Operand(const PointsLike& given)
      : points_(nb::borrow<PointsLike>(
            nb::module_::import_("quadloom._inputs").attr("operand")(given))),
        single_(nb::cast<int>(nb::module_::import_("numpy").attr("ndim")(given)) == 1) {
    check_finite(points_.xy());
  }
  bool single() const { return single_; }
  std::size_t size() const { return points_.xy().size(); }
  Point at(std::size_t i) const { return points_.xy()[single_ ? 0 : i]; }

 private:
  Points points_;
  bool single_;
};

// f of single points is a number; of several points an array, single ones taken for each.
template <typename Out, typename... Operands>
nb::object evaluate(Out (*f)(Operands...), const std::vector<Operand>& operands) {
  using Kept = std::conditional_t<std::is_same_v<Out, int>, std::int8_t, Out>;
  bool single = true;
  std::size_t count = 1;
  for (const Operand& o : operands) {
    if (o.single()) continue;
    if (!single && o.size() != count) {
      throw Error(ErrorCode::kBadOption, "points of " + std::to_string(count) + " and " +
                                             std::to_string(o.size()) + " rows do not go together");
    }
    single = false;
    count = o.size();
  }
  std::vector<Kept> out(count);
  without_gil([&] {
    for (std::size_t i = 0; i < count; ++i) {
      out[i] = static_cast<Kept>([&]<std::size_t... I>(std::index_sequence<I...>) {
        return f(operands[I].at(i)...);
      }(std::index_sequence_for<Operands...>()));
    }
  });
  return single ? nb::cast(out[0]) : nb::cast(own(std::move(out)));
}

std::string signature(const char* name, const char* points, const char* scalar, const char* dtype) {
  std::string out = std::string("def ") + name + "(";
  for (const char* p = points; *p != 0; ++p) {
    out += std::string(p == points ? "" : ", ") + *p + ": numpy.typing.ArrayLike";
  }
  return out + ") -> " + scalar + " | numpy.typing.NDArray[" + dtype + "]";
}

template <typename Out>
void def_predicate(nb::module_& m, const char* name, Out (*f)(Point, Point, Point),
                   const char* doc) {
  using P = const PointsLike&;
  const bool sign = std::is_same_v<Out, int>;
  m.def(
      name,
      [f](P a, P b, P c) {
        return evaluate(f, {Operand(a), Operand(b), Operand(c)});
      },
      "a"_a, "b"_a, "c"_a,
      nb::sig(signature(name, "abc", sign ? "int" : "float", sign ? "numpy.int8" : "numpy.float64")
                  .c_str()),
      doc);
}

template <typename Out>
void def_predicate(nb::module_& m, const char* name, Out (*f)(Point, Point, Point, Point),
                   const char* doc) {
  using P = const PointsLike&;
  const bool sign = std::is_same_v<Out, int>;
  m.def(
      name,
      [f](P a, P b, P c, P d) {
        return evaluate(f, {Operand(a), Operand(b), Operand(c), Operand(d)});
      },
      "a"_a, "b"_a, "c"_a, "d"_a,
      nb::sig(signature(name, "abcd", sign ? "int" : "float", sign ? "numpy.int8" : "numpy.float64")
                  .c_str()),
      doc);
}

}  // namespace

void bind_predicates(nb::module_& m) {
  def_predicate(
      m, "orient2d", orient2d,
      R"(+1 if a, b, c turn left (counter-clockwise), -1 if right, 0 if they are collinear; exact.

Points are (2,), or (n, 2) for n evaluations at once, the result then int8 (n,).)");
  def_predicate(
      m, "incircle", incircle,
      R"(For a, b, c counter-clockwise: +1 if d is inside their circle, -1 if outside, 0 if on it; exact. For a, b, c
clockwise the sign is the opposite.

Points are (2,), or (n, 2) for n evaluations at once, the result then int8 (n,).)");
  def_predicate(
      m, "cross_sign", cross_sign,
      R"(The sign of (b - a) x (d - c), exact: +1 if the direction c->d is counter-clockwise of a->b (by less than half a
turn), 0 if they are parallel, equal or opposite.

Points are (2,), or (n, 2) for n evaluations at once, the result then int8 (n,).)");
  def_predicate(
      m, "dot_sign", dot_sign,
      R"(The sign of (b - a) . (d - c), exact: +1 if the directions make an acute angle, 0 a right one, -1 obtuse.

Points are (2,), or (n, 2) for n evaluations at once, the result then int8 (n,).)");
  def_predicate(
      m, "quad_shape", quad_shape,
      R"(The shape of a counter-clockwise quad: 1 - (2/pi) max |pi/2 - angle| over its corners, 1 for a rectangle, 0 for
one that is not strictly convex (Remacle et al., Blossom-Quad). In floating point, for ranking.

Corners are (2,), or (n, 2) for n quads at once, the result then float64 (n,).)");
}

}  // namespace quadloom::python
