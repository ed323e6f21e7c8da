// The case analysis of Bremner, Hurtado, Ramaswami and Sacristan, "Small strictly convex quadrilateral
// meshes of point sets", theorem 3.2: one function a case, named as in the paper. Corners are a ... f,
// counter-clockwise, the pattern's first letter at a; flat corners are reflex. L(p, q) is the open
// half-plane left of p -> q, wedge(v) = L(v-, v) and L(v, v+).
//
//   case      first Steiner point          then        points in all
//   rccccc    cuts b, in wedge(a)          rccccc-1    2
//   rcrccc    cuts b, wedge(a), wedge(c)   rccccc      3
//   rrcccc    cuts f, wedge(a), L(b, d)    rcrccc-1    2
//   rccrcc    cuts f, wedge(a), L(b, d)    rcrccc-1    2
//   rcrcrc    cuts f, wedge(a), wedge(e)   rccrcc      3
//   rrcrcc    cuts f, kernel, L(b, d)      rcrcrc-1    2
//             cuts e, wedge(e), wedge(d)   rrcrcc      3
//   rrrccc    cuts f, wedge(a), L(b, e)    rrcrcc      3
//
// The half-planes in which the quad that is cut off is convex (among them R(a, e) for a cut of f) are
// added by the search, hexagon.cpp. Differs from the paper: it assumes one of several symmetric
// situations "without loss of generality"; here all rotations and reflections are tried. Where a corner
// beside the cut is convex and has to stay so, its wedge is added, which in the paper is the wedge's
// part inside of the polygon.
#include "convex/hexagon_cases.hpp"

#include <string_view>

namespace quadloom::convex {
namespace {

/// The hexagon from one corner on, in one of the two directions.
class View {
 public:
  View(const Hexagon& hexagon, int start, bool reflected)
      : hexagon_(hexagon), start_(start), reflected_(reflected) {}

  int index(char letter) const {
    const int k = letter - 'a';
    return ((reflected_ ? start_ - k : start_ + k) + 6) % 6;
  }
  /// In the reflected plane left is right.
  HalfPlane left(char p, char q) const {
    const Point from = hexagon_[index(p)].at, to = hexagon_[index(q)].at;
    return reflected_ ? HalfPlane{to, from} : HalfPlane{from, to};
  }

 private:
  const Hexagon& hexagon_;
  int start_;
  bool reflected_;
};

using Case = void (*)(const View&, Cuts&);

/// Case rccccc-2: d is beside wedge(a) and a hides c from e. abcs is cut off; d and f see each other.
void rccccc(const View& v, Cuts& cuts) {
  cuts.push_back({v.index('b'), {v.left('f', 'a'), v.left('c', 'd')}});
}

/// Case rcrccc-3: a hides c from e. Lemma 3.7: wedge(a) and wedge(c) meet left of a -> c.
void rcrccc(const View& v, Cuts& cuts) {
  cuts.push_back({v.index('b'), {v.left('f', 'a'), v.left('c', 'd')}});
}

/// Case rrcccc-2: what is left has the reflex corners s and b, which both see d.
void rrcccc(const View& v, Cuts& cuts) {
  cuts.push_back({v.index('f'), {v.left('a', 'b'), v.left('d', 'e'), v.left('b', 'd')}});
}

/// Case rccrcc-2: what is left has the reflex corners s and d, which both see b.
void rccrcc(const View& v, Cuts& cuts) {
  cuts.push_back({v.index('f'), {v.left('a', 'b'), v.left('d', 'e'), v.left('b', 'd')}});
}

/// Case rcrcrc-3: what is left has the reflex corners s and c, opposite to each other.
void rcrcrc(const View& v, Cuts& cuts) {
  cuts.push_back({v.index('f'), {v.left('a', 'b'), v.left('d', 'e')}});
}

/// Case rrcrcc-2, e sees a: s in the kernel, and s, b, d see each other. Case rrcrcc-3: from s, which
/// takes the place of e, a and b can be seen.
void rrcrcc(const View& v, Cuts& cuts) {
  cuts.push_back(
      {v.index('f'),
       {v.left('a', 'b'), v.left('b', 'c'), v.left('c', 'd'), v.left('d', 'e'), v.left('b', 'd')}});
  cuts.push_back({v.index('e'), {v.left('c', 'd'), v.left('f', 'a')}});
}

/// Case rrrccc-3: e sees b and c in what is left.
void rrrccc(const View& v, Cuts& cuts) {
  cuts.push_back({v.index('f'), {v.left('a', 'b'), v.left('d', 'e'), v.left('b', 'e')}});
}

void cccccc(const View& /*v*/, Cuts& /*cuts*/) {}  // a diagonal does

struct Pattern {
  const char* letters;
  Case cuts;
};

constexpr std::array<Pattern, 8> kPatterns = {{{"cccccc", cccccc},
                                               {"rccccc", rccccc},
                                               {"rcrccc", rcrccc},
                                               {"rrcccc", rrcccc},
                                               {"rccrcc", rccrcc},
                                               {"rcrcrc", rcrcrc},
                                               {"rrcrcc", rrcrcc},
                                               {"rrrccc", rrrccc}}};

std::array<bool, 6> reflex_corners(const Hexagon& h) {
  std::array<bool, 6> out{};
  for (std::size_t i = 0; i < 6; ++i) out[i] = !turns_left(h[(i + 5) % 6], h[i], h[(i + 1) % 6]);
  return out;
}

/// Calls use(pattern, view) for every view of the hexagon that fits a pattern.
template <class Use>
void for_each_fit(const Hexagon& h, const Use& use) {
  const std::array<bool, 6> reflex = reflex_corners(h);
  for (const Pattern& pattern : kPatterns) {
    for (int view = 0; view < 12; ++view) {
      const View v(h, view / 2, view % 2 != 0);
      bool fits = true;
      for (int k = 0; k < 6 && fits; ++k) {
        fits = reflex[v.index(static_cast<char>('a' + k))] == (pattern.letters[k] == 'r');
      }
      if (fits) use(pattern, v);
    }
  }
}

}  // namespace

const char* pattern_of(const Hexagon& hexagon) {
  const char* out = nullptr;
  for_each_fit(hexagon, [&](const Pattern& pattern, const View&) { out = pattern.letters; });
  return out;
}

Cuts first_cuts(const Hexagon& hexagon) {
  Cuts cuts;
  for_each_fit(hexagon, [&](const Pattern& pattern, const View& v) { pattern.cuts(v, cuts); });
  return cuts;
}

}  // namespace quadloom::convex
