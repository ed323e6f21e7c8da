#include "options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <map>

#include "choice.hpp"

namespace quadloom::app {
namespace {

const std::map<std::string, PointMethod> kMethods = {{"delaunay", PointMethod::kDelaunay},
                                                     {"spiral", PointMethod::kSpiral},
                                                     {"insertion", PointMethod::kInsertion},
                                                     {"subdivide", PointMethod::kSubdivide}};
const std::map<std::string, ConvexMethod> kConvexMethods = {
    {"delaunay", ConvexMethod::kDelaunay},
    {"spiral", ConvexMethod::kSpiral},
    {"pentagons", ConvexMethod::kPentagons}};
const std::map<std::string, OddBoundary> kOddBoundaries = {{"outside", OddBoundary::kOutside},
                                                           {"on-edge", OddBoundary::kOnEdge},
                                                           {"triangle", OddBoundary::kTriangle}};
const std::map<std::string, TriangleMethod> kTriangleMethods = {
    {"pair", TriangleMethod::kPair},       {"percolate", TriangleMethod::kPercolate},
    {"fans", TriangleMethod::kFans},       {"q-percolate", TriangleMethod::kQPercolate},
    {"quarter", TriangleMethod::kQuarter}, {"subdivide", TriangleMethod::kSubdivide}};
const std::map<std::string, Leftover> kLeftovers = {{"error", Leftover::kError},
                                                    {"triangle", Leftover::kTriangle},
                                                    {"walk", Leftover::kWalk},
                                                    {"steiner", Leftover::kSteiner}};
const std::map<std::string, PairKind> kPairKinds = {
    {"auto", PairKind::kAuto}, {"convex", PairKind::kConvex}, {"any", PairKind::kAny}};
const std::map<std::string, MatchingEffort> kEfforts = {{"exact", MatchingEffort::kExact},
                                                        {"near", MatchingEffort::kNear}};
const std::map<std::string, InputKind> kInputKinds = {{"auto", InputKind::kAuto},
                                                      {"points", InputKind::kPoints},
                                                      {"polygons", InputKind::kPolygons},
                                                      {"mesh", InputKind::kMesh}};
const std::map<std::string, Space> kSpaces = {
    {"auto", Space::kAuto}, {"plane", Space::kPlane}, {"surface", Space::kSurface}};
const std::map<std::string, FaultyFaces> kFaulty = {{"repair", FaultyFaces::kRepair},
                                                    {"refuse", FaultyFaces::kRefuse}};
const std::map<std::string, io::ColourBy> kColours = {{"quality", io::ColourBy::kQuality},
                                                      {"convexity", io::ColourBy::kConvexity},
                                                      {"none", io::ColourBy::kNone}};

template <typename Enum>
Enum find_method(const std::map<std::string, Enum>& names, const std::string& word,
                 const char* input) {
  const auto found = names.find(word);
  if (found != names.end()) return found->second;
  throw Error(ErrorCode::kBadOption, fmt::format("--method: '{}' is none of {}, which are for {}",
                                                 word, all_words(names), input));
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

CLI::Option* add_number(CLI::App& verb, const std::string& flag, double& value, double least,
                        double most, const std::string& help) {
  return verb
      .add_option_function<std::string>(
          flag,
          [&value, flag, least, most](const std::string& word) {
            double number = 0;
            const char* const end = word.data() + word.size();
            const auto [stop, error] = std::from_chars(word.data(), end, number);
            if (error != std::errc() || stop != end || !(number >= least && number <= most)) {
              throw CLI::ValidationError(
                  flag, fmt::format("'{}' is no number from {} to {}", word, least, most));
            }
            value = number;
          },
          help)
      ->type_name("X")
      ->default_str(fmt::format("{}", value));
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

void add_any_input(CLI::App& verb, InputOptions& options) {
  verb.add_option(
          "INPUT", options.path,
          "Points: .csv, .xyz, .txt, .node; a mesh: .obj, .off, .ply, .stl, .vtu, .msh, .14, .ele; "
          "polygons: .poly; points or polygons: .geojson; - for standard input")
      ->required();
  verb.add_option("--format", options.reading.format,
                  "Format of the input if not by the name: csv, xyz, geojson, obj, ...");
  verb.add_option("--columns", options.reading.columns,
                  "Points: columns of x, y and perhaps z, header names or numbers from 1, as in "
                  "lon,lat");
}

void add_making(CLI::App& verb, PointOptions& options) {
  add_choice(verb, "--odd-boundary", options.odd_boundary, kOddBoundaries,
             "If the hull has an odd number of points: add a point outside, or on a hull edge, or "
             "leave one triangle");
  add_whole(verb, "--seed", options.seed, 0, kNoLimit, "Seed of random choices");
}

void add_threads(CLI::App& app, std::size_t& threads) {
  add_whole(app, "--threads", threads, 1, kNoLimit,
            "Work on at most so many threads, before or after VERB; results are the same")
      ->default_str("all cores");
}

void add_kind(CLI::App& verb, InputKind& kind) {
  add_choice(verb, "--input", kind, kInputKinds,
             "What the file holds, where its name (or what is in a GeoJSON) should not decide");
}

void add_conversion(CLI::App& verb, TriangleOptions& o) {
  const auto in_group = [](CLI::Option* option) { option->group("Meshes and polygons"); };
  in_group(
      add_choice(verb, "--leftover", o.leftover, kLeftovers,
                 "pair: what becomes of triangles that are left over: none may be (error), they "
                 "stay, walk together, or take inner points"));
  in_group(add_choice(verb, "--pairs", o.pairs, kPairKinds,
                      "pair: only strictly convex pairs, or any; auto: any, and for walk those "
                      "that are not strictly "
                      "convex are parted again"));
  in_group(add_choice(verb, "--matching", o.effort, kEfforts,
                      "pair: the best matching, or one near it, with its gap in the report"));
  in_group(add_number(verb, "--min-quality", o.min_quality, 0, 1,
                      "pair: the matching makes no pair of a lesser shape (1: rectangle); with "
                      "--leftover triangle nothing does"));
}

void add_space(CLI::App& verb, Space& space, const std::string& help) {
  add_choice(verb, "--space", space, kSpaces, help);
}

void add_connecting(CLI::App& verb, ConnectOptions& o) {
  constexpr const char* kGroup = "Meshes and polygons";
  add_choice(
      verb, "--space", o.space, kSpaces,
      "What z is: data over the plane, or a surface in space; auto: plane if all faces, seen "
      "from above, turn the same way")
      ->group(kGroup);
  add_choice(verb, "--faulty", o.faulty, kFaulty,
             "Faces turned over and faces without area: repaired and said, or refused")
      ->group(kGroup);
  verb.add_flag_callback(
          "--merge-vertices", [&o] { o.equal = EqualVertices::kMerge; },
          "Make vertices at exactly the same place one")
      ->group(kGroup);
}

void add_mesh_reading(CLI::App& verb, MeshReading& reading, double& keep_angle) {
  constexpr const char* kGroup = "Meshes and polygons";
  const auto word = [&](const char* flag, std::string& value, const char* type, const char* help) {
    verb.add_option(flag, value, help)->type_name(type)->capture_default_str()->group(kGroup);
  };
  word("--regions", reading.regions, "auto|none|NAME",
       "Numbers of the faces that new faces never mix; auto: region, physical, material, part, "
       "attribute0, or the parts of polygons");
  word("--keep", reading.keep, "lines|none|FILE",
       "Edges that stay: the lines in the file of the mesh, or those of another file (.geojson, "
       ".poly) along edges of the mesh");
  add_number(verb, "--keep-angle", keep_angle, 0, 180,
             "Surfaces: keep edges where the faces turn by more degrees than this")
      ->default_str("")
      ->group(kGroup);
  add_connecting(verb, reading.connect);
}

CLI::Option* add_odd_boundary(CLI::App& verb, OddBoundary& odd_boundary) {
  return add_choice(
      verb, "--odd-boundary", odd_boundary, kOddBoundaries,
      "If the hull, or the border of a part, is odd: add a point outside (default for "
      "points), on an edge (default for meshes), or leave one triangle");
}

PointMethod point_method(const std::string& word) { return find_method(kMethods, word, "points"); }
ConvexMethod convex_method(const std::string& word) {
  return find_method(kConvexMethods, word, "points with --convex, beside subdivide");
}
TriangleMethod triangle_method(const std::string& word) {
  return find_method(kTriangleMethods, word, "meshes and polygons");
}
std::string method_words() {
  return all_words(kMethods) + "|pentagons; meshes, polygons: " + all_words(kTriangleMethods);
}

void add_colour(CLI::App& verb, io::ColourBy& colour) {
  add_choice(verb, "--colour,--color", colour, kColours, "What the faces' colours show");
}

std::string name_of(PointMethod method) { return find_name(kMethods, method); }
std::string name_of(ConvexMethod method) { return find_name(kConvexMethods, method); }
std::string name_of(TriangleMethod method) { return find_name(kTriangleMethods, method); }
std::string name_of(Leftover leftover) { return find_name(kLeftovers, leftover); }
std::string name_of(PairKind pairs) { return find_name(kPairKinds, pairs); }
std::string name_of(MatchingEffort effort) { return find_name(kEfforts, effort); }
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

void require_different(const std::vector<std::string>& outputs) {
  std::map<std::filesystem::path, std::string> seen;
  for (const std::string& output : outputs) {
    if (output.empty()) continue;
    const auto file = output == "-" ? std::filesystem::path(output)
                                    : std::filesystem::absolute(output).lexically_normal();
    if (seen.emplace(file, output).second) continue;
    throw Error(ErrorCode::kBadOption,
                output == "-" ? "two outputs cannot both be standard output"
                              : fmt::format("two outputs cannot both be '{}'", output));
  }
}

}  // namespace quadloom::app
