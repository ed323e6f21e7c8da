#include "report.hpp"

#include "convex_facts.hpp"
#include "options.hpp"
#include "quadloom/version.hpp"

namespace quadloom::app {

Json report_head(const std::string& verb, const std::string& input, std::size_t points) {
  return {{"program", "quadloom"},
          {"version", kVersion},
          {"command", verb},
          {"input", {{"path", input}, {"points", points}}}};
}

Json certificate_json(const Certificate& certificate) {
  Json json = {{"ok", certificate.ok()},
               {"points", certificate.points},
               {"faces", certificate.faces},
               {"triangles", certificate.triangles},
               {"boundary_vertices", certificate.boundary},
               {"added_points", certificate.steiner},
               {"strictly_convex", certificate.strictly_convex},
               {"flat_cornered", certificate.flat_cornered},
               {"non_convex", certificate.non_convex}};
  if (!certificate.ok()) {
    json["fault"] = certificate.sentence;
    json["culprits"] = certificate.culprits;
  }
  return json;
}

Json quality_json(const Quality& q) {
  return {{"quads", q.quads},
          {"triangles", q.triangles},
          {"other_faces", q.other_faces},
          {"strictly_convex", q.strictly_convex},
          {"flat_cornered", q.flat_cornered},
          {"non_convex", q.non_convex},
          {"min_angle_degrees", q.min_angle},
          {"max_angle_degrees", q.max_angle},
          {"angle_histogram_10_degrees", q.angle_histogram},
          {"mean_shape", q.mean_shape},
          {"min_shape", q.min_shape},
          {"shape_histogram_tenths", q.shape_histogram},
          {"median_aspect", q.median_aspect},
          {"max_aspect", q.max_aspect},
          {"min_edge", q.min_edge},
          {"mean_edge", q.mean_edge},
          {"max_edge", q.max_edge}};
}

Json mesh_json(const MadeMesh& made, const PointRun& run) {
  const PointOptions& options = run.making;
  const PointStatistics& s = made.statistics;
  Json added = Json::array();
  constexpr std::size_t kMostListed = 1000;
  for (std::size_t i = 0; i < std::min(kMostListed, made.steiner.size()); ++i) {
    const Point p = made.file.mesh.points[made.steiner[i].vertex];
    added.push_back({{"vertex", made.steiner[i].vertex},
                     {"where", name_of(made.steiner[i].kind)},
                     {"x", p.x},
                     {"y", p.y}});
  }
  Json json = {{"method", method_name(run)},
               {"k", run.k},
               {"convex", run.convex},
               {"exact", run.exact},
               {"odd_boundary", name_of(options.odd_boundary)},
               {"seed", options.seed},
               {"distinct_points", made.input_vertices},
               {"hull_points", s.hull_points},
               {"added_points", made.steiner.size()},
               {"added_points_listed", added},
               {"unmatched_greedy", s.unmatched_greedy},
               {"walks", s.walks},
               {"walk_steps", s.walk_steps},
               {"fell_back_to_spiral", s.fell_back_to_spiral},
               {"total_edge_length", made.total_edge_length},
               {"certificate", certificate_json(made.certificate)},
               {"quality", quality_json(made.quality)},
               {"seconds", {{"mesh", made.seconds}, {"certify", made.certify_seconds}}}};
  if (made.convex) json["convex_statistics"] = convex_json(*made.convex);
  if (run.convex) json["not_convex"] = not_convex_json(made.file.mesh, made.not_convex);
  return json;
}

}  // namespace quadloom::app
