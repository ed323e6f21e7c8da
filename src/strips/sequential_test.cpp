// Is a given triangulation sequential?
//
// Arkin, Held, Mitchell, Skiena, "Hamiltonian triangulations for fast rendering", theorem 4.3: can its
// triangles be put in an order such that each is beside the one before and left and right turns
// alternate? O(n).
//
//   1. chain_through   a triangle whose corners are taken in some order s0 s1 s2 has one successor: the
//                      triangle across s1 s2, taken in the order s1 s2 s3. Its predecessor is the
//                      successor of s2 s1 s0. So triangle 0 is in six chains, which are three and
//                      their reversals. Each is followed both ways, until the boundary or until a
//                      triangle repeats among the successors, or among the predecessors
//   2. best_window     every sequential order has triangle 0 in it, so it is a piece of one of the
//                      chains: t neighbours without a repetition. They are counted as a window of t
//                      triangles slides over the chain
//
//            s0 ---- s2 ---- s4         the chain  s0 s1 s2, s1 s2 s3, s2 s3 s4, ...
//             \     /  \    /           Three corners in counter-clockwise order, the next three
//              \   /    \  /            clockwise, and so on.
//               s1 ---- s3
//
// What differs from the paper: all windows are looked at, to find one that closes. Of a sequential cycle
// the chain comes back to its start, with each triangle once: any window of it will do.
//
// Degenerate input: any manifold connectivity, boundaries and closed surfaces; a mesh of several
// components has no order. One triangle is sequential, and so are two neighbours.
#include <algorithm>

#include "quadloom/dual.hpp"
#include "quadloom/strips.hpp"

namespace quadloom {
namespace {

/// A triangle with its corners in an order: the first is the origin of this halfedge, the others follow
/// counter-clockwise or clockwise.
struct Taken {
  HalfedgeId first = kNone;
  bool counter_clockwise = true;
  friend bool operator==(const Taken&, const Taken&) = default;
};

Taken reversed(Taken t) {
  return {t.counter_clockwise ? previous_halfedge(t.first) : next_halfedge(t.first),
          !t.counter_clockwise};
}

class Chains {
 public:
  explicit Chains(const Triangulation& mesh)
      : mesh_(mesh), graph_(dual_graph(mesh)), seen_(mesh.triangle_count(), 0) {}

  /// first = kNone if there is none. Either way around, the second and third corner are the ends of the
  /// halfedge after the first corner's.
  Taken successor(Taken t) const {
    const HalfedgeId across = graph_.twin[next_halfedge(t.first)];
    if (across == kNone) return {};
    return {t.counter_clockwise ? next_halfedge(across) : across, !t.counter_clockwise};
  }

  std::vector<Taken> chain_through(Taken start) {
    std::vector<Taken> chain = follow(reversed(start));
    std::reverse(chain.begin(), chain.end());
    for (Taken& t : chain) t = reversed(t);
    chain.pop_back();
    const std::vector<Taken> onwards = follow(start);
    chain.insert(chain.end(), onwards.begin(), onwards.end());
    return chain;
  }

  Closure closure(Taken first, Taken last) const {
    if (mesh_.triangle_count() < 3) return Closure::kOpen;
    if (successor(last) == first) return Closure::kSequentialCycle;
    const TriangleId t = triangle_of(first.first);
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfedgeId twin = graph_.twin[h];
      if (twin != kNone && triangle_of(twin) == triangle_of(last.first)) return Closure::kCycle;
    }
    return Closure::kOpen;
  }

 private:
  std::vector<Taken> follow(Taken start) {
    ++round_;
    std::vector<Taken> way;
    for (Taken t = start; t.first != kNone && seen_[triangle_of(t.first)] != round_;
         t = successor(t)) {
      seen_[triangle_of(t.first)] = round_;
      way.push_back(t);
    }
    return way;
  }

  const Triangulation& mesh_;
  DualGraph graph_;
  std::vector<std::uint32_t> seen_;  // by triangle: the last round that met it
  std::uint32_t round_ = 0;
};

struct Window {
  std::span<const Taken> taken;  // empty: there is none
  Closure closure = Closure::kOpen;
};

Window best_window(const Chains& chains, std::span<const Taken> chain, std::size_t triangles) {
  Window best;
  std::vector<std::uint32_t> times(triangles, 0);  // in the window
  std::size_t distinct = 0;
  for (std::size_t end = 0; end < chain.size(); ++end) {
    if (times[triangle_of(chain[end].first)]++ == 0) ++distinct;
    if (end >= triangles && --times[triangle_of(chain[end - triangles].first)] == 0) --distinct;
    if (distinct < triangles) continue;
    const auto window = chain.subspan(end + 1 - triangles, triangles);
    const Closure closure = chains.closure(window.front(), window.back());
    if (best.taken.empty() || closure > best.closure) best = {window, closure};
  }
  return best;
}

SequentialOrder order_of(const Triangulation& mesh, const Window& window) {
  SequentialOrder out;
  out.closure = window.closure;
  for (const Taken t : window.taken) {
    out.order.push_back(triangle_of(t.first));
    out.sequence.push_back(mesh.origin(t.first));
  }
  const HalfedgeId rest = next_halfedge(window.taken.back().first);
  out.sequence.push_back(mesh.origin(rest));
  out.sequence.push_back(mesh.target(rest));
  if (!window.taken.back().counter_clockwise) {
    std::swap(out.sequence.back(), out.sequence[out.sequence.size() - 2]);
  }
  return out;
}

}  // namespace

std::optional<SequentialOrder> sequential_order(const Triangulation& mesh) {
  Chains chains(mesh);
  std::optional<SequentialOrder> best;
  for (HalfedgeId corner = 0; corner < std::min<std::size_t>(3, mesh.tri_vertex.size()); ++corner) {
    const std::vector<Taken> chain = chains.chain_through({corner, true});
    const Window window = best_window(chains, chain, mesh.triangle_count());
    if (window.taken.empty() || (best && window.closure <= best->closure)) continue;
    best = order_of(mesh, window);
  }
  return best;
}

}  // namespace quadloom
