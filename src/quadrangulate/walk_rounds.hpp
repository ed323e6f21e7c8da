// Rounds of walks that bring the left-over triangles of a paired mesh together.
#pragma once

#include <span>
#include <vector>

#include "quadrangulate/quick_walk.hpp"
#include "quadrangulate/walk.hpp"

namespace quadloom::quadrangulate {

std::vector<TriangleId> free_triangles(const PairedMesh& mesh);
std::vector<FaceId> free_triangles(const QuadMesh& mesh);

/// What cheap searches do not bring together: a quad may be passed by several routes, and wheels turned.
inline constexpr WalkLimits kLastPlanarRounds[] = {
    {WalkQuads::kAny, kNone},
    {WalkQuads::kAny, kNone, 4},
    {WalkQuads::kAny, kNone, 16},
    {WalkQuads::kAny, kNone, 255},
};

/// Small searches first bring near ones together; what has no convex way within 4,000 nodes seldom has one. Inner
/// points may be added instead of the longest searches: in narrow corridors there often is no way, and searches of
/// several visits would see all of the mesh again for each triangle.
inline constexpr WalkLimits kCorridorRounds[] = {
    {WalkQuads::kStrictlyConvex, 20},
    {WalkQuads::kStrictlyConvex, 100},
    {WalkQuads::kStrictlyConvex, 1'000},
    {WalkQuads::kStrictlyConvex, 4'000, 2},
    {WalkQuads::kAny, 1'000},
    {WalkQuads::kAny, 100'000},
    {WalkQuads::kAny, 200'000, 4},
    {WalkQuads::kAny, 40'000, 16},
    {WalkQuads::kAny, 20'000, 255},
};

/// Those of them that may leave any simple quad behind.
inline constexpr std::span<const WalkLimits> kLastCorridorRounds =
    std::span(kCorridorRounds).subspan(4);

/// On a surface a re-cut changes its shape, so only where it is rather flat (normals within 20 and
/// then 45 degrees), and not far: a Steiner point keeps the shape.
inline constexpr WalkLimits kSurfaceRounds[] = {
    {WalkQuads::kStrictlyConvex, 20, 1, 0.94},    {WalkQuads::kStrictlyConvex, 200, 1, 0.94},
    {WalkQuads::kStrictlyConvex, 4'000, 2, 0.94}, {WalkQuads::kStrictlyConvex, 4'000, 2, 0.7},
    {WalkQuads::kAny, 10'000, 2, 0.94},           {WalkQuads::kAny, 10'000, 2, 0.7},
};

struct WalkCounts {
  std::size_t walks = 0, steps = 0;
};

/// Brings free triangles together that have a short way through strictly convex quads; the best-shaped way if
/// there is one through one quad. Large meshes on several threads.
WalkCounts walk_convexly(QuadMesh& mesh, const Progress& progress);
/// The same by thorough searches, as long as they cost next to nothing: rows of points lock many triangles.
void walk_deeply(Walker& walker, const PairedMesh& mesh);
/// Brings free triangles together, leaving any quads behind: all but one, or some that only kLastPlanarRounds find a way
/// for.
WalkCounts walk_anyhow(QuadMesh& mesh);

/// In each round every triangle that is still free looks for another within the round's limits.
/// Returns how many are free at the end.
std::size_t walk_together(Walker& walker, const PairedMesh& mesh,
                          std::span<const WalkLimits> rounds, const Progress& progress);

}  // namespace quadloom::quadrangulate
