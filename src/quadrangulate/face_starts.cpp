#include "quadrangulate/face_starts.hpp"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>

#include "quadloom/kernel.hpp"
#include "quadrangulate/two_faces.hpp"

namespace quadloom::quadrangulate {
namespace {

constexpr std::uint32_t kNoLabel = kNone;

/// Squared distances, for ranking alone.
class Growth {
 public:
  Growth(LabelledTriangles& out, std::size_t k)
      : out_(out), mesh_(out.mesh), most_(k - 2), face_of_vertex_(mesh_.points.size(), kNoLabel) {}

  void grow_from(TriangleId seed) {
    label_ = static_cast<std::uint32_t>(out_.labels++);
    centre_ = centre(seed);
    queue_ = {};
    for (int i = 0; i < 3; ++i) face_of_vertex_[mesh_.tri_vertex[3 * seed + i]] = label_;
    own(seed);
    for (std::size_t size = 1; size < most_ && !queue_.empty();) {
      const HalfedgeId h = queue_.top().second;
      queue_.pop();
      const VertexId tip = mesh_.apex(h);
      if (out_.label[triangle_of(h)] != kNoLabel || face_of_vertex_[tip] == label_) continue;
      face_of_vertex_[tip] = label_;
      own(triangle_of(h));
      ++size;
    }
  }

 private:
  using Entry = std::pair<double, HalfedgeId>;

  Point centre(TriangleId t) const {
    Point sum{0, 0};
    for (int i = 0; i < 3; ++i) {
      const Point p = mesh_.points[mesh_.tri_vertex[3 * t + i]];
      sum = {sum.x + p.x / 3, sum.y + p.y / 3};
    }
    return sum;
  }

  void own(TriangleId t) {
    out_.label[t] = label_;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfedgeId beyond = mesh_.twin[h];
      if (beyond == kNone || out_.label[triangle_of(beyond)] != kNoLabel) continue;
      const Point c = centre(triangle_of(beyond));
      const double dx = c.x - centre_.x, dy = c.y - centre_.y;
      const double distance = dx * dx + dy * dy;
      queue_.push({distance >= 0 ? distance : 0, beyond});
    }
  }

  LabelledTriangles& out_;
  const Triangulation& mesh_;
  std::size_t most_;
  std::vector<std::uint32_t> face_of_vertex_;  // the last face that has it
  std::uint32_t label_ = 0;
  Point centre_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// A forest over the triangles, across the edges that are not barriers: an order with parents
/// before children.
struct Forest {
  std::vector<TriangleId> order;
  std::vector<TriangleId> parent;
};

/// Roots have a hull edge, and so no three children.
Forest make_forest(const Triangulation& mesh, const std::vector<char>& barrier) {
  Forest forest;
  forest.parent.assign(mesh.triangle_count(), kNone);
  std::vector<char> seen(mesh.triangle_count(), 0);
  for (HalfedgeId root = 0; root < mesh.twin.size(); ++root) {
    if (mesh.twin[root] != kNone || seen[triangle_of(root)]) continue;
    seen[triangle_of(root)] = 1;
    forest.order.push_back(triangle_of(root));
    for (std::size_t i = forest.order.size() - 1; i < forest.order.size(); ++i) {
      const TriangleId t = forest.order[i];
      for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
        if (mesh.twin[h] == kNone || barrier[h] || seen[triangle_of(mesh.twin[h])]) continue;
        const TriangleId child = triangle_of(mesh.twin[h]);
        seen[child] = 1;
        forest.parent[child] = t;
        forest.order.push_back(child);
      }
    }
  }
  return forest;
}

/// Children first, each triangle joins the open groups of its children if they fit, or else the
/// smaller one; a group with no room is closed.
void cut_trees(LabelledTriangles& out, const Forest& forest, std::size_t most) {
  const std::size_t count = out.mesh.triangle_count();
  std::vector<std::array<TriangleId, 2>> children(count, {kNone, kNone});
  for (const TriangleId t : forest.order) {
    if (forest.parent[t] == kNone) continue;
    auto& slot = children[forest.parent[t]];
    (slot[0] == kNone ? slot[0] : slot[1]) = t;
  }
  std::vector<std::size_t> open(count, 0);  // the size of the group with this triangle as its top
  std::vector<char> joins_parent(count, 0);
  for (auto it = forest.order.rbegin(); it != forest.order.rend(); ++it) {
    open[*it] = 1;
    auto [small, large] = children[*it];
    if (large != kNone && open[large] < open[small]) std::swap(small, large);
    for (const TriangleId child : {small, large}) {
      if (child == kNone || open[*it] + open[child] > most) continue;
      joins_parent[child] = 1;
      open[*it] += open[child];
    }
  }
  for (const TriangleId t : forest.order) {
    out.label[t] =
        joins_parent[t] ? out.label[forest.parent[t]] : static_cast<std::uint32_t>(out.labels++);
  }
}

}  // namespace

LabelledTriangles grow_faces(std::span<const Point> points, std::size_t k) {
  LabelledTriangles out;
  out.mesh = delaunay(points).mesh;
  out.label.assign(out.mesh.triangle_count(), kNoLabel);
  Growth growth(out, k);
  for (TriangleId t = 0; t < out.label.size(); ++t) {
    if (out.label[t] == kNoLabel) growth.grow_from(t);
  }
  return out;
}

LabelledTriangles cut_sides(std::span<const Point> points, std::span<const VertexId> hull,
                            std::size_t from, std::size_t steps, std::size_t k,
                            const Progress& progress) {
  LabelledTriangles out;
  std::vector<char> barrier;
  if (hull.size() == points.size()) {
    out.mesh = delaunay(points).mesh;
    barrier.assign(out.mesh.twin.size(), 0);
  } else {
    const CutPath cut = cut_through_all(points, hull, from, steps);
    PlanarInput input;
    input.points.assign(points.begin(), points.end());
    for (std::size_t i = 0; i + 1 < cut.vertices.size(); ++i) {
      input.segments.push_back({cut.vertices[i], cut.vertices[i + 1]});
    }
    ConstrainedResult result = constrained_delaunay(input, Extent::kHull, progress);
    out.mesh = std::move(result.mesh);
    barrier.assign(out.mesh.twin.size(), 0);
    for (HalfedgeId h = 0; h < barrier.size(); ++h) barrier[h] = result.edge[h] != kNone;
  }
  out.label.assign(out.mesh.triangle_count(), kNoLabel);
  cut_trees(out, make_forest(out.mesh, barrier), k - 2);
  return out;
}

}  // namespace quadloom::quadrangulate
