// Clusters of a mesh cut anew by search, with fewer added points than they had, or none.
#pragma once

#include "convex/mending.hpp"
#include "convex/recut.hpp"

namespace quadloom::convex {

/// Works on the cluster that the state's grower has grown.
class Recutter {
 public:
  /// How large clusters may be: a large one has many partings without a new point, and too many with one.
  enum class Size : std::uint8_t { kUsual, kLarge };

  explicit Recutter(Mending& state) : state_(state) {}

  /// Quads around a triangle's, `more` of them unless the cluster gets too large.
  void grow(TriangleId t, std::size_t more, Size size);
  /// The quads around an added point, and perhaps more; false if that cannot be.
  bool grow_around(VertexId v, std::size_t more, Size size);

  /// Looks at the cluster as it is now; false if it is too large for a search.
  bool look();
  std::size_t bad() const { return bad_; }               ///< quads of the cluster
  std::size_t points() const { return points_.size(); }  ///< added points inside the cluster

  /// Cuts the cluster into strictly convex quads with at most so many added points inside, at new places or where
  /// they are. False, and nothing changed, if none were found, as with points in large clusters. Then the cluster is that of before, and
  /// triangles() are those of the new quads.
  bool cut(std::size_t most_points, RecutOrder order);
  const std::vector<TriangleId>& triangles() const { return triangles_; }
  /// How many points fewer the last cut that was made has.
  std::size_t fewer() const { return fewer_; }

 private:
  void grow_more(std::size_t more, Size size);
  bool prepare(std::size_t most_points);
  bool loses_sources(std::size_t quads) const;

  Mending& state_;
  std::size_t bad_ = 0, fewer_ = 0;
  std::vector<VertexId> inside_, points_;  // of the cluster: given vertices, and added points
  std::vector<Point> corner_, given_, places_;
  std::optional<RecutSearch> search_;
  std::vector<TriangleId> triangles_;
};

}  // namespace quadloom::convex
