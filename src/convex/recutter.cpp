#include "convex/recutter.hpp"

#include <algorithm>

#include "convex/places.hpp"

namespace quadloom::convex {
namespace {

constexpr std::size_t kPlaces = 10;  // new ones; more find more, in more time
constexpr std::size_t kMostGiven = kMostRecutPoints - kPlaces - 6;
constexpr std::size_t kMostPoints = 4;
constexpr std::size_t kSteps = 200;  // of a search; most end within 20

std::size_t most_corners(Recutter::Size size) { return size == Recutter::Size::kLarge ? 22 : 14; }

}  // namespace

void Recutter::grow_more(std::size_t more, Size size) {
  const auto& corner = state_.grower.cluster().corner;
  for (std::size_t i = 0; i < more && corner.size() < most_corners(size); ++i) {
    if (!state_.grower.grow(state_.random, Inside::kAllowed)) return;
  }
}

void Recutter::grow(TriangleId t, std::size_t more, Size size) {
  state_.grower.start(t);
  grow_more(more, size);
}

bool Recutter::grow_around(VertexId v, std::size_t more, Size size) {
  const TriangleId t = state_.triangle_at(v);
  if (state_.mesh.is_free(t)) return false;
  state_.grower.start(t);
  if (!state_.grower.surround(v, most_corners(size))) return false;
  grow_more(more, size);
  return true;
}

bool Recutter::look() {
  const Cluster& cluster = state_.grower.cluster();
  if (cluster.corner.size() + cluster.inside.size() > kMostRecutPoints) return false;
  inside_.clear();
  points_.clear();
  for (const VertexId v : cluster.inside) {
    (state_.is_inner_point(v) ? points_ : inside_).push_back(v);
  }
  if (points_.size() > kMostPoints) return false;
  bad_ = state_.bad_in(cluster);
  corner_ = state_.points_of(cluster.corner);
  given_ = state_.points_of(inside_);
  search_.reset();
  return true;
}

/// The tables of the search. Places: new ones, and those where points are now, so that a cut that changes little is
/// found as well. Where a cut without points is tried first, one with points is next, unless the cluster is large.
bool Recutter::prepare(std::size_t most_points) {
  const bool room = corner_.size() + given_.size() <= kMostGiven;
  if (most_points > 0 && !room) return false;
  if (search_) return true;
  places_.clear();
  if (room && points_.size() + most_points > 0) {
    places_ = random_places(corner_, given_, kPlaces, state_.random);
    for (const Point p : state_.points_of(points_)) {
      if (std::find(places_.begin(), places_.end(), p) == places_.end()) places_.push_back(p);
    }
  }
  search_.emplace(corner_, given_, places_);
  return true;
}

bool Recutter::cut(std::size_t most_points, RecutOrder order) {
  if (most_points > kMostPoints) return false;
  if (!may_be_recut(corner_, given_.size(), most_points)) return false;
  if (!prepare(most_points)) return false;
  const auto found = search_->find(most_points, kSteps, order, state_.random);
  if (!found) return false;
  if (found->places.size() < points_.size() && loses_sources(found->quads.size())) return false;
  std::vector<Point> places;
  for (const std::uint8_t k : found->places) places.push_back(places_[k]);
  fewer_ = points_.size() - std::min(points_.size(), places.size());
  triangles_ = state_.part(state_.grower.cluster(), found->quads, inside_, places);
  return true;
}

/// Whether the triangles have more sources than so many quads can carry.
bool Recutter::loses_sources(std::size_t quads) const {
  if (state_.mesh.source.empty()) return false;
  std::vector<TriangleId> sources;
  for (const TriangleId t : state_.grower.cluster().slot) {
    sources.push_back(state_.mesh.source[t]);
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources.size() > 2 * quads;
}

}  // namespace quadloom::convex
