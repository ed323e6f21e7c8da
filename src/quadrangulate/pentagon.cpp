#include "quadrangulate/pentagon.hpp"

namespace quadloom::quadrangulate {

[[gnu::noinline]] void PentagonTurns::decide_exactly(const std::array<Point, 5>& p,
                                                     std::uint32_t decided) {
  for (std::size_t turn = 0; turn < 10; ++turn) {
    if ((decided >> turn & 1U) != 0) continue;
    const std::size_t k = turn % 5;
    const int sign =
        turn < 5 ? kernel::cross_exact(p[(k + 4) % 5], p[k], p[k], p[(k + 1) % 5])
                 : kernel::cross_exact(p[k], p[(k + 2) % 5], p[(k + 2) % 5], p[(k + 3) % 5]);
    left_ |= static_cast<std::uint32_t>(sign > 0) << turn;
    right_ |= static_cast<std::uint32_t>(sign < 0) << turn;
  }
}

}  // namespace quadloom::quadrangulate
