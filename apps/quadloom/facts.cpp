#include "facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "convex_facts.hpp"
#include "options.hpp"

namespace quadloom::app {
namespace {

std::string grouped(std::size_t n) {
  const std::string digits = std::to_string(n);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

std::size_t count_kind(const std::vector<SteinerPoint>& steiner, SteinerKind kind) {
  return static_cast<std::size_t>(std::count_if(
      steiner.begin(), steiner.end(), [kind](const SteinerPoint& s) { return s.kind == kind; }));
}

// How strictly convex quads came about.
std::string convex_remarks(const MadeMesh& made, const PointOptions& options) {
  const ConvexStatistics& s = *made.convex;
  const std::size_t inside = count_kind(made.steiner, SteinerKind::kInner);
  std::string out = mending_line(s.mending, inside);
  if (s.patches > 0) {
    out += fmt::format("{} kept as paired, {} made of the others: {} added inside\n",
                       counted(s.kept, "quad"), counted(s.patches, "patch", "patches"),
                       inside == 0 ? "no point" : counted(inside, "point"));
  }
  if (made.certificate.triangles > 0 && options.odd_boundary == OddBoundary::kOutside) {
    out += "no place outside the hull would keep it convex: one triangle stays\n";
  }
  return out;
}

}  // namespace

std::string added_points(const std::vector<SteinerPoint>& steiner, const std::string& on_edge,
                         const std::string& on_edges) {
  if (steiner.empty()) return "no point added";
  std::array<std::size_t, 3> count = {};
  for (const SteinerPoint& s : steiner) ++count[static_cast<std::size_t>(s.kind)];
  std::string places;
  for (const SteinerKind kind :
       {SteinerKind::kInner, SteinerKind::kOnEdge, SteinerKind::kOutside}) {
    const std::size_t n = count[static_cast<std::size_t>(kind)];
    if (n == 0) continue;
    if (!places.empty()) places += ", ";
    places += (n == steiner.size() ? "" : grouped(n) + " ") + (kind != SteinerKind::kOnEdge
                                                                   ? name_of(kind)
                                                               : n == 1 ? on_edge
                                                                        : on_edges);
  }
  return fmt::format("{} added {}", counted(steiner.size(), "point"), places);
}

std::string counted(std::size_t n, const std::string& singular) {
  return counted(n, singular, singular + "s");
}

std::string counted(std::size_t n, const std::string& singular, const std::string& plural) {
  return fmt::format("{} {}", grouped(n), n == 1 ? singular : plural);
}

std::string percent(std::size_t n, std::size_t of) {
  if (of == 0) return "-";
  const double share = 100.0 * static_cast<double>(n) / static_cast<double>(of);
  if (n == of) return "100%";
  return fmt::format("{:.1f}%", n == 0 ? 0.0 : std::clamp(share, 0.1, 99.9));
}

std::string facts_line(const MadeMesh& made) {
  const Certificate& c = made.certificate;
  const std::size_t faces = c.faces - c.triangles;
  const std::string on_hull = name_of(SteinerKind::kOnEdge);
  return fmt::format(
      "{}, {}, {}, {}, {} strictly convex, angles {:.4g} to {:.4g} degrees, {:.2f} s",
      counted(made.input_vertices, "point"),
      counted(faces, made.quality.other_faces == 0 ? "quad" : "face"),
      c.triangles == 0 ? "no triangle" : counted(c.triangles, "triangle"),
      added_points(made.steiner, on_hull, on_hull), percent(c.strictly_convex, faces),
      made.quality.min_angle, made.quality.max_angle, made.seconds);
}

std::string remarks(const MadeMesh& made, const PointRun& run) {
  const PointOptions& options = run.making;
  std::string out;
  const std::size_t repeated = made.input_points - made.input_vertices;
  if (repeated > 0) out += fmt::format("{} repeated, merged\n", counted(repeated, "point"));
  if (made.other_z > 0) {
    out += fmt::format("{} of them with another z; the first z was kept\n",
                       counted(made.other_z, "point"));
  }
  if (made.statistics.fell_back_to_spiral) {
    out += fmt::format("the {} method could not finish here; the mesh is the spiral's\n",
                       name_of(options.method));
  }
  if (made.convex) return out + convex_remarks(made, options);
  const bool outside = options.odd_boundary == OddBoundary::kOutside;
  const bool on_edge = count_kind(made.steiner, SteinerKind::kOnEdge) > 0;
  if (outside && on_edge && options.method != PointMethod::kSubdivide) {
    out += "no place outside the hull would keep it convex: the point was added on a hull edge\n";
  }
  return out;
}

std::string verdict_line(const Certificate& certificate, bool with_points) {
  if (certificate.ok()) {
    return with_points ? "certified: every point is a vertex and the faces tile the convex hull "
                         "exactly once"
                       : "certified: the faces tile a convex region exactly once";
  }
  std::string line = "NOT CERTIFIED: " + certificate.sentence;
  if (certificate.culprits.size() > 1) {
    line += " (";
    for (std::size_t i = 0; i < std::min<std::size_t>(8, certificate.culprits.size()); ++i) {
      line += (i > 0 ? ", " : "") + std::to_string(certificate.culprits[i]);
    }
    line += certificate.culprits.size() > 8 ? ", ...)" : ")";
  }
  return line;
}

}  // namespace quadloom::app
