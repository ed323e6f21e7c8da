#include "io/msh_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace quadloom::io {
namespace {

constexpr std::size_t kMostSections = 1000;

}  // namespace

//    1 "name"   1 0.0   3 0 1 2       strings, reals, integers: step, components, entries
//    1 0.5                            an entry: a number, a value for each component
void read_msh_data(MshTokens& tokens, const NumberMap& map, std::vector<MshData>& out) {
  if (out.size() == kMostSections) tokens.fail(fmt::format("more than {} data", kMostSections));
  MshData data{"data", {}};
  const auto strings = tokens.text_count("the count of strings");
  for (std::uint64_t i = 0; i < strings; ++i) {
    auto text = tokens.quoted("a name");
    if (i == 0) data.name = std::move(text);
  }
  const auto reals = tokens.text_count("the count of reals");
  for (std::uint64_t i = 0; i < reals; ++i) tokens.text_number("a time");
  std::array<std::uint64_t, 3> header = {0, 1, 0};
  const auto integers = tokens.text_count("the count of integers");
  for (std::uint64_t i = 0; i < integers; ++i) {
    const auto value = tokens.text_count("a step or count");
    if (i < header.size()) header[i] = value;
  }
  const auto [step, components, entries] = header;
  tokens.end_text();
  if (std::ranges::find(out, data.name, &MshData::name) != out.end()) {
    data.name += fmt::format("_{}", step);
  }
  for (std::uint64_t i = 0; i < entries; ++i) {
    const auto at = map.find(tokens.index("the number of a node or element"));
    for (std::uint64_t k = 0; k < components; ++k) {
      const double value = tokens.number("a value");
      if (components == 1 && at) data.values.emplace_back(*at, value + 0.0);
    }
  }
  if (components == 1) out.push_back(std::move(data));
}

void add_msh_data(const std::vector<MshData>& data, std::size_t size, std::vector<Attribute>& out) {
  for (const auto& [name, values] : data) {
    Attribute attribute{name, std::vector<double>(size, std::numeric_limits<double>::quiet_NaN())};
    for (const auto& [index, value] : values) attribute.values[index] = value;
    out.push_back(std::move(attribute));
  }
}

}  // namespace quadloom::io
