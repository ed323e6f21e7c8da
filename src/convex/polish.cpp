#include "convex/polish.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "convex/best_parting.hpp"
#include "convex/cluster.hpp"
#include "convex/mending.hpp"
#include "convex/price.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/squareness.hpp"

namespace quadloom::convex {

using quadrangulate::classify_quad;
using quadrangulate::PairedMesh;
using quadrangulate::QuadKind;

namespace {

constexpr double kPoor = 0.25;  // squareness; about 68% of random quads are better
constexpr int kRounds = 3, kRoundsIfThrifty = 1;
constexpr double kVeryPoor = 0.05;  // where so many are to be polished that not all tries are made
constexpr std::size_t kMostTries = 6;
constexpr std::size_t kClusters = 10'000;  // looked at in the first round, about
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
  std::vector<TriangleId> none_spare;  // counts stay
  const int rounds = mesh.mate.size() > kThriftyMesh ? kRoundsIfThrifty : kRounds;
  for (int round = 0; round < rounds; ++round) {
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
        part_cluster(mesh, grower.cluster(), parting->quads, {}, none_spare);
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

  void smooth(VertexId v) {
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
        if (!std::isfinite(to.x) || !std::isfinite(to.y)) continue;
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

  std::array<VertexId, 3> parents_of(VertexId v) const;

 private:
  using Quads = std::vector<std::array<VertexId, 4>>;

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

/// The largest triangle of some of the vertices that the point is in; none if there is none.
std::optional<std::array<VertexId, 3>> largest_around(const PairedMesh& mesh, Point s,
                                                      std::span<const VertexId> vertex) {
  std::optional<std::array<VertexId, 3>> best;
  double largest = -1;
  const auto consider = [&](VertexId a, VertexId b, VertexId c) {
    const Point p = mesh.point(a), q = mesh.point(b), r = mesh.point(c);
    if (kernel::orient(p, q, s) < 0 || kernel::orient(q, r, s) < 0 || kernel::orient(r, p, s) < 0) {
      return;
    }
    const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area <= largest || kernel::orient(p, q, r) <= 0) return;
    largest = area;
    best = {a, b, c};
  };
  for (std::size_t k = 2; k < vertex.size(); ++k) {
    for (std::size_t j = 1; j < k; ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        consider(vertex[i], vertex[j], vertex[k]);
        consider(vertex[i], vertex[k], vertex[j]);
      }
    }
  }
  return best;
}

/// A triangle of vertices that are no such points, as near as there is one: corners of the quads around, and
/// where those are points themselves, of the quads around them. They have it between them, since they
/// surround them.
std::array<VertexId, 3> Smoother::parents_of(VertexId v) const {
  std::vector<VertexId> points = {v}, around;
  for (std::size_t i = 0; i < points.size();) {
    for (const std::size_t end = points.size(); i < end; ++i) {
      for (const auto& quad : quads_.at(points[i])) {
        for (const VertexId w : quad) {
          auto& list = quads_.contains(w) ? points : around;
          if (std::find(list.begin(), list.end(), w) == list.end()) list.push_back(w);
        }
      }
    }
    if (const auto parents = largest_around(mesh_, mesh_.point(v), around)) return *parents;
  }
  return {kNone, kNone, kNone};
}

}  // namespace

void smooth_points(PairedMesh& mesh, std::span<SteinerPoint> points) {
  if (points.empty()) return;
  Smoother smoother(mesh, points);
  for (int round = 0; round < 2; ++round) {
    for (const SteinerPoint& s : points) smoother.smooth(s.vertex);
  }
  for (SteinerPoint& s : points) {
    if (s.kind == SteinerKind::kInner) s.parents = smoother.parents_of(s.vertex);
  }
}

}  // namespace quadloom::convex
