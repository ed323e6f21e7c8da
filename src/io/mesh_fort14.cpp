// ADCIRC's grid, fort.14 (and SCHISM's .gr3), whose third coordinate is a depth:
//
//    a title                           any text
//    2 4                               elements, nodes
//    1  -72.5 40.9  3.25               a node a line: number, x, y, depth
//    1  3  1 2 3                       an element a line: number, 3 or 4, corners
//    1                                 open boundaries
//    2                                 their nodes in all
//    2                                 nodes of this one
//    1                                 a node a line
//    ...                               land boundaries likewise, each with its type: "285 20"
//
// The numbers of nodes are any whole numbers. Whatever follows on a line is a comment, and what
// follows the boundaries is skipped. Both lists of boundaries may be left out.

#include <fmt/format.h>

#include <algorithm>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/numbers.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

class Fort14Reader {
 public:
  explicit Fort14Reader(const Source& source) : source_(source), lines_(source), mesh_(source, 1) {}

  MeshFile read() {
    read_counts();
    for (std::uint64_t i = 0; i < nodes_; ++i) read_node(i);
    if (const auto twice = numbers_.sort()) {
      fail(fmt::format("node {} is there twice", static_cast<std::int64_t>(*twice)));
    }
    for (std::uint64_t i = 0; i < elements_; ++i) read_element(i);
    read_boundaries();
    MeshFile out = mesh_.finish();
    out.z_is_data = true;
    if (!boundary_.empty()) out.vertex_data.push_back({"boundary", std::move(boundary_)});
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

  void next_line(const std::string& what) {
    lines_.require(what);
    rest_ = lines_.line();
  }

  std::uint64_t take_count(std::string_view what) {
    const auto word = take_word(rest_);
    const auto value = to_integer<std::uint64_t>(word);
    if (!value) fail(fmt::format("{} is not a count, expected {}", in_quotes(word), what));
    return *value;
  }

  std::int64_t take_integer(std::string_view what) {
    const auto word = take_word(rest_);
    const auto value = to_integer<std::int64_t>(word);
    if (!value) fail(fmt::format("{} is not a whole number, expected {}", in_quotes(word), what));
    return *value;
  }

  /// Fortran may write 1.5D+02.
  double take_number(std::string_view what) {
    const auto word = take_word(rest_);
    if (word.find_first_of("dD") == std::string_view::npos) {
      return finite_number(source_, lines_.number(), word, what);
    }
    std::string with_e(word);
    std::ranges::replace_if(
        with_e, [](char c) { return c == 'd' || c == 'D'; }, 'e');
    return finite_number(source_, lines_.number(), with_e, what);
  }

  VertexId take_node() {
    const auto number = take_integer("a node's number");
    const auto at = numbers_.find(static_cast<std::uint64_t>(number));
    if (at) return *at;
    throw Error(
        ErrorCode::kIndexOutOfRange,
        fmt::format("{}, line {}: there is no node {}", source_.name, lines_.number(), number),
        {lines_.number()});
  }

  void read_counts() {
    if (!lines_.next()) fail("the file ends here, expected the title");
    next_line("the counts of elements and nodes");
    elements_ = take_count("the count of elements");
    nodes_ = take_count("the count of nodes");
    mesh_.reserve(nodes_, elements_);
  }

  void read_node(std::uint64_t i) {
    next_line(fmt::format("node {} of {}", i + 1, nodes_));
    numbers_.add(static_cast<std::uint64_t>(take_integer("a node's number")));
    const double x = take_number("x"), y = take_number("y"), depth = take_number("the depth");
    mesh_.add_vertex(x, y, depth);
  }

  void read_element(std::uint64_t i) {
    next_line(fmt::format("element {} of {}", i + 1, elements_));
    take_integer("an element's number");
    const auto corners = take_count("the count of corners");
    if (corners != 3 && corners != 4) {
      fail(fmt::format("an element of {} corners, there are 3 or 4", corners));
    }
    corners_.clear();
    for (std::uint64_t k = 0; k < corners; ++k) corners_.push_back(take_node());
    mesh_.add_face(corners_, lines_.number());
  }

  void read_boundaries() {
    if (!lines_.next_filled()) return;
    boundary_.assign(mesh_.vertex_count(), 0);
    read_boundary_list(false);
    if (lines_.next_filled()) read_boundary_list(true);
  }

  /// The line with the count of boundaries is the current one. Weirs have a second node on the
  /// line, on their other side.
  void read_boundary_list(bool land) {
    rest_ = lines_.line();
    const auto boundaries = take_count("the count of boundaries");
    next_line("the count of boundary nodes");
    take_count("the count of boundary nodes");
    for (std::uint64_t b = 0; b < boundaries; ++b) {
      next_line(fmt::format("boundary {} of {}", b + 1, boundaries));
      const auto nodes = take_count("the count of nodes");
      const auto type = land ? to_integer<std::uint32_t>(take_word(rest_)).value_or(0) : 0;
      const bool two_sides = type % 10 == 4 || type % 10 == 5;
      for (std::uint64_t i = 0; i < nodes; ++i) {
        next_line(fmt::format("node {} of {} of a boundary", i + 1, nodes));
        const double mark = land ? 2.0 + type : 1.0;
        set_boundary(take_node(), mark);
        if (two_sides) set_boundary(take_node(), mark);
      }
    }
  }

  /// The first boundary counts; open ones come first.
  void set_boundary(VertexId v, double mark) {
    if (boundary_[v] == 0) boundary_[v] = mark;
  }

  const Source& source_;
  Lines lines_;
  MeshBuilder mesh_;
  std::string_view rest_;
  std::uint64_t elements_ = 0;
  std::uint64_t nodes_ = 0;
  NumberMap numbers_;
  std::vector<std::uint64_t> corners_;
  std::vector<double> boundary_;  // per node, see docs/formats.md
};

}  // namespace

MeshFile read_fort14(const Source& source) { return Fort14Reader(source).read(); }

}  // namespace quadloom::io
