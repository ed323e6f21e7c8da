// The sections $NodeData and $ElementData of Gmsh's .msh.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/msh_tokens.hpp"
#include "io/numbers.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

/// Numbers of some vertices or faces.
struct MshData {
  std::string name;
  std::vector<std::pair<std::uint32_t, double>> values;
};

/// From after the section's name to before its end. Data of more than one component a node, and of
/// numbers that are not in the map, are skipped.
void read_msh_data(MshTokens& tokens, const NumberMap& map, std::vector<MshData>& out);

/// Each as a number for all `size` vertices or faces, NaN where there is none.
void add_msh_data(const std::vector<MshData>& data, std::size_t size, std::vector<Attribute>& out);

}  // namespace quadloom::io
