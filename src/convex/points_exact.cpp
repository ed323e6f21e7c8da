// What strictly convex quads there are without Steiner points, by exhaustive search of a small set.
// (Whether a set has a strictly convex quadrangulation is open in general: Bremner, Hurtado, Ramaswami
// and Sacristan, section 1.)
//
//   1. EmptyFaces  every quad and triangle that can be a face
//   2. best        of a region, a simple polygon of points: one side must have a face on it, so all
//                  faces there are tried. What each leaves over are at most three smaller regions
//                  (cut_off), which have nothing to do with each other: their best numbers add up.
//                  Regions are remembered. The side is the one after the lexicographically first
//                  corner, so that the search goes from left to right and meets few different ones
//   3. collect     the faces of a best solution from what was remembered
//
//         a ------ d . . .            The face a b c d on the side a -> b of the region. Where c and d
//         |        |      .           are corners of the region as well, it falls apart there: d ... a,
//         |  face  |       .          c ... d, b ... c, each closed by a side of the face. A part of two
//         |        |       .          corners is a side that was the region's already.
//         b ------ c . . .
//
// All quadrangulations of a region have as many quads (Euler), and an odd number of corners stands for
// the one triangle; so a face that leaves odd parts without having a triangle for them is not tried
// further. First the search is for strictly convex quads alone, which are few. If they are not enough,
// again over all quads, strictly convex ones counted.
//
// Why a face fits a region: its sides and its inside have no point but its corners. If no side of the
// region crosses it (EmptyFace::apart), the region's boundary does not meet its inside, which is in the
// region beside a -> b and hence altogether.
//
// Degenerate input: flat corners are allowed to quads that need not be convex; segments with a point
// inside are no sides. Depth: the number of faces, below 2 n <= 40. Cost: exponential; the work limit
// counts faces tried.
#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <boost/container_hash/hash.hpp>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "convex/empty_faces.hpp"
#include "quadloom/convex.hpp"
#include "quadrangulate/point_input.hpp"

namespace quadloom {
namespace convex {
namespace {

using Region = boost::container::static_vector<std::uint8_t, kMostExactPoints + 2>;
using Parts = boost::container::static_vector<Region, 3>;

/// A region that starts with its smallest corner, counter-clockwise: five bits a corner.
struct Word {
  std::uint64_t low = 0, high = 0;
  friend bool operator==(const Word&, const Word&) = default;
};

struct WordHash {
  std::size_t operator()(const Word& word) const {
    std::size_t seed = 0;
    boost::hash_combine(seed, word.low);
    boost::hash_combine(seed, word.high);
    return seed;
  }
};

Word word_of(const Region& region) {
  static_assert(kMostExactPoints < 32 && 5 * kMostExactPoints <= 128);
  Word word;
  for (const std::uint8_t corner : region) {
    word.high = word.high << 5 | word.low >> 59;
    word.low = word.low << 5 | (corner + 1U);
  }
  return word;
}

void add_part(Region part, Parts& parts) {
  if (part.size() == 2) return;
  std::rotate(part.begin(), std::min_element(part.begin(), part.end()), part.end());
  parts.push_back(std::move(part));
}

/// What a face with the side region[0] -> region[1] leaves of the region.
Parts cut_off(const Region& region, const EmptyFace& face) {
  Parts parts;
  Region open = {
      region[1]};  // the part that the walk along the region is in, and what the face adds
  std::size_t at = 1;
  for (std::size_t i = 2; i <= face.size(); ++i) {
    const std::uint8_t corner = face.corner[i % face.size()];
    const auto found =
        i == face.size() ? region.end() : std::find(region.begin() + 2, region.end(), corner);
    if (i < face.size() && found == region.end()) continue;  // inside the region
    const auto stop = static_cast<std::size_t>(found - region.begin());
    for (++at; at < stop; ++at) open.push_back(region[at]);
    open.push_back(corner);
    // Back along the face to where the part began.
    for (std::size_t k = i - 1; face.corner[k] != open.front(); --k) open.push_back(face.corner[k]);
    add_part(std::move(open), parts);
    open = {corner};
    at = stop;
  }
  return parts;
}

class RegionSearch {
 public:
  struct Best {
    int convex = -1;  // strictly convex quads; -1: no quadrangulation
    int quads = 0;
    const EmptyFace* face = nullptr;  // on the first side
  };

  RegionSearch(const EmptyFaces& faces, bool convex_only, std::uint64_t work,
               const ExactConvexOptions& options)
      : faces_(faces), convex_only_(convex_only), work_(work), options_(options) {}

  bool out_of_work() const { return out_of_work_; }
  std::uint64_t work() const { return work_; }

  /// Not to be used if the work ran out.
  Best best(const Region& region) {
    const Word word = word_of(region);
    if (const auto known = best_.find(word); known != best_.end()) return known->second;
    EdgeSet sides;
    for (std::size_t i = 0; i < region.size(); ++i) {
      sides.set(EmptyFaces::edge(region[i], region[(i + 1) % region.size()]));
    }
    Best found;
    for (const EmptyFace& face : faces_.at(region[0], region[1])) {
      if (convex_only_ && !face.convex && !face.triangle) continue;
      if (!count_work()) return {};
      if ((face.apart & sides).any()) continue;
      const Best with = best_with(region, face);
      if (out_of_work_) return {};
      if (with.convex > found.convex) found = with;
      if (found.face != nullptr && (convex_only_ || found.convex == found.quads)) break;
    }
    best_.emplace(word, found);
    return found;
  }

  void collect(const Region& whole, Quadrangulation& mesh, std::span<const VertexId> name) const {
    std::vector<Region> stack = {whole};
    while (!stack.empty()) {
      const Region region = stack.back();
      stack.pop_back();
      const EmptyFace& face = *best_.at(word_of(region)).face;
      auto& corners = face.triangle ? mesh.tri_vertex : mesh.quad_vertex;
      for (std::size_t i = 0; i < face.size(); ++i) corners.push_back(name[face.corner[i]]);
      const Parts parts = cut_off(region, face);
      stack.insert(stack.end(), parts.begin(), parts.end());
    }
  }

 private:
  Best best_with(const Region& region, const EmptyFace& face) {
    const bool triangle_due = region.size() % 2 == 1 && !face.triangle;
    if (face.triangle && region.size() % 2 == 0) return {};
    const Parts parts = cut_off(region, face);
    const auto odd = std::count_if(parts.begin(), parts.end(),
                                   [](const Region& part) { return part.size() % 2 == 1; });
    if (odd != (triangle_due ? 1 : 0)) return {};
    Best sum = {face.convex ? 1 : 0, face.triangle ? 0 : 1, &face};
    for (const Region& part : parts) {
      const Best of_part = best(part);
      if (of_part.convex < 0) return {};
      sum.convex += of_part.convex;
      sum.quads += of_part.quads;
    }
    return sum;
  }

  bool count_work() {
    if (work_ >= options_.work_at_most) out_of_work_ = true;
    if (out_of_work_) return false;
    if (++work_ % (1U << 16) == 0) {
      report_progress(options_.progress, "exhaustive search",
                      static_cast<double>(work_) / static_cast<double>(options_.work_at_most));
    }
    return true;
  }

  const EmptyFaces& faces_;
  bool convex_only_;
  std::uint64_t work_;
  const ExactConvexOptions& options_;
  bool out_of_work_ = false;
  std::unordered_map<Word, Best, WordHash> best_;
};

void check_size(std::size_t n, const ExactConvexOptions& options) {
  if (options.points_at_most > kMostExactPoints) {
    throw Error(ErrorCode::kBadOption, "the exhaustive search takes at most " +
                                           std::to_string(kMostExactPoints) + " points");
  }
  if (n > options.points_at_most) {
    throw Error(ErrorCode::kBadOption, std::to_string(n) +
                                           " distinct points; the exhaustive search is for " +
                                           std::to_string(options.points_at_most) + " at most");
  }
}

}  // namespace
}  // namespace convex

ExactConvexResult exact_convex_quadrangulation(std::span<const Point> input,
                                               const ExactConvexOptions& options) {
  using namespace convex;
  DistinctPoints distinct = quadrangulate::points_of_the_plane(input);
  const std::vector<Point>& points = distinct.points;
  check_size(points.size(), options);

  std::vector<VertexId> name(points.size());  // in lexicographic order
  std::iota(name.begin(), name.end(), VertexId{0});
  std::sort(name.begin(), name.end(),
            [&](VertexId a, VertexId b) { return lex_less(points[a], points[b]); });
  std::vector<Point> sorted;
  for (const VertexId v : name) sorted.push_back(points[v]);
  Region hull;
  for (const VertexId v : convex_hull(sorted)) hull.push_back(static_cast<std::uint8_t>(v));

  ExactConvexResult result;
  result.hull_points = hull.size();
  result.quads = points.size() - 1 - (hull.size() + 1) / 2;
  result.input_to_vertex = std::move(distinct.input_to_vertex);
  report_progress(options.progress, "exhaustive search", 0);
  const EmptyFaces faces(sorted);
  for (const bool convex_only : {true, false}) {
    RegionSearch search(faces, convex_only, result.work, options);
    const RegionSearch::Best best = search.best(hull);
    result.work = search.work();
    if (search.out_of_work()) break;
    if (convex_only) result.convex = best.convex < 0 ? Answer::kNo : Answer::kYes;
    if (best.convex < 0) continue;
    result.most_convex = static_cast<std::size_t>(best.convex);
    result.mesh.points = points;
    search.collect(hull, result.mesh, name);
    break;
  }
  return result;
}

}  // namespace quadloom
