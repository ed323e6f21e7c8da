// Step 5 of the algorithm in delaunay.cpp for a round of many points: on several threads.
#pragma once

#include <cstddef>

#include "kernel/delaunay_inserter.hpp"
#include "kernel/delaunay_mesh.hpp"
#include "kernel/insertion_order.hpp"

namespace quadloom::kernel {

/// Inserts the points [begin, end) of the order, which follow the curve. `anywhere` inserts those that
/// no range of the curve takes; returns how many.
std::size_t insert_in_ranges(DelaunayMesh& mesh, const InsertionOrder& order, std::size_t begin,
                             std::size_t end, DelaunayInserter& anywhere);

}  // namespace quadloom::kernel
