// Q-percolation: any triangulation into quads with inner Steiner points, over a spanning forest of its
// dual graph.
//
// Ramaswami, Ramos and Toussaint, Converting Triangulations to Quadrangulations, theorem 3.4, and their
// full paper's bound of n/4 as quoted by Bremner, Hurtado, Ramaswami and Sacristan. A part (triangles
// connected without crossing an edge that stays) of t triangles takes
//
//   kQPercolate: at most (t - 2) / 2 inner points if t is even; at most (t - 3) / 2 and one boundary point
//                if t is odd (none and one if t = 1): never more than t / 2 points for t > 1
//   kQuarter:    at most t / 4 inner points if t is even; at most (t - 1) / 4 and one boundary point if
//                t is odd
//
// rounded down; for a simple polygon of n corners t = n - 2. See `crowded` below for what doubles may
// spoil of the second line.
//
// Steps:
//   1. grow_forest   a spanning tree of each part, that has a maximum matching of the dual in it; what
//                    that leaves over is at the boundary if possible
//   2. root_trees    an odd tree at a triangle with a boundary edge that has a place for a Steiner
//                    point, left over if possible; any other at a triangle with one tree edge
//   3. percolate     from the leaves upwards, each triangle p = a, b, c, where a b is the edge to its
//                    parent, with what its children were left as (nothing, a leaf, or a fork: a
//                    triangle with two leaves):
//        no child left       p is a leaf
//        one leaf            it makes a quad with p
//        one fork            the fork becomes a leaf by a star (below), which makes a quad with p
//        two leaves          p is a fork; for kQPercolate a star makes it a leaf at once
//        leaf and fork, or   a star about p; the triangle a, b, s stays as a leaf in p's place
//        two forks
//   4. close_roots   a leaf at the root of an odd tree takes its boundary point and is a quad; a fork
//                    there becomes two quads with it
//
// A star about p puts one point s into the polygon of p and those of its children that are forks, such
// that it sees all edges. Each leaf at an edge of that polygon makes a quad with the triangle of s and the
// edge, simple since the two lie on either side of the edge:
//
//   x-------c-------y              w1    z2         Two leaves, x and y:
//    .    / | .    /              /  .  /  .          s c x a, s b y c; s in the triangle a b c
//     .  /  s  .  /              x-----c-----y      Two forks, one with w1 and v1, one with z1 and z2:
//      ./ '   ' ./              / .   / .   / .       s c w1 x, s x v1 a, s b z1 y, s y z2 c;
//       a-------b             v1---. / s .----z1      s in the pentagon a b y c x
//                                   a-----b         One fork: as on its side above
//
// Why s exists, in the plane: a triangle is seen from any point in it; a quad of two triangles from the
// points near the middle of their common edge. Two forks: near c, the polygon's edges that do not end
// at c have every point near c on their inner side, so what counts are the two that do. Let p, the
// fork over ca and the one over bc have the angles g, f and e at c. The points of p near c that x c
// leaves on its inner side are those within 180 - f degrees of c a; likewise 180 - e of c b; these two
// wedges of p overlap if and only if e + f + g < 360. They sum to more never in the plane, and to 360 only
// if the two forks share the edge c x = c y; then there is no leaf over it, and the fork is none.
//
// Why the bounds hold: each star of two leaves takes two triangles out of the tree, and the last step
// of an even tree is a pair, since its root has one child; an odd tree ends with its root, or a fork
// there, and its boundary point. In kQuarter each star takes four triangles at least: a fork that becomes
// a leaf and makes a quad with p goes with p (3 + 1), leaf and fork go (1 + 3) and p stays, two forks go
// (3 + 3) and p stays.
//
// What differs from the paper: one order from the leaves to the root in place of levels; the spanning
// tree has a maximum matching in it, so that a triangulation whose dual has a perfect matching gets no
// point at all (in a tree with one, no triangle ever has two leaves), and an odd one that has one but for
// a triangle at the boundary gets one point; the odd point may lie on the boundary; the root may have two
// children, whose leaves share the odd point.
//
// On a surface in space s is sought in the chart of the star's triangles and lies on one of them;
// boundary points are midpoints. Rounding may leave no double for a star: a star of two leaves then fails
// with an Error, a bigger one is replaced by stars of two leaves and counted (`crowded`), as are forks
// on a surface that s cannot see all of. Cost: O(n) after the matching.
#include "quadrangulate/triangulation_q_percolation.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "kernel/chart.hpp"
#include "kernel/predicates_inline.hpp"
#include "quadloom/dual.hpp"
#include "quadrangulate/boundary_matching.hpp"
#include "quadrangulate/edge_places.hpp"
#include "quadrangulate/mesh_parts.hpp"
#include "quadrangulate/place_in_kernel.hpp"
#include "quadrangulate/quad_collector.hpp"

namespace quadloom::quadrangulate {
namespace {

using kernel::Chart;
using kernel::Vector3;

/// What is left of a triangle's subtree.
enum class Left : std::uint8_t { kNothing, kLeaf, kFork };

/// A root, with the boundary point if its tree is odd.
struct Root {
  TriangleId triangle = kNone;
  HalfedgeId base = kNone;
  std::optional<EdgePlace> odd;
};

/// An edge of a star with the leaf behind it.
struct Spoke {
  VertexId from, apex, to;
  TriangleId leaf, owner;
};

/// A star: its edges but for a b, and the triangles that it covers.
struct Star {
  VertexId a = kNone;
  std::array<Spoke, 4> spoke;
  std::array<HalfedgeId, 3> hub;  // the bases of the triangles
  std::size_t spokes = 0, hubs = 0;
};

class QPercolation {
 public:
  QPercolation(const TriangleMesh& input, const TriangleOptions& options)
      : input_(input),
        mesh_(input.mesh),
        options_(options),
        places_{input.mesh.points, input.z},
        boundary_(input, options.odd_boundary),
        out_(input) {}

  TriangleResult run() {
    report_progress(options_.progress, "spanning forest", 0);
    grow_forest();
    root_trees();
    report_progress(options_.progress, "percolating", 0);
    percolate();
    close_roots();
    return out_.take();
  }

 private:
  void grow_forest();
  void root_trees();
  void percolate();
  void close_roots();

  /// Whether a border edge may be the base of an odd part's root.
  bool may_be_split(HalfedgeId h) const {
    return options_.odd_boundary == OddBoundary::kTriangle || mesh_.twin[h] == kNone;
  }
  Root choose_root(std::span<const TriangleId> tree);
  HalfedgeId only_one_left(std::span<const TriangleId> tree) const;
  Root odd_root(std::span<const TriangleId> tree);
  void append_tree(const Root& root);
  void reduce(TriangleId p, bool may_stay_fork);
  void reduce_pair(HalfedgeId h);
  Left left_over(HalfedgeId h) const {
    return forest_.twin[h] == kNone || h == base_[triangle_of(h)] ? Left::kNothing
                                                                  : left_[forest_.across(h)];
  }
  VertexId apex_of_leaf(TriangleId t) const {
    return apex_[t] != kNone ? apex_[t] : mesh_.apex(base_[t]);
  }
  void make_leaf(TriangleId fork);
  bool try_star(TriangleId p);
  void gather(HalfedgeId h, TriangleId owner, Star& star) const;
  std::optional<VertexId> place_in_star(const Star& star);
  bool try_shared_boundary_point(const Root& root);

  const TriangleMesh& input_;
  const Triangulation& mesh_;
  const TriangleOptions& options_;
  kernel::Places places_;
  EdgePlaces boundary_;
  QuadCollector out_;
  DualMatching matching_;
  DualGraph forest_;
  std::vector<Root> roots_;
  std::vector<TriangleId> order_;  // parents before children
  std::vector<HalfedgeId>
      base_;  // by triangle: the edge to the parent; of a root, an edge without child
  std::vector<Left> left_;
  std::vector<VertexId> apex_;  // of a leaf that a star left: s; else kNone
};

/// A breadth-first spanning forest that has all pairs of the matching in it: who finds a triangle finds
/// its partner.
DualGraph forest_with(const DualGraph& graph, const DualMatching& matching) {
  DualGraph forest{std::vector<HalfedgeId>(graph.twin.size(), kNone)};
  std::vector<std::uint8_t> seen(graph.node_count());
  std::vector<TriangleId> queue;
  queue.reserve(graph.node_count());
  const auto find = [&](TriangleId t) {
    seen[t] = 1;
    queue.push_back(t);
  };
  const auto join = [&](HalfedgeId h) {
    forest.twin[h] = graph.twin[h];
    forest.twin[graph.twin[h]] = h;
    find(graph.across(h));
  };
  const auto find_mate = [&](TriangleId t) {
    if (matching.mate[t] != kNone) join(matching.mate[t]);
  };
  for (TriangleId root = 0; root < graph.node_count(); ++root) {
    if (seen[root] != 0) continue;
    std::size_t next = queue.size();
    find(root);
    find_mate(root);
    for (; next < queue.size(); ++next) {
      for (HalfedgeId h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h) {
        if (graph.twin[h] == kNone || seen[graph.across(h)] != 0) continue;
        join(h);
        find_mate(graph.across(h));
      }
    }
  }
  return forest;
}

void QPercolation::grow_forest() {
  Triangulation cut = cut_along_kept_edges(input_);
  for (HalfedgeId h = 0; h < cut.twin.size(); ++h) {
    // Two triangles with the same three corners (on a surface) are no quad.
    const HalfedgeId twin = cut.twin[h];
    if (twin != kNone && cut.apex(h) == cut.apex(twin)) cut.twin[h] = cut.twin[twin] = kNone;
  }
  const DualGraph graph = dual_graph(cut);
  std::vector<std::uint8_t> may_stay(graph.node_count());
  for (HalfedgeId h = 0; h < graph.twin.size(); ++h) {
    if (may_be_split(h) && graph.twin[h] == kNone) may_stay[triangle_of(h)] = 1;
  }
  matching_ = matching_inside_first(graph, may_stay);
  out_.statistics().unmatched = matching_.unmatched;
  forest_ = forest_with(graph, matching_);
}

void QPercolation::root_trees() {
  const std::size_t triangles = mesh_.triangle_count();
  base_.assign(triangles, kNone);
  left_.assign(triangles, Left::kLeaf);
  apex_.assign(triangles, kNone);
  order_.reserve(triangles);
  std::vector<std::uint8_t> seen(triangles);
  std::vector<TriangleId> tree;
  for (TriangleId first = 0; first < triangles; ++first) {
    if (seen[first] != 0) continue;
    tree.assign(1, first);
    seen[first] = 1;
    for (std::size_t next = 0; next < tree.size(); ++next) {
      for (HalfedgeId h = 3 * tree[next]; h < 3 * tree[next] + 3; ++h) {
        if (forest_.twin[h] == kNone || seen[forest_.across(h)] != 0) continue;
        seen[forest_.across(h)] = 1;
        tree.push_back(forest_.across(h));
      }
    }
    roots_.push_back(choose_root(tree));
    append_tree(roots_.back());
  }
}

Root QPercolation::choose_root(std::span<const TriangleId> tree) {
  ++out_.statistics().parts;
  if (tree.size() % 2 == 1) {
    ++out_.statistics().odd_parts;
    if (options_.odd_boundary != OddBoundary::kTriangle) return odd_root(tree);
    if (const HalfedgeId h = only_one_left(tree); h != kNone) return {triangle_of(h), h, {}};
  }
  for (const TriangleId t : tree) {
    HalfedgeId alone = kNone;
    int edges = 0;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (forest_.twin[h] == kNone)
        alone = h;
      else
        ++edges;
    }
    if (edges <= 1) return {t, alone, std::nullopt};
  }
  throw Error(ErrorCode::kBadMesh, "a spanning tree without a leaf", {tree[0]});
}

/// An edge without tree edge of the triangle that the matching leaves over, if it is the only one.
HalfedgeId QPercolation::only_one_left(std::span<const TriangleId> tree) const {
  HalfedgeId found = kNone;
  for (const TriangleId t : tree) {
    if (matching_.mate[t] != kNone) continue;
    if (found != kNone) return kNone;
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (forest_.twin[h] == kNone) found = h;
    }
    if (found == kNone) return kNone;
  }
  return found;
}

/// At a boundary edge that has a place: one of a triangle that the matching leaves over if possible, the
/// longest of these.
Root QPercolation::odd_root(std::span<const TriangleId> tree) {
  struct Edge {
    bool is_matched;
    double minus_length;
    HalfedgeId halfedge;
  };
  std::vector<Edge> edges;
  for (const TriangleId t : tree) {
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (!may_be_split(h)) continue;
      const Vector3 along = places_.at(mesh_.target(h)) - places_.at(mesh_.origin(h));
      edges.push_back({matching_.mate[t] != kNone, -dot(along, along), h});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.is_matched, a.minus_length, a.halfedge) <
           std::tie(b.is_matched, b.minus_length, b.halfedge);
  });
  for (const Edge& edge : edges) {
    const HalfedgeId h = edge.halfedge;
    if (auto place = boundary_.place(h)) return {triangle_of(h), h, place};
  }
  throw Error(ErrorCode::kGuarantee,
              "the part of triangle " + std::to_string(tree[0]) +
                  " has an odd number of triangles, " + std::to_string(tree.size()) + ", and " +
                  (edges.empty() ? "no boundary edge" : "no boundary edge with a place") +
                  " for a Steiner point",
              {tree[0]});
}

void QPercolation::append_tree(const Root& root) {
  std::size_t next = order_.size();
  base_[root.triangle] = root.base;
  for (order_.push_back(root.triangle); next < order_.size(); ++next) {
    const TriangleId t = order_[next];
    for (HalfedgeId h = 3 * t; h < 3 * t + 3; ++h) {
      if (forest_.twin[h] == kNone || h == base_[t]) continue;
      base_[forest_.across(h)] = forest_.twin[h];
      order_.push_back(forest_.across(h));
    }
  }
}

void QPercolation::percolate() {
  std::size_t root = roots_.size();
  for (std::size_t i = order_.size(); i-- > 0;) {
    const TriangleId p = order_[i];
    const bool is_root = p == roots_[root - 1].triangle;
    if (is_root) --root;
    reduce(p, is_root ? roots_[root].odd.has_value() : options_.method == TriangleMethod::kQuarter);
  }
}

void QPercolation::reduce(TriangleId p, bool may_stay_fork) {
  const std::array<HalfedgeId, 2> side = {next_halfedge(base_[p]), previous_halfedge(base_[p])};
  if (left_over(side[0]) == Left::kNothing || left_over(side[1]) == Left::kNothing) {
    const HalfedgeId h = left_over(side[0]) == Left::kNothing ? side[1] : side[0];
    if (left_over(h) != Left::kNothing) reduce_pair(h);
    return;  // without children a leaf
  }
  if (left_over(side[0]) == Left::kFork || left_over(side[1]) == Left::kFork) {
    if (try_star(p)) return;
    ++out_.statistics().crowded;
    for (const HalfedgeId h : side) {
      if (left_over(h) != Left::kFork) continue;
      make_leaf(forest_.across(h));
      if (left_over(side[1]) == Left::kFork && try_star(p)) return;
    }
  }
  left_[p] = Left::kFork;
  if (!may_stay_fork) make_leaf(p);
}

/// The child behind h, as a leaf, and its parent make a quad.
void QPercolation::reduce_pair(HalfedgeId h) {
  const TriangleId p = triangle_of(h), child = forest_.across(h);
  if (left_[child] == Left::kFork) make_leaf(child);
  out_.add_quad({mesh_.origin(h), apex_of_leaf(child), mesh_.target(h), mesh_.apex(h)}, p, child);
  left_[p] = left_[child] = Left::kNothing;
}

void QPercolation::make_leaf(TriangleId fork) {
  if (try_star(fork)) return;
  throw Error(ErrorCode::kGuarantee,
              "there is no place for a Steiner point inside triangle " + std::to_string(fork),
              {fork});
}

void QPercolation::gather(HalfedgeId h, TriangleId owner, Star& star) const {
  const TriangleId child = forest_.across(h);
  if (left_[child] == Left::kLeaf) {
    star.spoke[star.spokes++] = {mesh_.origin(h), apex_of_leaf(child), mesh_.target(h), child,
                                 owner};
    return;
  }
  star.hub[star.hubs++] = base_[child];
  // Seen from p the fork's sides come in this order: base_ goes the other way than h.
  for (const HalfedgeId g : {next_halfedge(base_[child]), previous_halfedge(base_[child])}) {
    const TriangleId leaf = forest_.across(g);
    star.spoke[star.spokes++] = {mesh_.origin(g), apex_of_leaf(leaf), mesh_.target(g), leaf, child};
  }
}

/// The star about p, whose two children are leaves or forks; false if there is no place for it.
bool QPercolation::try_star(TriangleId p) {
  Star star;
  star.a = mesh_.origin(base_[p]);
  star.hub[star.hubs++] = base_[p];
  gather(next_halfedge(base_[p]), p, star);
  gather(previous_halfedge(base_[p]), p, star);
  const auto s = place_in_star(star);
  if (!s) return false;
  for (const Spoke& e : std::span(star.spoke).first(star.spokes)) {
    out_.add_quad({*s, e.from, e.apex, e.to}, e.leaf, e.owner);
    left_[e.leaf] = left_[e.owner] = Left::kNothing;
  }
  left_[p] = Left::kLeaf;
  apex_[p] = *s;
  return true;
}

std::optional<VertexId> QPercolation::place_in_star(const Star& star) {
  const std::span hubs = std::span(star.hub).first(star.hubs);
  Vector3 area;
  for (const HalfedgeId h : hubs) {
    area = area + places_.area(mesh_.origin(h), mesh_.target(h), mesh_.apex(h));
  }
  const Chart chart = places_.planar() ? Chart() : Chart(area);
  std::array<Point, 5> polygon;
  std::size_t corners = 0;
  polygon[corners++] = places_.seen(chart, star.a);
  for (const Spoke& e : std::span(star.spoke).first(star.spokes)) {
    polygon[corners++] = places_.seen(chart, e.from);
  }
  const auto s = place_in_kernel(std::span(polygon).first(corners));
  if (!s) return std::nullopt;

  // It lies in p, or else beyond one of p's other sides in that fork.
  HalfedgeId host = hubs[0];
  for (const HalfedgeId h : hubs.subspan(1)) {
    if (kernel::orient(places_.seen(chart, mesh_.origin(h)), places_.seen(chart, mesh_.target(h)),
                       *s) > 0) {
      host = h;
    }
  }
  const std::array<VertexId, 3> parents = {mesh_.origin(host), mesh_.target(host),
                                           mesh_.apex(host)};
  if (places_.planar()) return out_.add_steiner(*s, 0, SteinerKind::kInner, parents);
  const Vector3 place =
      chart.lift(*s, {places_.at(parents[0]), places_.at(parents[1]), places_.at(parents[2])});
  return out_.add_steiner({place.x, place.y}, place.z, SteinerKind::kInner, parents);
}

void QPercolation::close_roots() {
  for (const Root& root : roots_) {
    const TriangleId p = root.triangle;
    if (left_[p] == Left::kNothing) continue;
    const HalfedgeId h = root.base;
    const VertexId a = mesh_.origin(h), b = mesh_.target(h);
    if (left_[p] == Left::kFork) {
      if (try_shared_boundary_point(root)) continue;
      make_leaf(p);
    }
    if (root.odd) {
      out_.add_quad({a, out_.add_steiner(*root.odd, h), b, apex_of_leaf(p)}, p);
    } else {
      out_.add_triangle({a, b, apex_of_leaf(p)}, p);
    }
  }
}

//         c---y           The fork at the root and the boundary point s are two quads: s b y c and
//       ,'|. /            s c x a.
//      x  | /.
//       . |/  .
//        .a-s--b
//
bool QPercolation::try_shared_boundary_point(const Root& root) {
  const HalfedgeId h = root.base;
  const Point s = root.odd->place;
  if (places_.planar()) {
    const Point a = mesh_.points[mesh_.origin(h)], b = mesh_.points[mesh_.target(h)],
                c = mesh_.points[mesh_.apex(h)];
    if (kernel::orient(a, s, c) <= 0 || kernel::orient(s, b, c) <= 0) return false;
  }
  Star star;
  gather(next_halfedge(h), root.triangle, star);
  gather(previous_halfedge(h), root.triangle, star);
  const VertexId vertex = out_.add_steiner(*root.odd, h);
  for (const Spoke& e : std::span(star.spoke).first(star.spokes)) {
    out_.add_quad({vertex, e.from, e.apex, e.to}, e.leaf, e.owner);
  }
  return true;
}

}  // namespace

TriangleResult q_percolate_triangulation(const TriangleMesh& input,
                                         const TriangleOptions& options) {
  return QPercolation(input, options).run();
}

}  // namespace quadloom::quadrangulate
