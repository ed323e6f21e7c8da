// A text cut into blocks of whole lines, for several threads.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/parallel.hpp"

namespace quadloom::io {

inline constexpr std::size_t kBlockBytes = std::size_t{1} << 20;

struct LineBlock {
  std::string_view text;
  std::size_t first_line;
};

/// Blocks of about so many bytes, each but the last ending with a line's end; one at least.
std::vector<LineBlock> line_blocks(std::string_view text, std::size_t first_line,
                                   std::size_t block_bytes);

/// Calls read(block, part) for each block with a part of its own; returns these. If some throw, it is the
/// exception of the first block that comes through, as if they were read one after the other.
template <class Part, class Read>
std::vector<Part> read_blocks(const std::vector<LineBlock>& blocks, const Read& read) {
  std::vector<Part> parts(blocks.size());
  parallel_tasks_in_order(blocks.size(), [&](std::size_t i) { read(blocks[i], parts[i]); });
  return parts;
}

}  // namespace quadloom::io
