// Better ways of paths through triangles, by exact optimisation over random forests.
//
// A partition into paths is a way for each triangle (way_tables.hpp): which of its edges it uses.
// What a partition costs is, but for cycles, a sum over edges, so that the best ways of all triangles
// of a forest, while the others stay as they are, come from dynamic programming. Half of the
// triangles of a mesh can be in one forest. We draw forests at random, again and again; each pass
// keeps or raises the worth, choices among equals move the ends of paths about until they meet.
//
// Steps, for each patch (patches.hpp): load, then in each pass draw_forest (a triangle is in it if at
// most one of its neighbours was drawn before), tell_upwards (messages from the leaves to the roots),
// choose_downwards (ways from the roots to the leaves); store. Rounds use other patches, so that each
// edge is inside of one.
//
// Ours: the paper leaves the problem, which is NP-hard, at a heuristic for travelling salesmen; the
// stripifiers in use take one strip after the other. Determinism: the seed alone decides. Degenerate
// input: any graph of at most three edges a node, parallel ones too (their triangles are then never
// both in the forest). Cost: about 6 ns a triangle and pass; the working set is a patch.
#include "strips/improve_ways.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/random.hpp"
#include "strips/patches.hpp"

namespace quadloom::strips {
namespace {

constexpr std::uint32_t kPatch = 4096;  // triangles: 120 kB
constexpr std::array<std::uint8_t, 6> kTurn = {0, 1, 2, 0, 1, 2};

/// A patch on its own. Slot 4 i + e is edge e of triangle i.
class Patch {
 public:
  Patch(const DualGraph& graph, const WayTables& tables)
      : graph_(graph),
        tables_(tables),
        across_(4 * kPatch),
        message_(4 * (kPatch + 1)),
        drawn_(kPatch + 1),
        forest_(kPatch + 1) {}

  std::vector<TriangleId> triangles;

  void load(const PatchGrower& grower, const std::vector<Way>& way);
  void pass(Random& random);
  void store(std::vector<Way>& way) const {
    for (std::size_t i = 0; i < triangles.size(); ++i) way[triangles[i]] = way_[i];
  }

 private:
  static constexpr std::uint32_t kOutside = 4 * kPatch;  // a slot that nobody reads
  static constexpr std::uint32_t kRoot = 3;  // instead of the edge to the parent; leads outside
  static constexpr std::uint8_t kNo = 4;
  /// The edge to the only neighbour drawn, by the set of them.
  static constexpr std::array<std::uint8_t, 8> kParent = {kRoot, 0, 1, kNo, 2, kNo, kNo, kNo};

  std::uint32_t draw_forest(Random& random);
  void tell_upwards(std::uint32_t count);
  void choose_downwards(std::uint32_t count, std::uint32_t bits);

  const DualGraph& graph_;
  const WayTables& tables_;
  std::vector<std::uint32_t> across_;  // by slot: the slot on the other side
  std::vector<std::uint8_t> message_;  // by slot: what comes in over the edge
  std::vector<std::uint8_t> drawn_;
  std::vector<std::uint32_t> forest_;  // 4 i + the edge to the parent, parents first
  std::vector<Way> way_;
};

void Patch::load(const PatchGrower& grower, const std::vector<Way>& way) {
  way_.resize(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    way_[i] = way[triangles[i]];
    across_[4 * i + kRoot] = kOutside;
    for (std::uint32_t e = 0; e < 3; ++e) {
      const HalfedgeId twin = graph_.twin[3 * triangles[i] + e];
      across_[4 * i + e] = kOutside;
      message_[4 * i + e] = kUnused;
      if (twin == kNone) continue;
      const TriangleId t = triangle_of(twin);
      const std::uint32_t there = grower.local(t);
      message_[4 * i + e] = kUseOfWay[way[t]][twin % 3];
      if (there < triangles.size() && triangles[there] == t) {
        across_[4 * i + e] = 4 * there + twin % 3;
      }
    }
  }
}

std::uint32_t Patch::draw_forest(Random& random) {
  const auto size = static_cast<std::uint32_t>(triangles.size());
  const std::uint32_t mask = std::bit_ceil(size) - 1;
  // Numbers mod a power of two in steps of an odd number: all of them, without a table.
  const std::uint32_t step = (static_cast<std::uint32_t>(random.next()) & mask) | 1;
  std::uint32_t i = static_cast<std::uint32_t>(random.next()) & mask;
  std::fill_n(drawn_.begin(), size, 0);
  std::uint32_t count = 0;
  for (std::uint32_t n = 0; n <= mask; ++n) {  // no branch that depends on what was drawn
    i = (i + step) & mask;
    if (i >= size) continue;
    const std::uint32_t* across = &across_[4 * i];
    const unsigned neighbours =
        drawn_[across[0] / 4] + 2U * drawn_[across[1] / 4] + 4U * drawn_[across[2] / 4];
    const std::uint8_t parent = kParent[neighbours];
    forest_[count] = 4 * i + (parent & 3U);
    drawn_[i] = parent <= kRoot;
    count += parent <= kRoot;
  }
  return count;
}

void Patch::tell_upwards(std::uint32_t count) {
  for (std::uint32_t n = count; n-- > 0;) {
    const std::uint32_t slot = forest_[n], e = slot & 3;
    const std::uint8_t* message = &message_[slot - e];
    message_[across_[slot]] = tables_.upward(message[kTurn[e + 1]], message[kTurn[e + 2]]);
  }
}

void Patch::choose_downwards(std::uint32_t count, std::uint32_t bits) {
  for (std::uint32_t n = 0; n < count; ++n) {
    bits = bits * 1664525 + 1013904223;
    const std::uint32_t first = forest_[n] & ~3U;
    const std::uint32_t e = kTurn[forest_[n] & 3];
    const std::uint8_t* message = &message_[first];
    const Way way =
        tables_.best(bits >> 30, e, message[e], message[kTurn[e + 1]], message[kTurn[e + 2]]);
    way_[first / 4] = way;
    for (std::uint32_t i = 0; i < 3; ++i) message_[across_[first + i]] = kUseOfWay[way][i];
  }
}

void Patch::pass(Random& random) {
  const std::uint32_t count = draw_forest(random);
  tell_upwards(count);
  choose_downwards(count, static_cast<std::uint32_t>(random.next()));
}

}  // namespace

void improve_ways(const DualGraph& graph, const WayTables& tables, const Rounds& rounds,
                  std::uint64_t seed, const Progress& progress, std::vector<Way>& way) {
  Random random(seed + rounds.first);
  Patch patch(graph, tables);
  for (std::size_t round = rounds.first; round < rounds.first + rounds.count; ++round) {
    PatchGrower grower(
        graph, round % 4 < 2 ? kPatch : 3 * kPatch / 4,
        round % 2 == 0 ? PatchGrower::Direction::kUp : PatchGrower::Direction::kDown);
    std::size_t done = 0;
    for (grower.grow(patch.triangles); !patch.triangles.empty(); grower.grow(patch.triangles)) {
      patch.load(grower, way);
      for (std::size_t pass = 0; pass < rounds.passes; ++pass) patch.pass(random);
      patch.store(way);
      done += patch.triangles.size();
      report_progress(progress, "strips",
                      (static_cast<double>(round) +
                       static_cast<double>(done) / static_cast<double>(graph.node_count())) /
                          static_cast<double>(rounds.of));
    }
  }
}

}  // namespace quadloom::strips
