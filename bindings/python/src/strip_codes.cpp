// The last part of include/quadloom/strips.hpp: paths of triangles, strips and their encodings.
#include <nanobind/stl/string.h>

#include <new>

#include "bind.hpp"
#include "choice.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "progress.hpp"
#include "quadloom/strips.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

void bind_words_of_strips(nb::module_& m) {
  bind_words<PathGoal>(
      m, "PathGoal", "What paths are wanted.",
      {{PathGoal::kFewestPaths, "fewest-paths", "for strips whose turns cost nothing"},
       {PathGoal::kFewestIndices, "fewest-indices",
        "three for each path but the first, one for two turns the same way in a row"}});
  bind_words<PathEffort>(
      m, "PathEffort", "How long to look for something better.",
      {{PathEffort::kFast, "fast", "strips that alternate, taken one after the other"},
       {PathEffort::kStandard, "standard",
        "and two rounds of improvement: half a microsecond a triangle"},
       {PathEffort::kThorough, "thorough", "sixteen rounds"}});
  bind_words<StripEncoding>(
      m, "StripEncoding",
      "How triangles become a sequence of vertices: a vertex makes a triangle with the two before "
      "it; the first "
      "triangle of a strip turns as it is sent, every other one the other way around.",
      {{StripEncoding::kSwap, "swap",
        "a bit with each vertex: the two vertices before it change places (and the turn stays); "
        "STRIP_RESTART "
        "begins a new strip"},
       {StripEncoding::kRepeat, "repeat",
        "one strip; vertices sent again make empty triangles (GL_TRIANGLE_STRIP)"},
       {StripEncoding::kRestart, "restart",
        "the same, and STRIP_RESTART begins a new strip (primitive restart)"}});
}

// ---- Paths. ----

void bind_paths(nb::module_& m) {
  Fields<PathPartition> paths(m, "PathPartition", "Paths of triangles, each triangle in one.");
  paths.def(
      "__init__",
      [](PathPartition* self, const NumbersLike& leave, const NumbersLike& begin) {
        new (self) PathPartition{indices_from(leave, "leave"), indices_from(begin, "begin")};
      },
      "leave"_a, "begin"_a, "Paths of your own; see is_path_partition.");
  paths
      .array("leave", &PathPartition::leave,
             "Path p is leave[begin[p] : begin[p + 1]], a halfedge of each of its triangles, the "
             "one by which "
             "the path leaves it for the next. The last triangle of a path has any of its "
             "halfedges but the one "
             "by which the path came in.")
      .array("begin", &PathPartition::begin, "One more than paths.")
      .done();
  paths.def("__len__", [](const PathPartition& self) {
    return self.begin.empty() ? std::size_t{0} : self.count();
  });
  m.def(
      "is_path_partition",
      [](const DualGraph& graph, const PathPartition& partition) {
        return is_path_partition(graph, partition);
      },
      "graph"_a, "partition"_a,
      "Whether each node of the graph is in one path, and paths follow its edges. O(n).");
  m.def(
      "minimum_path_partition",
      [](const DualGraph& forest) {
        return without_gil([&] { return minimum_path_partition(forest); });
      },
      "forest"_a,
      "The fewest paths that part a forest, such as the dual graph of a triangulated simple "
      "polygon (Arkin, Held, "
      "Mitchell and Skiena, lemma 5.1). Raises Error: bad-mesh if the graph has a cycle. O(n).");
  m.def(
      "path_partition",
      [](const DualGraph& graph, const Choice<PathGoal>& goal, const Choice<PathEffort>& effort,
         std::uint64_t seed, const ProgressLike& progress) {
        PathOptions o;
        o.goal = goal.get("goal");
        o.effort = effort.get("effort");
        o.seed = seed;
        return run(progress, o, [&](const auto& with) { return path_partition(graph, with); });
      },
      "graph"_a, nb::kw_only(), "goal"_a = "fewest-paths", "effort"_a = "standard", "seed"_a = 1,
      "progress"_a = nb::none(),
      "Few paths for any graph (fewest is NP-hard); for a forest and fewest-paths the fewest. "
      "Raises Error: "
      "cancelled. O(n) for a given effort.");
}

// ---- Codes. ----

void bind_codes(nb::module_& m) {
  Fields<StripCode> code(m, "StripCode", "Triangles as a sequence of vertices.");
  code.def(
      "__init__",
      [](StripCode* self, const Choice<StripEncoding>& encoding, const NumbersLike& index,
         const NumbersLike& swap) {
        new (self) StripCode{encoding.get("encoding"), indices_from(index, "index"),
                             flags_from(swap, "swap")};
      },
      "encoding"_a, "index"_a, "swap"_a = nb::none(), "A code of your own.");
  code.value("encoding", &StripCode::encoding, "What the sequence means.")
      .array("index", &StripCode::index, "uint32: vertices, and STRIP_RESTART.")
      .array("swap", &StripCode::swap, "swap: per index, not 0 swaps; else empty.")
      .done();
  Fields<StripResult>(m, "StripResult", "A code, and how it was made.")
      .value("code", &StripResult::code, "The code.")
      .value("triangles", &StripResult::triangles, "How many.")
      .value("strips", &StripResult::strips, "Paths of triangles that share edges.")
      .value("swaps", &StripResult::swaps,
             "Two turns the same way in a row: an index more (`swap`: a bit).")
      .value("joined", &StripResult::joined,
             "Strips that begin at a vertex where the strip before ended.")
      .value("restarts", &StripResult::restarts, "STRIP_RESTART in the code.")
      .done();
  m.def(
      "encode_strips",
      [](const MeshLike& mesh, const Choice<StripEncoding>& encoding,
         const Choice<PathEffort>& effort, std::uint64_t seed, const ProgressLike& progress) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        StripOptions o;
        o.encoding = encoding.get("encoding");
        o.effort = effort.get("effort");
        o.seed = seed;
        return run(progress, o, [&](const auto& with) { return encode_strips(triangles, with); });
      },
      "mesh"_a, nb::kw_only(), "encoding"_a = "restart", "effort"_a = "standard", "seed"_a = 1,
      "progress"_a = nb::none(),
      R"(The triangles as strips: decode_strips gives each of them once, the same way around. The paths are
path_partition's: for "swap" the fewest, else those of the fewest indices. Unless effort is "fast", meshes of at most
12 triangles get the shortest code of all, those of up to 200 the best of several ways, that of theorem 5.3 (Arkin,
Held, Mitchell and Skiena) among them. The mesh may be any that triangles_with_twins gives.

Raises Error: bad-mesh (a triangle with a corner twice), cancelled. O(n log n) for a given effort.)");
  m.def(
      "encode_paths",
      [](const MeshLike& mesh, const PathPartition& paths, const Choice<StripEncoding>& encoding) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        const StripEncoding kind = encoding.get("encoding");
        return without_gil([&] { return encode_paths(triangles, paths, kind); });
      },
      "mesh"_a, "paths"_a, "encoding"_a,
      "The code of given paths. Raises Error: bad-option if they are not a partition of the mesh.");
  m.def(
      "decode_strips", [](const StripCode& given) { return own<3>(decode_strips(given)); },
      "code"_a,
      "The triangles that a code draws, uint32 (t, 3), in its order. Any sequence is a code. "
      "Raises Error: "
      "bad-option if `swap` has not the size it should have. O(n).");
  m.def(
      "same_triangles",
      [](const NumbersLike& a, const NumbersLike& b) {
        const auto triangles = [](const NumbersLike& given) {
          std::vector<VertexId> corners = indices_from(given, "triangles");
          if (corners.size() % 3 == 0) return corners;
          throw Error(ErrorCode::kBadMesh, "triangles must be of shape (t, 3)");
        };
        return same_triangles(triangles(a), triangles(b));
      },
      "a"_a, "b"_a,
      "Whether two lists of triangles (t, 3) are the same but for their order and where each "
      "begins; each counts as "
      "often as it is there. O(n log n).");
  m.def(
      "triangles_with_twins",
      [](const PointsLike& points, const NumbersLike& triangles) {
        const Points given(points);
        check_finite(given.xy());
        auto* const out = made(triangles_with_twins({given.xy().begin(), given.xy().end()},
                                                    indices_from(triangles, "triangles")));
        out->heights = given.z();
        return out;
      },
      "points"_a, "triangles"_a,
      R"(Triangles (t, 3) as they are, of any kind (surfaces, clockwise ones, edges with many triangles): twins are two
triangles that have an edge in opposite directions, if no third one has it in either.

Raises Error: bad-mesh (a triangle with a corner twice), index-out-of-range (culprits: triangle, index), not-finite,
too-many-points. O(n).)");
}

}  // namespace

void bind_strip_codes(nb::module_& m) {
  m.attr("STRIP_RESTART") = kStripRestart;
  bind_words_of_strips(m);
  bind_paths(m);
  bind_codes(m);
}

}  // namespace quadloom::python
