#include "input_kind.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "timer.hpp"

namespace quadloom::app {
namespace {

constexpr std::array<std::string_view, 11> kMeshes = {
    "obj", "off", "ply", "stl", "vtu", "vtu-ascii", "msh", "msh22", "14", "gr3", "ele"};

std::string lower_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

std::string ending_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending.empty() ? ending : lower_case(ending.substr(1));
}

}  // namespace

FoundInput find_input(const std::string& path, const std::string& format, InputKind asked) {
  if (asked != InputKind::kAuto) return {asked, {}, 0};
  const std::string name = format.empty() ? ending_of(path) : format;
  if (std::find(kMeshes.begin(), kMeshes.end(), name) != kMeshes.end()) {
    return {InputKind::kMesh, {}, 0};
  }
  if (name == "poly") return {InputKind::kPolygons, {}, 0};
  // Standard input can be read only once; the readers of points do that.
  if (path == "-" || (name != "geojson" && name != "json")) return {InputKind::kPoints, {}, 0};
  const Timer reading;
  io::PlanarFile planar = io::read_planar(path, name);
  const double seconds = reading.seconds();
  const bool points = planar.input.polygons.empty() && planar.input.segments.empty();
  return {points ? InputKind::kPoints : InputKind::kPolygons, std::move(planar), seconds};
}

}  // namespace quadloom::app
