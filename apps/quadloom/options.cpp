#include "options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <map>

namespace quadloom::app {
namespace {

const std::map<std::string, PointMethod> kMethods = {{"delaunay", PointMethod::kDelaunay},
                                                     {"spiral", PointMethod::kSpiral},
                                                     {"insertion", PointMethod::kInsertion},
                                                     {"subdivide", PointMethod::kSubdivide}};
const std::map<std::string, OddBoundary> kOddBoundaries = {{"outside", OddBoundary::kOutside},
                                                           {"on-edge", OddBoundary::kOnEdge},
                                                           {"triangle", OddBoundary::kTriangle}};
const std::map<std::string, io::ColourBy> kColours = {{"quality", io::ColourBy::kQuality},
                                                      {"convexity", io::ColourBy::kConvexity},
                                                      {"none", io::ColourBy::kNone}};

template <typename Enum>
std::string find_name(const std::map<std::string, Enum>& names, Enum value) {
  for (const auto& [name, v] : names) {
    if (v == value) return name;
  }
  return "?";
}

// An option whose value is one of a few words; the error names them.
template <typename Enum>
CLI::Option* add_choice(CLI::App& verb, const std::string& flag, Enum& value,
                        const std::map<std::string, Enum>& names, const std::string& help) {
  std::string words;
  for (const auto& entry : names) words += (words.empty() ? "" : "|") + entry.first;
  return verb
      .add_option_function<std::string>(
          flag,
          [&value, &names, flag, words](const std::string& word) {
            const auto found = names.find(word);
            if (found == names.end()) {
              throw CLI::ValidationError(flag, fmt::format("'{}' is none of {}", word, words));
            }
            value = found->second;
          },
          help)
      ->type_name(words)
      ->default_str(find_name(names, value));
}

}  // namespace

CLI::Option* add_whole_number(CLI::App& verb, const std::string& flag, std::uint64_t initial,
                              std::uint64_t least, std::uint64_t most, const std::string& help,
                              std::function<void(std::uint64_t)> set) {
  return verb
      .add_option_function<std::string>(
          flag,
          [set = std::move(set), flag, least, most](const std::string& word) {
            std::uint64_t number = 0;
            const char* const end = word.data() + word.size();
            const auto [stop, error] = std::from_chars(word.data(), end, number);
            if (error == std::errc() && stop == end && number >= least && number <= most) {
              set(number);
              return;
            }
            const std::string limit = most == kNoLimit ? "up" : fmt::format("to {}", most);
            throw CLI::ValidationError(
                flag, fmt::format("'{}' is no whole number from {} {}", word, least, limit));
          },
          help)
      ->type_name("N")
      ->default_str(std::to_string(initial));
}

void add_input(CLI::App& verb, InputOptions& options) {
  verb.add_option("INPUT", options.path,
                  "Points: .csv, .xyz, .txt, .geojson, .json, or - for standard input")
      ->required();
  verb.add_option("--format", options.reading.format,
                  "Format of the points if not by the name: csv, xyz or geojson");
  verb.add_option("--columns", options.reading.columns,
                  "Columns of x, y and perhaps z: header names or numbers from 1, as in lon,lat");
}

void add_making(CLI::App& verb, PointOptions& options) {
  add_choice(verb, "--odd-boundary", options.odd_boundary, kOddBoundaries,
             "If the hull has an odd number of points: add a point outside, or on a hull edge, or "
             "leave one triangle");
  add_whole(verb, "--seed", options.seed, 0, kNoLimit, "Seed of random choices");
}

void add_method(CLI::App& verb, PointMethod& method) {
  add_choice(verb, "--method", method, kMethods,
             "delaunay: the best shapes; spiral, insertion: Bose and Toussaint's; subdivide: three "
             "strictly convex quads for every Delaunay triangle");
}

void add_colour(CLI::App& verb, io::ColourBy& colour) {
  add_choice(verb, "--colour,--color", colour, kColours, "What the faces' colours show");
}

std::string name_of(PointMethod method) { return find_name(kMethods, method); }
std::string name_of(OddBoundary odd_boundary) { return find_name(kOddBoundaries, odd_boundary); }
std::string name_of(SteinerKind kind) {
  switch (kind) {
    case SteinerKind::kOutside:
      return "outside";
    case SteinerKind::kOnEdge:
      return "on a hull edge";
    case SteinerKind::kInner:
      return "inside";
  }
  return "?";
}

std::string short_name(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).stem().string();
}

void require_writable(const std::string& path) {
  if (path.empty() || path == "-") return;
  std::error_code ignored;
  const std::filesystem::path file(path);
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (std::filesystem::is_directory(file, ignored)) {
    throw Error(ErrorCode::kFile, fmt::format("cannot write '{}': it is a folder", path));
  }
  if (!std::filesystem::is_directory(folder, ignored)) {
    throw Error(ErrorCode::kFile,
                fmt::format("cannot write '{}': there is no folder '{}'", path, folder.string()));
  }
}

void require_mesh(const std::string& path, const std::string& format) {
  io::require_mesh_format(path, format);
  require_writable(path);
}

void require_picture(const std::string& path) {
  if (path.empty()) return;
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".svg" && ending != ".png" && ending != ".pdf") {
    throw Error(ErrorCode::kBadOption,
                fmt::format("the picture '{}' must end in .svg, .png or .pdf", path));
  }
  require_writable(path);
}

}  // namespace quadloom::app
