#include "io/line_blocks.hpp"

#include <algorithm>

namespace quadloom::io {

std::vector<LineBlock> line_blocks(std::string_view text, std::size_t first_line,
                                   std::size_t block_bytes) {
  std::vector<LineBlock> blocks;
  do {
    const auto end = block_bytes < text.size() ? text.find('\n', block_bytes - 1) : text.npos;
    const std::size_t size = end == text.npos ? text.size() : end + 1;
    blocks.push_back({text.substr(0, size), first_line});
    text.remove_prefix(size);
  } while (!text.empty());
  std::vector<std::size_t> lines(blocks.size());
  parallel_tasks(blocks.size(), [&](std::size_t i) {
    lines[i] = static_cast<std::size_t>(std::ranges::count(blocks[i].text, '\n'));
  });
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    blocks[i].first_line = blocks[i - 1].first_line + lines[i - 1];
  }
  return blocks;
}

}  // namespace quadloom::io
