// include/quadloom/dual.hpp: the dual graph of a triangulation and its matchings.
#include "quadloom/dual.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <new>
#include <string>

#include "bind.hpp"
#include "choice.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "parts.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

// ---- The graph. ----

// What dual_graph gives by itself: twins are mutual, and no edge is a loop.
DualGraph graph_of(std::vector<HalfedgeId> twin) {
  if (twin.size() % 3 != 0) {
    throw Error(ErrorCode::kBadMesh,
                "a graph has three slots a node, not " + counted(twin.size(), "slot"));
  }
  for (HalfedgeId h = 0; h < twin.size(); ++h) {
    const HalfedgeId t = twin[h];
    if (t == kNone) continue;
    if (t >= twin.size() || twin[t] != h || triangle_of(t) == triangle_of(h)) {
      throw Error(ErrorCode::kBadMesh,
                  "slot " + std::to_string(h) + " has the other end " + std::to_string(t) +
                      ", which does not lead back from another node",
                  {h, t});
    }
  }
  return {std::move(twin)};
}

void bind_graph(nb::module_& m) {
  Fields<DualGraph> fields(
      m, "DualGraph",
      "A graph without loops whose nodes have at most three edges: in the dual graph of a "
      "triangulation the "
      "nodes are the triangles. Two nodes may share more than one edge (closed surfaces).");
  fields.def(
      "__init__",
      [](DualGraph* self, const NumbersLike& twin) {
        new (self) DualGraph(graph_of(indices_from(twin, "twin")));
      },
      "twin"_a,
      "Of twin (n, 3): the other end of the edge at each slot, as 3 node + slot; NONE for no "
      "edge.");
  fields.array<3>(
      "twin", &DualGraph::twin,
      "uint32 (n, 3): the other end of the edge at each slot; NONE where there is none.");
  fields.get("node_count", &DualGraph::node_count, "How many nodes.").done();
  m.def(
      "dual_graph",
      [](const MeshLike& mesh, const NumbersLike& forbidden) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        const std::vector<std::uint8_t> flags = flags_from(forbidden, "forbidden");
        return without_gil([&] {
          return forbidden.is_none() ? dual_graph(triangles) : dual_graph(triangles, flags);
        });
      },
      "mesh"_a, "forbidden"_a = nb::none(),
      R"(All inner edges of the triangulation, but those that must stay: `forbidden` (t, 3), true on either side.

Raises Error: bad-mesh if its twins do not agree, bad-option if the size is wrong.)");
  m.def(
      "spanning_forest",
      [](const DualGraph& graph) { return without_gil([&] { return spanning_forest(graph); }); },
      "graph"_a,
      "A spanning tree of each component: the edges by which a breadth-first search from the "
      "smallest node found "
      "the others. O(n).");
}

// ---- Matchings. ----

void bind_matchings(nb::module_& m) {
  Fields<DualMatching> fields(m, "DualMatching", "A matching of the dual graph.");
  fields.def(
      "__init__",
      [](DualMatching* self, const NumbersLike& mate) {
        DualMatching made{indices_from(mate, "mate"), 0};
        made.unmatched =
            static_cast<std::size_t>(std::count(made.mate.begin(), made.mate.end(), kNone));
        new (self) DualMatching(std::move(made));
      },
      "mate"_a, "Of mate (t,).");
  fields
      .array("mate", &DualMatching::mate,
             "uint32 (t,): the halfedge of each triangle that it shares with its partner, NONE if "
             "it is "
             "unmatched. The partner's halfedge is its twin.")
      .value("unmatched", &DualMatching::unmatched, "How many triangles have no partner.")
      .done();
  m.def(
      "is_matching",
      [](const DualGraph& graph, const DualMatching& matching) {
        return is_matching(graph, matching);
      },
      "graph"_a, "matching"_a,
      "Whether it is one: mates are edges of the graph, mutual, and the count is right. O(n).");
  m.def(
      "greedy_shape_matching",
      [](const MeshLike& mesh) {
        const MeshArgument given(mesh);
        const Triangulation& triangles = given.triangulation();
        return without_gil([&] { return greedy_shape_matching(triangles); });
      },
      "mesh"_a,
      "Pairs of triangles in order of shape, the best first (see quad_shape); pairs whose quad is "
      "not strictly "
      "convex stay unmatched. At least half of the maximum weight. Ties go to the smaller "
      "halfedge.");
  Fields<MaximumMatching> maximum(m, "MaximumMatching",
                                  "A matching of the greatest size, and why there is none greater: "
                                  "without the nodes of the barrier the graph "
                                  "has unmatched + len(barrier) odd components, and each barrier "
                                  "node can serve only one of them (Tutte and "
                                  "Berge).");
  maximum.def(
      "__init__",
      [](MaximumMatching* self, const DualMatching& given, const NumbersLike& barrier) {
        new (self) MaximumMatching{given, indices_from(barrier, "barrier")};
      },
      "matching"_a, "barrier"_a, "A claim, for verify_tutte_berge.");
  maximum.value("matching", &MaximumMatching::matching, "The matching.")
      .array("barrier", &MaximumMatching::barrier,
             "uint32 (b,), ascending; empty if the matching is perfect.")
      .done();
  m.def(
      "maximum_matching",
      [](const DualGraph& graph, const DualMatching* start) {
        return without_gil([&] {
          return start == nullptr ? maximum_matching(graph) : maximum_matching(graph, *start);
        });
      },
      "graph"_a, "start"_a.none() = nb::none(),
      R"(A maximum matching by Edmonds' algorithm; `start` (a matching of the graph) is augmented, what it matches stays
matched. Near-linear in practice. Raises Error: bad-option for a start that is no matching.)");
  m.def(
      "verify_tutte_berge",
      [](const DualGraph& graph, const MaximumMatching& result) {
        return without_gil([&] { return verify_tutte_berge(graph, result); });
      },
      "graph"_a, "result"_a,
      "Whether the matching is one and the barrier proves that it is maximum; counts the odd "
      "components from the "
      "graph alone. O(n).");
  m.def(
      "percolate_up",
      [](const DualGraph& forest) { return without_gil([&] { return percolate_up(forest); }); },
      "forest"_a,
      "A maximum matching of a forest (Ramaswami, Ramos and Toussaint, theorem 3.1). Raises Error: "
      "bad-mesh if the "
      "graph has a cycle. O(n).");
  m.def(
      "percolate_up_and_down",
      [](const DualGraph& forest) {
        return without_gil([&] { return percolate_up_and_down(forest); });
      },
      "forest"_a,
      "A maximum matching of a forest in which every unmatched node is a leaf (has at most one "
      "edge; theorem 3.2). "
      "Raises Error: bad-mesh if the graph has a cycle. O(n).");
}

// ---- Weights. ----

std::vector<std::int32_t> weights_of(const MeshArgument& given) {
  const Parts parts = given.mesh().parts();
  if (parts.triangle_mesh != nullptr) {
    return without_gil([&] { return shape_weights(*parts.triangle_mesh); });
  }
  const Triangulation& triangles = given.triangulation();
  return without_gil([&] { return shape_weights(triangles, parts.z); });
}

void bind_certificate(nb::module_& m) {
  using W = WeightCertificate;
  Fields<W>(m, "WeightCertificate",
            "Why no matching is better (Edmonds' linear program): the duals of the nodes of an "
            "edge and of the "
            "sets that hold both of them sum up to at least twice its weight plus bonus; over all "
            "nodes, and sets "
            "times half their size rounded down, the duals sum up to that of the matching. No dual "
            "is negative.")
      .value("bonus", &W::bonus, "0, or for size-then-weight so large that size counts first.")
      .array("node_dual", &W::node_dual, "int64, one a node.")
      .array("set_of_node", &W::set_of_node, "The smallest set that holds the node, NONE if none.")
      .array("parent_of_set", &W::parent_of_set, "The next larger set, NONE if none.")
      .array("set_dual", &W::set_dual, "int64, one a set.")
      .done();
  Fields<MaximumWeightMatching>(m, "MaximumWeightMatching", "The best matching, proven.")
      .value("matching", &MaximumWeightMatching::matching, "The matching.")
      .value("weight", &MaximumWeightMatching::weight, "Its weight.")
      .value("certificate", &MaximumWeightMatching::certificate, "The proof, for verify_weight.")
      .done();
  Fields<NearMaximumMatching>(m, "NearMaximumMatching",
                              "A good matching, and how good it is at least.")
      .value("matching", &NearMaximumMatching::matching, "The matching.")
      .value("weight", &NearMaximumMatching::weight, "Its weight.")
      .value("upper_bound", &NearMaximumMatching::upper_bound,
             "No matching of the goal weighs more.")
      .done();
}

void bind_weights(nb::module_& m) {
  bind_words<MatchingGoal>(m, "MatchingGoal", "What the best matching is.",
                           {{MatchingGoal::kWeight, "weight",
                             "the greatest weight; edges of weight 0 or less need not be used"},
                            {MatchingGoal::kSizeThenWeight, "size-then-weight",
                             "the greatest weight among the matchings of the greatest size"}});
  bind_certificate(m);
  m.def(
      "shape_weights", [](const MeshLike& mesh) { return own(weights_of(MeshArgument(mesh))); },
      "mesh"_a,
      R"(The weight of each pair of triangles by shape, int32 (3 t,), one a halfedge: 1 + 65,535 x quad_shape of their quad,
rounded down, if it is strictly convex (exactly), else 0. On a surface in space the shape is that of the angles in
space, and a pair weighs 0 if it is not strictly convex in the coordinate plane that it is nearest to, or folded by
more than 90 degrees. The same integers on every platform.)");
  m.def(
      "heavy_edges",
      [](const DualGraph& graph, const NumbersLike& weight, std::int32_t least) {
        return heavy_edges(graph, weights_from(weight), least);
      },
      "graph"_a, "weight"_a, "least"_a,
      "The graph without the edges that weigh less than `least`: with shape weights and 1, the "
      "pairs that are "
      "strictly convex. Raises Error: bad-option.");
  m.def(
      "maximum_weight_matching",
      [](const DualGraph& graph, const NumbersLike& weight, const Choice<MatchingGoal>& goal,
         const ProgressLike& progress) {
        const std::vector<std::int32_t> w = weights_from(weight);
        const MatchingGoal g = goal.get("goal");
        return run(progress,
                   [&](const Progress& p) { return maximum_weight_matching(graph, w, g, p); });
      },
      "graph"_a, "weight"_a, "goal"_a, nb::kw_only(), "progress"_a = nb::none(),
      R"(The best matching, proven. Weights are integers by halfedge, the same on both sides.

Raises Error: bad-option if the weights are not one a halfedge and the same on both sides, or so large that sums do not
fit 62 bits. Seconds for a million nodes.)");
  m.def(
      "near_maximum_weight_matching",
      [](const DualGraph& graph, const NumbersLike& weight, const Choice<MatchingGoal>& goal,
         const ProgressLike& progress) {
        const std::vector<std::int32_t> w = weights_from(weight);
        const MatchingGoal g = goal.get("goal");
        return run(progress,
                   [&](const Progress& p) { return near_maximum_weight_matching(graph, w, g, p); });
      },
      "graph"_a, "weight"_a, "goal"_a, nb::kw_only(), "progress"_a = nb::none(),
      R"(A good matching in about half of the time: the first rounds of the exact algorithm, then, for size-then-weight, the
missing pairs by maximum_matching. The size is exact, the weight is within upper_bound - weight of the best one.

Raises Error as maximum_weight_matching.)");
  m.def(
      "verify_weight",
      [](const DualGraph& graph, const NumbersLike& weight, const Choice<MatchingGoal>& goal,
         const MaximumWeightMatching& result) {
        const std::vector<std::int32_t> w = weights_from(weight);
        const MatchingGoal g = goal.get("goal");
        return without_gil([&] { return verify_weight(graph, w, g, result); });
      },
      "graph"_a, "weight"_a, "goal"_a, "result"_a,
      "Whether the matching is one, has the weight that it says, and the certificate proves that "
      "none is better; "
      "from the graph and the weights alone.");
  m.def(
      "weight_of",
      [](const DualMatching& matching, const NumbersLike& weight) {
        const std::vector<std::int32_t> w = weights_from(weight);
        for (const HalfedgeId h : matching.mate) {
          if (h == kNone || h < w.size()) continue;
          throw Error(ErrorCode::kBadOption, "weights need one entry a halfedge", {h});
        }
        return weight_of(matching, w);
      },
      "matching"_a, "weight"_a, "The weight of a matching.");
}

}  // namespace

void bind_dual(nb::module_& m) {
  bind_graph(m);
  bind_matchings(m);
  bind_weights(m);
}

}  // namespace quadloom::python
