// Ways through single triangles, what they are worth together, and the best choice on trees by table.
#pragma once

#include <array>
#include <cstdint>

namespace quadloom::strips {

/// How a path uses a triangle: i = 0..2, edges i + 1 and i + 2 and not i; 3 + i, edge i alone; kNoWay,
/// none.
using Way = std::uint8_t;
inline constexpr Way kNoWay = 6;
inline constexpr std::size_t kWays = 6;  // that can be chosen

/// How a triangle uses one of its edges. An edge is on a path if both of its triangles use it.
enum EdgeUse : std::uint8_t {
  kUnused = 0,
  kKeepsPrevious = 1,  // goes on or came in by the edge before it, and leaves the next one
  kKeepsNext = 2,
  kAlone = 3,  // and no other edge
};
inline constexpr std::size_t kUses = 4;

/// How each way uses each edge.
inline constexpr std::array<std::array<EdgeUse, 3>, kWays + 1> kUseOfWay = {{
    {kUnused, kKeepsNext, kKeepsPrevious},
    {kKeepsPrevious, kUnused, kKeepsNext},
    {kKeepsNext, kKeepsPrevious, kUnused},
    {kAlone, kUnused, kUnused},
    {kUnused, kAlone, kUnused},
    {kUnused, kUnused, kAlone},
    {kUnused, kUnused, kUnused},
}};

/// What an edge on a path is worth: where the path turns to different sides before and after it, or
/// ends, and where it turns to the same side.
struct EdgeWorth {
  int other_side = 1;
  int same_side = 1;
};

/// The worth of an edge that its triangles use in these ways.
//
//     turns to other sides      to the same side
//        u____                      ____
//       / \  /                   \ /\  /
//      /___\/                     \__\/       the kept edges are at one end of the edge, so the one
//          v                                  triangle keeps its next and the other its previous one
int worth_of(EdgeWorth worth, EdgeUse a, EdgeUse b);

/// Optimal choices on a tree of triangles, others being fixed, by dynamic programming. What a subtree
/// tells its parent is the most that it is worth for each use of the edge between them, less that for
/// kUnused. These are few different messages, so they are numbers and the programme is two tables. A
/// fixed triangle's use of an edge is the message of the same number.
class WayTables {
 public:
  static constexpr std::size_t kMost = 16;     // messages
  static constexpr std::size_t kVariants = 4;  // of choices among equals

  WayTables(EdgeWorth worth, std::uint64_t seed);

  /// The message over an edge of a triangle that gets these over its next and its previous edge.
  std::uint8_t upward(std::uint8_t next, std::uint8_t previous) const {
    return upward_[next * kMost + previous];
  }
  /// The best way of a triangle that gets these over its edges a, a + 1 and a + 2.
  Way best(std::uint32_t variant, std::size_t a, std::uint8_t m0, std::uint8_t m1,
           std::uint8_t m2) const {
    return kTurned[a][best_[((variant * kMost + m0) * kMost + m1) * kMost + m2]];
  }
  /// The worth of the edges of a triangle of that way with neighbours of these uses.
  int worth(EdgeUse a, EdgeUse b) const { return worth_[a][b]; }

 private:
  using Message = std::array<int, kUses>;

  static constexpr std::array<std::array<Way, kWays>, 3> kTurned = {{
      {0, 1, 2, 3, 4, 5},
      {1, 2, 0, 4, 5, 3},
      {2, 0, 1, 5, 3, 4},
  }};

  Message combine(const Message& next, const Message& previous) const;
  std::uint8_t number_of(const Message& message);
  void close_messages();
  void choose(std::uint64_t seed);

  std::array<std::array<int, kUses>, kUses> worth_ = {};
  std::array<Message, kMost> message_ = {};
  std::size_t messages_ = 0;
  std::array<std::uint8_t, kMost* kMost> upward_ = {};
  std::array<Way, kVariants* kMost* kMost* kMost> best_ = {};
};

}  // namespace quadloom::strips
