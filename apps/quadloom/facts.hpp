// The closing lines of a command that made or judged a mesh.
#pragma once

#include <string>

#include "make_mesh.hpp"

namespace quadloom::app {

/// "1,000 points, 984 quads, no triangle, 1 point added outside, 98.2% strictly convex, angles from
/// 4.1 to 213.0 degrees, 0.03 s".
std::string facts_line(const MadeMesh& made);

/// Sentences that the facts alone do not tell, one a line: a fall back, repeated points, ...
std::string remarks(const MadeMesh& made, const PointRun& run);

/// "certified: ..." or "NOT CERTIFIED: ..." with the first culprits.
std::string verdict_line(const Certificate& certificate, bool with_points);

/// "no point added", "1 point added outside", "3,001 points added 3,000 inside, 1 on a hull edge"; the
/// words for a point on an edge and for several are given.
std::string added_points(const std::vector<SteinerPoint>& steiner, const std::string& on_edge,
                         const std::string& on_edges);

/// "1 quad", "12,345 quads".
std::string counted(std::size_t n, const std::string& singular);
std::string counted(std::size_t n, const std::string& singular, const std::string& plural);

/// Per cent of n in `of`, with one decimal and never rounded to 100.0 or 0.0 unless it is.
std::string percent(std::size_t n, std::size_t of);

}  // namespace quadloom::app
