// Judging faces in blocks, on several threads.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "quadloom/certify.hpp"

namespace quadloom::certify {

inline constexpr std::size_t kFacesOfBlock = std::size_t{1} << 15;

/// Calls judge(first, last, verdict) for blocks of faces, each with a verdict of its own, which counts up to
/// the first fault of its block. Returns the verdicts in the order of the blocks.
template <class JudgeBlock>
std::vector<Certificate> judge_in_blocks(std::size_t faces, JudgeBlock judge) {
  std::vector<Certificate> verdicts(faces / kFacesOfBlock + 1);
  parallel_for_blocks(faces, kFacesOfBlock, [&](std::size_t first, std::size_t last) {
    judge(first, last, verdicts[first / kFacesOfBlock]);
  });
  return verdicts;
}

}  // namespace quadloom::certify
