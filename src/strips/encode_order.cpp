// Codes of triangles in a given order, and of the best order for very few.
//
// A triangle can be drawn from six states, its three edges, even or odd; what lies between the state
// after one triangle and that of the next is a bridge (strip_writer.hpp). So the shortest code of an
// order is a shortest path through layers of six states, and the shortest code at all is a
// travelling salesman's tour over triangles in their states, by dynamic programming over sets (Held
// and Karp 1962). No triangle is drawn twice.
//
// Steps of encode_order: choose_states, write. Of shortest_order: the table of bridges, fewest (by sets
// and last states), read_back. Cost: O(n); O(2^n n^2).
#include "strips/encode_order.hpp"

#include <algorithm>
#include <limits>

#include "strips/strip_writer.hpp"

namespace quadloom::strips {
namespace {

constexpr std::uint32_t kStates = 6;  // of a triangle

/// State s of triangle t: edge s / 2, odd if s is.
StripState state_of(const Triangulation& mesh, TriangleId t, std::uint32_t s) {
  const HalfedgeId h = 3 * t + s / 2;
  if (s % 2 == 1) return {mesh.target(h), mesh.origin(h), true};
  return {mesh.origin(h), mesh.target(h), false};
}

StripState after_state(const Triangulation& mesh, TriangleId t, std::uint32_t s) {
  return after(state_of(mesh, t, s), mesh.apex(3 * t + s / 2));
}

/// Indices to send before the triangle `to` can be drawn from its state.
std::size_t cost(const Triangulation& mesh, StripEncoding encoding, TriangleId from,
                 std::uint32_t from_state, TriangleId to, std::uint32_t to_state) {
  return bridge(after_state(mesh, from, from_state), state_of(mesh, to, to_state), encoding).size;
}

std::vector<std::uint8_t> choose_states(const Triangulation& mesh,
                                        const std::vector<TriangleId>& order,
                                        StripEncoding encoding) {
  std::vector<std::array<std::uint8_t, kStates>> from(order.size());
  std::array<std::size_t, kStates> least = {2, 3, 2, 3, 2, 3};  // an odd beginning takes one more
  for (std::size_t i = 1; i < order.size(); ++i) {
    std::array<std::size_t, kStates> next;
    for (std::uint32_t s = 0; s < kStates; ++s) {
      next[s] = std::numeric_limits<std::size_t>::max();
      for (std::uint32_t r = 0; r < kStates; ++r) {
        const std::size_t sum = least[r] + cost(mesh, encoding, order[i - 1], r, order[i], s);
        if (sum >= next[s]) continue;
        next[s] = sum;
        from[i][s] = static_cast<std::uint8_t>(r);
      }
    }
    least = next;
  }
  std::vector<std::uint8_t> state(order.size());
  auto s = static_cast<std::uint8_t>(std::min_element(least.begin(), least.end()) - least.begin());
  for (std::size_t i = order.size(); i-- > 0;) {
    state[i] = s;
    s = from[i][s];
  }
  return state;
}

HalfedgeId edge_between(const Triangulation& mesh, TriangleId a, TriangleId b) {
  for (HalfedgeId h = 3 * a; h < 3 * a + 3; ++h) {
    if (mesh.twin[h] != kNone && triangle_of(mesh.twin[h]) == b) return h;
  }
  return kNone;
}

}  // namespace

StripResult encode_order(const Triangulation& mesh, const std::vector<TriangleId>& order,
                         StripEncoding encoding) {
  const std::vector<std::uint8_t> state = choose_states(mesh, order, encoding);
  StripWriter writer(encoding, order.size());
  StripResult result;
  result.triangles = order.size();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const StripState to = state_of(mesh, order[i], state[i]);
    const std::size_t size = i == 0 ? 2 : bridge(writer.state(), to, encoding).size;
    const std::size_t restarts = writer.restarts();
    writer.go_to(to);
    writer.draw(mesh.apex(3 * order[i] + state[i] / 2));
    result.swaps += size == 1;
    result.strips += size > 1;
    result.joined += i > 0 && size > 1 && size < 4 && writer.restarts() == restarts;
  }
  result.restarts = writer.restarts();
  result.code = std::move(writer).take();
  return result;
}

std::vector<TriangleId> shortest_order(const Triangulation& mesh, StripEncoding encoding) {
  const auto count = static_cast<std::uint32_t>(mesh.triangle_count());
  const std::uint32_t states = encoding == StripEncoding::kSwap ? 1 : kStates;
  const std::uint32_t nodes = count * states;
  std::vector<std::uint8_t> bridges(std::size_t{nodes} * nodes);
  for (std::uint32_t a = 0; a < nodes; ++a) {
    for (std::uint32_t b = 0; b < nodes; ++b) {
      const TriangleId from = a / states, to = b / states;
      bridges[std::size_t{a} * nodes + b] = static_cast<std::uint8_t>(
          states == 1 ? (edge_between(mesh, from, to) == kNone ? 1 : 0)
                      : cost(mesh, encoding, from, a % states, to, b % states));
    }
  }
  constexpr std::uint8_t kNever = 0xff;
  std::vector<std::uint8_t> least((std::size_t{1} << count) * nodes, kNever), from(least.size());
  for (std::uint32_t a = 0; a < nodes; ++a) {
    least[(std::size_t{1} << a / states) * nodes + a] = a % states % 2;
  }
  for (std::size_t set = 1; set < std::size_t{1} << count; ++set) {
    for (std::uint32_t a = 0; a < nodes; ++a) {
      const std::uint8_t so_far = least[set * nodes + a];
      if (so_far == kNever) continue;
      for (std::uint32_t b = 0; b < nodes; ++b) {
        if ((set >> b / states & 1) != 0) continue;
        const std::size_t there = (set | std::size_t{1} << b / states) * nodes + b;
        const auto sum = static_cast<std::uint8_t>(so_far + bridges[std::size_t{a} * nodes + b]);
        if (sum >= least[there]) continue;
        least[there] = sum;
        from[there] = static_cast<std::uint8_t>(a);
      }
    }
  }
  std::vector<TriangleId> order(count);
  std::size_t set = (std::size_t{1} << count) - 1;
  const auto all = least.begin() + static_cast<std::ptrdiff_t>(set * nodes);
  auto last = static_cast<std::uint32_t>(std::min_element(all, all + nodes) - all);
  for (std::uint32_t i = count; i-- > 0;) {
    order[i] = last / states;
    const std::uint32_t before = from[set * nodes + last];
    set ^= std::size_t{1} << last / states;
    last = before;
  }
  return order;
}

PathPartition paths_of_order(const Triangulation& mesh, const std::vector<TriangleId>& order) {
  PathPartition paths;
  HalfedgeId entry = kNone;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const HalfedgeId on = i + 1 < order.size() ? edge_between(mesh, order[i], order[i + 1]) : kNone;
    const HalfedgeId any = entry == kNone ? 3 * order[i] : next_halfedge(entry);
    paths.leave.push_back(on == kNone ? any : on);
    entry = on == kNone ? kNone : mesh.twin[on];
    if (on == kNone) paths.begin.push_back(static_cast<std::uint32_t>(paths.leave.size()));
  }
  return paths;
}

}  // namespace quadloom::strips
