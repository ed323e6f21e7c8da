// A short walk through all triangles of a small mesh.
//
// Arkin, Held, Mitchell and Skiena, Hamiltonian Triangulations for Fast Rendering, theorem 5.3: the
// heuristic of Christofides for the travelling salesman among the triangles, whose distance is that
// in the dual graph, is at most 3/2 times as long as the shortest walk, and with empty triangles for
// turns (lemma 5.2) a code at most 9/4 times as long as the shortest.
//
// Steps: without_ears (triangles with one neighbour are put back where that neighbour is visited, at the
// cost that they have in any code), spanning_tree (depth first, all edges are alike), minimum_join
// (of its nodes of odd degree), tour (Euler's, from tree and join), first_visits.
//
// What differs from the paper: the cheapest perfect matching of the odd nodes under distances in a graph
// is a minimum T-join of the graph, and that is a perfect matching of a graph of at most three edges
// a node again (below), for which there is dual/maximum_weight.cpp; no distances are computed. Where
// the walk comes to a triangle again the code does not draw it once more but jumps over it, since it
// shall decode to each triangle once; encode_order.cpp finds the shortest code of the order. Triangles
// keep their orientation, which the paper does not ask for. Cost: that of the matching.
#include "strips/encode_walk.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "dual/rooted_forest.hpp"

namespace quadloom::strips {
namespace {

//   A node t with edges e0, e1, e2 becomes three ports, one for each edge, that are matched over
//   their edges or among each other:
//
//       three edges       two edges, odd      two edges, even     one edge
//         o---o             o   o               o---o               o
//          \ /               \ /
//           o                 x
//
//   so that as many ports are matched over edges as the parity asks for. At odd nodes a port matched
//   over its edge says that the edge is in the join, at even ones that it is not; between an odd and an
//   even node stands one more node, which is matched to one of them.
class JoinGadget {
 public:
  JoinGadget(const DualGraph& graph, const std::vector<std::uint8_t>& odd)
      : graph_(graph), odd_(odd), port_edge_(graph.twin.size(), kNone) {}

  std::vector<std::uint8_t> solve() {
    for (TriangleId t = 0; t < graph_.node_count(); ++t) add_ports(t);
    for (HalfedgeId h = 0; h < graph_.twin.size(); ++h) add_edge(h);
    const DualMatching matching =
        maximum_weight_matching(gadget_, weight_, MatchingGoal::kSizeThenWeight).matching;
    std::vector<std::uint8_t> join(graph_.twin.size());
    for (HalfedgeId h = 0; h < join.size(); ++h) {
      if (port_edge_[h] == kNone) continue;
      const bool matched = matching.mate[triangle_of(port_edge_[h])] == port_edge_[h];
      join[h] = matched == (odd_[triangle_of(h)] != 0);
    }
    return join;
  }

 private:
  // Slot 0 and 1 of a port are inside the gadget, slot 2 is its edge.
  TriangleId port(HalfedgeId h) const { return first_port_[triangle_of(h)] + rank(h); }
  TriangleId rank(HalfedgeId h) const {
    TriangleId r = 0;
    for (HalfedgeId g = 3 * triangle_of(h); g < h; ++g) r += graph_.twin[g] != kNone;
    return r;
  }

  TriangleId add_node() {
    gadget_.twin.resize(gadget_.twin.size() + 3, kNone);
    weight_.resize(gadget_.twin.size(), 0);
    return static_cast<TriangleId>(gadget_.node_count() - 1);
  }

  void link(HalfedgeId a, HalfedgeId b, std::int32_t weight) {
    gadget_.twin[a] = b;
    gadget_.twin[b] = a;
    weight_[a] = weight_[b] = weight;
  }

  void add_ports(TriangleId t) {
    const int edges = dual::degree(graph_, t);
    first_port_.push_back(static_cast<TriangleId>(gadget_.node_count()));
    for (int i = 0; i < edges; ++i) add_node();
    const HalfedgeId first = 3 * first_port_[t];
    if (edges == 3) {
      link(first, first + 3, 0);
      link(first + 4, first + 6, 0);
      link(first + 7, first + 1, 0);
    } else if (edges == 2 && odd_[t] == 0) {
      link(first, first + 3, 0);
    } else if (edges == 2) {
      const HalfedgeId x = 3 * add_node();
      link(first, x, 0);
      link(first + 3, x + 1, 0);
    }
  }

  void add_edge(HalfedgeId h) {
    const HalfedgeId twin = graph_.twin[h];
    if (twin == kNone || twin < h) return;
    const HalfedgeId a = 3 * port(h) + 2, b = 3 * port(twin) + 2;
    const bool odd_a = odd_[triangle_of(h)] != 0, odd_b = odd_[triangle_of(twin)] != 0;
    port_edge_[h] = a;
    port_edge_[twin] = b;
    if (odd_a == odd_b) {
      link(a, b, odd_a ? -1 : 1);
      return;
    }
    const HalfedgeId between = 3 * add_node();
    link(a, between, odd_a ? -1 : 0);
    link(b, between + 1, odd_b ? -1 : 0);
  }

  const DualGraph& graph_;
  const std::vector<std::uint8_t>& odd_;
  DualGraph gadget_;
  std::vector<std::int32_t> weight_;
  std::vector<TriangleId> first_port_;
  std::vector<HalfedgeId> port_edge_;
};

/// The graph without the nodes of one edge; `ear` has, for each, its halfedge.
DualGraph without_ears(const DualGraph& graph, std::vector<HalfedgeId>& ears) {
  DualGraph rest = graph;
  for (TriangleId t = 0; t < graph.node_count(); ++t) {
    if (dual::degree(graph, t) != 1) continue;
    HalfedgeId h = 3 * t;
    while (graph.twin[h] == kNone) ++h;
    // Of two triangles beside each other alone, the first stays.
    if (dual::degree(graph, graph.across(h)) == 1 && t < graph.across(h)) continue;
    ears.push_back(h);
    rest.twin[h] = rest.twin[graph.twin[h]] = kNone;
  }
  return rest;
}

/// How often the walk takes each edge, by halfedge: depth first.
std::vector<std::uint8_t> spanning_tree(const DualGraph& graph) {
  std::vector<std::uint8_t> tree(graph.twin.size()), seen(graph.node_count());
  std::vector<HalfedgeId> path;  // by which nodes are entered
  for (TriangleId root = 0; root < graph.node_count(); ++root) {
    if (seen[root] != 0) continue;
    seen[root] = 1;
    TriangleId t = root;
    for (;;) {
      HalfedgeId h = 3 * t;
      while (h < 3 * t + 3 && (graph.twin[h] == kNone || seen[graph.across(h)] != 0)) ++h;
      if (h < 3 * t + 3) {
        tree[h] = tree[graph.twin[h]] = 1;
        path.push_back(graph.twin[h]);
        t = graph.across(h);
        seen[t] = 1;
      } else if (path.empty()) {
        break;
      } else {
        t = graph.across(path.back());
        path.pop_back();
      }
    }
  }
  return tree;
}

/// Nodes in the order of Euler's tour of the component; uses up the edges.
void tour(const DualGraph& graph, TriangleId root, std::vector<std::uint8_t>& times,
          std::vector<TriangleId>& out) {
  std::vector<TriangleId> open = {root};
  while (!open.empty()) {
    const TriangleId t = open.back();
    HalfedgeId h = 3 * t;
    while (h < 3 * t + 3 && times[h] == 0) ++h;
    if (h == 3 * t + 3) {
      out.push_back(t);
      open.pop_back();
    } else {
      --times[h];
      --times[graph.twin[h]];
      open.push_back(graph.across(h));
    }
  }
}

}  // namespace

std::vector<std::uint8_t> minimum_join(const DualGraph& graph,
                                       const std::vector<std::uint8_t>& odd) {
  return JoinGadget(graph, odd).solve();
}

std::vector<TriangleId> christofides_order(const DualGraph& graph) {
  std::vector<HalfedgeId> ears;
  const DualGraph rest = without_ears(graph, ears);
  std::vector<std::uint8_t> times = spanning_tree(rest);
  std::vector<std::uint8_t> odd(rest.node_count());
  for (HalfedgeId h = 0; h < times.size(); ++h) odd[triangle_of(h)] ^= times[h];
  const std::vector<std::uint8_t> join = minimum_join(rest, odd);
  for (HalfedgeId h = 0; h < times.size(); ++h) times[h] += join[h];

  std::vector<std::uint8_t> seen(graph.node_count());
  for (const HalfedgeId ear : ears) seen[triangle_of(ear)] = 1;
  std::vector<TriangleId> order, walk;
  for (TriangleId root = 0; root < graph.node_count(); ++root) {
    if (seen[root] != 0) continue;
    walk.clear();
    tour(rest, root, times, walk);
    for (const TriangleId t : walk) {
      if (seen[t] != 0) continue;
      seen[t] = 1;
      order.push_back(t);
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {  // its ears
        if (graph.twin[h] != rest.twin[h]) order.push_back(graph.across(h));
      }
    }
  }
  return order;
}

}  // namespace quadloom::strips
