// Options that several verbs share.
#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "input_kind.hpp"
#include "mesh_input.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::app {

/// A file of points: INPUT, --format and --columns.
struct InputOptions {
  std::string path;
  io::ReadPointsOptions reading;
};
void add_input(CLI::App& verb, InputOptions& options);
/// The same for a file of points, a mesh or polygons.
void add_any_input(CLI::App& verb, InputOptions& options);

/// How a mesh is made: --odd-boundary and --seed.
void add_making(CLI::App& verb, PointOptions& options);
/// An option that is a whole number from `least` to `most`; anything else is a usage error.
CLI::Option* add_whole_number(CLI::App& verb, const std::string& flag, std::uint64_t initial,
                              std::uint64_t least, std::uint64_t most, const std::string& help,
                              std::function<void(std::uint64_t)> set);
template <std::integral Integer>
CLI::Option* add_whole(CLI::App& verb, const std::string& flag, Integer& value, std::uint64_t least,
                       std::uint64_t most, const std::string& help) {
  return add_whole_number(verb, flag, static_cast<std::uint64_t>(value), least, most, help,
                          [&value](std::uint64_t v) { value = static_cast<Integer>(v); });
}
inline constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// An option that is a number from `least` to `most`; anything else, NaN too, is a usage error.
CLI::Option* add_number(CLI::App& verb, const std::string& flag, double& value, double least,
                        double most, const std::string& help);

/// The most threads to work on, 0 if not said: --threads, for every verb.
void add_threads(CLI::App& app, std::size_t& threads);

/// What the input holds: --input.
void add_kind(CLI::App& verb, InputKind& kind);
CLI::Option* add_odd_boundary(CLI::App& verb, OddBoundary& odd_boundary);
/// How meshes and polygons are converted: --leftover, --pairs, --matching, --min-quality.
void add_conversion(CLI::App& verb, TriangleOptions& options);
/// How meshes are taken: --space, --faulty, --merge-vertices.
void add_connecting(CLI::App& verb, ConnectOptions& options);
/// These, and what stays of meshes and polygons: --regions, --keep, --keep-angle.
void add_mesh_reading(CLI::App& verb, MeshReading& reading, double& keep_angle);
void add_space(CLI::App& verb, Space& space, const std::string& help);

/// The method of that name for the kind of input. Throws Error kBadOption, which lists those there are.
PointMethod point_method(const std::string& word);
ConvexMethod convex_method(const std::string& word);
TriangleMethod triangle_method(const std::string& word);
std::string method_words();

void add_colour(CLI::App& verb, io::ColourBy& colour);

/// The name of an enum's value as it is written on the command line.
std::string name_of(PointMethod method);
std::string name_of(ConvexMethod method);
std::string name_of(TriangleMethod method);
std::string name_of(Leftover leftover);
std::string name_of(PairKind pairs);
std::string name_of(MatchingEffort effort);
std::string name_of(OddBoundary odd_boundary);
std::string name_of(SteinerKind kind);

/// A file's name without its folder and ending, for titles.
std::string short_name(const std::string& path);

/// Throws Error kFile, with a sentence, if no file can be made at that path: found out before the
/// work instead of after it. An empty path and "-" pass.
void require_writable(const std::string& path);
/// The same for a mesh, whose name or format must be known.
void require_mesh(const std::string& path, const std::string& format);
/// The same for a picture, whose name must have an ending that is known.
void require_picture(const std::string& path);
/// Throws Error kBadOption if two of the outputs are the same file, or both standard output; empty ones
/// are none.
void require_different(const std::vector<std::string>& outputs);

}  // namespace quadloom::app
