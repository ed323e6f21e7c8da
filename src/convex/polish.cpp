#include "convex/polish.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "convex/best_parting.hpp"
#include "convex/cluster.hpp"
#include "convex/price.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"

namespace quadloom::convex {

using quadrangulate::classify_quad;
using quadrangulate::PairedMesh;
using quadrangulate::QuadKind;

namespace {

constexpr double kPoor = 0.25;  // squareness; about 68% of random quads are better
constexpr int kRounds = 3;
constexpr double kVeryPoor = 0.05;  // where so many are to be polished that not all tries are made
constexpr std::size_t kMostTries = 6;
constexpr std::size_t kClusters = 40'000;  // looked at in the first round, about
constexpr std::size_t kLargest = 6;        // quads of a cluster
constexpr double kLeastGain = 1e-6;

constexpr int kSteps = 16;  // of a vertex, each half as long or a move

std::array<VertexId, 4> corners_of(const PairedMesh& mesh, TriangleId t) {
  const HalfedgeId h = mesh.mate[t], twin = mesh.tri.twin[h];
  return {mesh.tri.origin(h), mesh.tri.apex(twin), mesh.tri.target(h), mesh.tri.apex(h)};
}

/// Negative if the quad is not strictly convex.
double shape_of(const PairedMesh& mesh, const std::array<VertexId, 4>& quad) {
  const Point a = mesh.point(quad[0]), b = mesh.point(quad[1]), c = mesh.point(quad[2]),
              d = mesh.point(quad[3]);
  if (classify_quad(a, b, c, d) != QuadKind::kStrictlyConvex) return -1;
  return kernel::squareness(a, b, c, d);
}

double cost_of(const PairedMesh& mesh, const Cluster& cluster) {
  double cost = 0;
  for (const TriangleId t : cluster.slot) {
    cost += price(shape_of(mesh, corners_of(mesh, t))) / 2;  // each quad is seen from both halves
  }
  return cost;
}

}  // namespace

void polish_quads(PairedMesh& mesh, std::vector<TriangleId> triangles, Random& random) {
  ClusterGrower grower(mesh);
  for (int round = 0; round < kRounds; ++round) {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::vector<TriangleId> touched;
    const std::size_t tries =
        std::clamp<std::size_t>(kClusters / (triangles.size() + 1), 1, kMostTries);
    const double poor = tries == kMostTries ? kPoor : kVeryPoor;
    for (const TriangleId t : triangles) {
      for (std::size_t i = 0; i < tries && !mesh.is_free(t); ++i) {
        const double shape = shape_of(mesh, corners_of(mesh, t));
        if (shape < 0 || shape > poor) break;
        grower.start(t);
        const std::size_t wanted = 2 + random.below(kLargest - 1);
        while (grower.cluster().quad_count() < wanted && grower.grow(random)) {
        }
        std::vector<Point> polygon;
        for (const VertexId v : grower.cluster().corner) polygon.push_back(mesh.point(v));
        const double now = cost_of(mesh, grower.cluster());
        const auto parting = best_parting(polygon, now - kLeastGain, Stars::kNone, price);
        if (!parting) continue;
        part_cluster(mesh, grower.cluster(), parting->quads, {});
        const auto& slot = grower.cluster().slot;
        touched.insert(touched.end(), slot.begin(), slot.end());
      }
    }
    triangles = std::move(touched);
  }
}

namespace {

class Smoother {
 public:
  Smoother(PairedMesh& mesh, std::span<const SteinerPoint> points) : mesh_(mesh) {
    for (const SteinerPoint& s : points) {
      if (s.kind == SteinerKind::kInner) quads_[s.vertex] = {};
    }
    for (const SteinerPoint& s : points) {
      for (const VertexId parent : s.parents) quads_.erase(parent);
    }
    VertexId first = kNone;  // added points come last
    for (const auto& [v, quads] : quads_) first = std::min(first, v);
    for (TriangleId t = 0; t < mesh.mate.size(); ++t) {
      const HalfedgeId h = mesh.mate[t];
      if (h == kNone || mesh.tri.twin[h] < h) continue;
      const auto corner = corners_of(mesh, t);
      for (const VertexId v : corner) {
        if (v < first) continue;
        if (const auto at = quads_.find(v); at != quads_.end()) at->second.push_back(corner);
      }
    }
  }

  void smooth(const SteinerPoint& s) {
    const VertexId v = s.vertex;
    const auto at = quads_.find(v);
    if (at == quads_.end()) return;
    const Quads& quads = at->second;
    double worst = worst_of(quads);
    if (worst < 0) return;
    double step = mean_side(v, quads) / 2;
    constexpr double kDiagonal = 0.70710678118654752;
    constexpr std::array<Point, 8> kDirections = {{{1, 0},
                                                   {kDiagonal, kDiagonal},
                                                   {0, 1},
                                                   {-kDiagonal, kDiagonal},
                                                   {-1, 0},
                                                   {-kDiagonal, -kDiagonal},
                                                   {0, -1},
                                                   {kDiagonal, -kDiagonal}}};
    for (int i = 0; i < kSteps; ++i) {
      const Point from = mesh_.tri.points[v];
      Point best = from;
      for (const Point d : kDirections) {
        const Point to{from.x + step * d.x, from.y + step * d.y};
        if (!std::isfinite(to.x) || !std::isfinite(to.y) || !between_parents(s, to)) continue;
        mesh_.tri.points[v] = to;
        const double now = worst_of(quads);
        if (now <= worst) continue;
        worst = now;
        best = to;
      }
      mesh_.tri.points[v] = best;
      if (best == from) step /= 2;
    }
  }

 private:
  using Quads = std::vector<std::array<VertexId, 4>>;

  bool between_parents(const SteinerPoint& s, Point p) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = mesh_.point(s.parents[k]), b = mesh_.point(s.parents[(k + 1) % 3]);
      if (kernel::orient(a, b, p) < 0) return false;
    }
    return true;
  }

  double worst_of(const Quads& quads) const {
    double worst = 1;
    for (const auto& quad : quads) worst = std::min(worst, shape_of(mesh_, quad));
    return worst;
  }

  double mean_side(VertexId v, const Quads& quads) const {
    double sum = 0;
    for (const auto& quad : quads) {
      for (const VertexId w : quad) {
        sum += std::hypot(mesh_.point(w).x - mesh_.point(v).x, mesh_.point(w).y - mesh_.point(v).y);
      }
    }
    return sum / (3 * static_cast<double>(quads.size()));
  }

  PairedMesh& mesh_;
  std::unordered_map<VertexId, Quads> quads_;
};

}  // namespace

void smooth_points(PairedMesh& mesh, std::span<const SteinerPoint> points) {
  if (points.empty()) return;
  Smoother smoother(mesh, points);
  for (int round = 0; round < 2; ++round) {
    for (const SteinerPoint& s : points) smoother.smooth(s);
  }
}

}  // namespace quadloom::convex
