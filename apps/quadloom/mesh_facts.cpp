#include "mesh_facts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convex_facts.hpp"
#include "facts.hpp"
#include "options.hpp"

namespace quadloom::app {
namespace {

constexpr std::size_t kMostLines = 4;
constexpr std::size_t kMostListed = 1000;

bool has_outer_points(const Conversion& made) {
  return std::any_of(made.result.steiner.begin(), made.result.steiner.end(),
                     [](const SteinerPoint& s) { return s.kind == SteinerKind::kOutside; });
}

std::string vertex(const SourceMesh& source, const Conversion& made, VertexId v) {
  const Point p = made.file.mesh.points[v];
  if (source.space != Space::kSurface) return fmt::format("{} ({:.6g}, {:.6g})", v, p.x, p.y);
  const double z = made.file.z.empty() ? 0 : made.file.z[v];
  return fmt::format("{} ({:.6g}, {:.6g}, {:.6g})", v, p.x, p.y, z);
}

// "3 triangles left over by the matching; 1 walk of 14 steps, 1 quad crossed by an added point".
std::string leftover_line(const Conversion& made, const ConversionOptions& options) {
  const TriangleStatistics& s = made.result.statistics;
  if (options.triangles.method != TriangleMethod::kPair) return {};
  if (s.unmatched + s.parted == 0) return "every triangle paired\n";
  std::string line = (s.unmatched == 0 ? "no triangle" : counted(s.unmatched, "triangle")) +
                     " left over by the matching";
  if (s.parted > 0) line += ", " + counted(s.parted, "pair") + " not strictly convex parted again";
  std::string what;
  if (s.walks > 0) {
    what += fmt::format("{}, {} in all", counted(s.walks, "walk"), counted(s.walk_steps, "step"));
  }
  if (s.crossings > 0) {
    what +=
        (what.empty() ? "" : "; ") + counted(s.crossings, "quad") + " crossed by an added point";
  }
  return line + (what.empty() ? "" : ": " + what) + '\n';
}

// Where points were added that are not inside.
std::string place_lines(const SourceMesh& source, const Conversion& made,
                        const ConversionOptions& options) {
  const TriangleMethod method = options.triangles.method;
  if (method != TriangleMethod::kPair && method != TriangleMethod::kQPercolate &&
      method != TriangleMethod::kQuarter) {
    return {};  // many, and where they must be
  }
  std::string out;
  std::size_t lines = 0;
  for (const SteinerPoint& s : made.result.steiner) {
    if (s.kind == SteinerKind::kInner || s.parents[1] == kNone) continue;
    if (++lines > kMostLines) continue;
    out += fmt::format("1 point added {} the edge from vertex {} to {} (part with an odd border)\n",
                       s.kind == SteinerKind::kOnEdge ? "on" : "outside",
                       vertex(source, made, s.parents[0]), vertex(source, made, s.parents[1]));
  }
  if (lines > kMostLines) {
    out += fmt::format("{} more on edges (--report names them)\n",
                       counted(lines - kMostLines, "point"));
  }
  for (std::size_t t = 0; t < std::min(kMostLines, made.result.mesh.triangle_count()); ++t) {
    const VertexId* v = &made.result.mesh.tri_vertex[3 * t];
    out += fmt::format("1 triangle stays: the vertices {}, {} and {}\n", vertex(source, made, v[0]),
                       vertex(source, made, v[1]), vertex(source, made, v[2]));
  }
  if (made.result.mesh.triangle_count() > kMostLines) {
    out += fmt::format("{} more stay\n",
                       counted(made.result.mesh.triangle_count() - kMostLines, "triangle"));
  }
  return out;
}

const char* name_of(Space space) { return space == Space::kSurface ? "surface" : "plane"; }

const char* kind_of(const SourceMesh& source) {
  return source.polygons ? "polygons" : source.space == Space::kSurface ? "surface" : "planar mesh";
}

Json added_json(const Conversion& made) {
  Json added = Json::array();
  for (const SteinerPoint& s : made.result.steiner) {
    if (added.size() == kMostListed) break;
    const Point p = made.file.mesh.points[s.vertex];
    Json parents = Json::array();
    for (const VertexId v : s.parents) {
      if (v != kNone) parents.push_back(v);
    }
    Json point = {{"vertex", s.vertex},
                  {"where", s.kind == SteinerKind::kOnEdge ? "on an edge" : app::name_of(s.kind)},
                  {"x", p.x},
                  {"y", p.y}};
    if (!made.file.z.empty()) point["z"] = made.file.z[s.vertex];
    point["made_from"] = parents;
    added.push_back(std::move(point));
  }
  return added;
}

// Inner points but for those of the pairing, which has one for each crossing.
std::size_t added_by_mending(const Conversion& made) {
  const auto inner =
      std::count_if(made.result.steiner.begin(), made.result.steiner.end(),
                    [](const SteinerPoint& s) { return s.kind == SteinerKind::kInner; });
  const std::size_t crossings = made.result.statistics.crossings;
  return static_cast<std::size_t>(inner) - std::min(static_cast<std::size_t>(inner), crossings);
}

Json statistics_json(const TriangleStatistics& s) {
  return {
      {"triangles", s.triangles}, {"boundary_edges", s.boundary_edges}, {"parts", s.parts},
      {"odd_parts", s.odd_parts}, {"unmatched", s.unmatched},           {"parted", s.parted},
      {"walks", s.walks},         {"walk_steps", s.walk_steps},         {"crossings", s.crossings},
      {"crowded", s.crowded},     {"weight_gap", s.weight_gap}};
}

}  // namespace

std::string conversion_facts(const SourceMesh& source, const Conversion& made,
                             const ConversionOptions& options) {
  const Quality& q = made.quality;
  const bool all_triangles = source.face_count == source.triangles.mesh.triangle_count();
  const std::string points = added_points(made.result.steiner, "on an edge", "on edges");
  return fmt::format(
             "{} and {}: {}, {}, {}, {} strictly convex, angles {:.4g} to {:.4g} degrees, {:.2f} "
             "s\n",
             counted(made.result.input_vertices, "point"),
             counted(source.face_count, all_triangles ? "triangle" : "face"),
             counted(q.quads, "quad"),
             q.triangles == 0 ? "no triangle" : counted(q.triangles, "triangle"), points,
             percent(q.strictly_convex, q.quads), q.min_angle, q.max_angle, made.convert_seconds) +
         leftover_line(made, options) + place_lines(source, made, options);
}

std::string conversion_remarks(const SourceMesh& source, const Conversion& made,
                               const ConversionOptions& options) {
  std::string out;
  for (const std::string& remark : source.remarks) out += remark + '\n';
  if (source.kept_edges > 0) out += counted(source.kept_edges, "inner edge") + " kept\n";
  if (made.mending) out += mending_line(*made.mending, added_by_mending(made));
  const Leftover leftover = options.triangles.leftover;
  if (!made.result.barrier.empty() &&
      (leftover == Leftover::kTriangle || leftover == Leftover::kSteiner)) {
    const Witness witness = find_witness(source, made.result.barrier,
                                         made.result.statistics.unmatched, options.triangles);
    out += "no perfect matching: " + in_words(witness, source.source_face) + '\n';
  }
  return out;
}

std::string source_verdict(const Certificate& certificate, const SourceMesh& source,
                           bool with_outer_points) {
  if (!certificate.ok()) return verdict_line(certificate, true);
  if (source.space == Space::kSurface) {
    return "certified: every vertex stays, no edge is in three faces, and the faces hang together "
           "as "
           "the source's";
  }
  const char* const region = source.polygons ? "the polygons" : "the region of the source";
  return fmt::format("certified: every {} and the faces tile {}{} exactly once",
                     source.polygons ? "corner and point is a vertex" : "vertex stays", region,
                     with_outer_points ? " and the triangles at the points outside" : "");
}

std::string conversion_verdict(const SourceMesh& source, const Conversion& made) {
  if (made.certificate.ok() && !made.lost.empty()) return "NOT CERTIFIED: " + made.lost;
  return source_verdict(made.certificate, source, has_outer_points(made));
}

Json conversion_json(const SourceMesh& source, const Conversion& made,
                     const ConversionOptions& options) {
  const TriangleOptions& o = options.triangles;
  Json json = {{"kind", kind_of(source)},
               {"space", name_of(source.space)},
               {"method", app::name_of(o.method)}};
  if (o.method == TriangleMethod::kPair) {
    json["leftover"] = app::name_of(o.leftover);
    json["pairs"] = app::name_of(o.pairs);
    json["weight"] = options.weight;
    json["matching"] = app::name_of(o.effort);
    json["min_quality"] = o.min_quality;
  }
  json["odd_boundary"] = app::name_of(o.odd_boundary);
  json["source"] = {{"points", made.result.input_vertices},
                    {"faces", source.face_count},
                    {"kept_edges", source.kept_edges},
                    {"remarks", source.remarks}};
  if (source.polygons) {
    json["source"]["polygons"] = source.polygons->polygons.size();
  } else if (source.components > 0) {  // a mesh, no segments
    json["source"]["components"] = source.components;
    json["source"]["boundary_cycles"] = source.boundary_cycles;
  }
  json["statistics"] = statistics_json(made.result.statistics);
  json["convex"] = options.convex;
  if (options.convex) json["seed"] = options.seed;
  if (made.mending) json["mending"] = mending_json(*made.mending);
  if (options.convex) json["not_convex"] = not_convex_json(made.file.mesh, made.not_convex);
  json["triangles_left"] = made.result.mesh.triangle_count();
  json["added_points"] = made.result.steiner.size();
  json["added_points_listed"] = added_json(made);
  json["barrier"] = made.result.barrier.size();
  json["certificate"] = certificate_json(made.certificate);
  json["quality"] = quality_json(made.quality);
  const Quality& q = made.quality;  // the corner that is farthest from a right angle
  json["worst_angle_degrees"] = q.max_angle - 90 > 90 - q.min_angle ? q.max_angle : q.min_angle;
  json["seconds"] = {{"read", source.read_seconds},
                     {"connect", source.connect_seconds},
                     {"convert", made.convert_seconds},
                     {"certify", made.certify_seconds}};
  return json;
}

}  // namespace quadloom::app
