// quadloom quadrangulate of meshes and polygons.
#include <fmt/format.h>

#include <cstdio>

#include "convex_facts.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "mesh_facts.hpp"
#include "progress_bar.hpp"
#include "quadrangulate.hpp"
#include "timer.hpp"

namespace quadloom::app {
namespace {

Conversion convert(const SourceMesh& source, const ConversionOptions& options) {
  ProgressBar bar;
  ConversionOptions converting = options;
  converting.triangles.progress = bar.callback();
  return convert_mesh(source, converting);
}

void write_picture(const SourceMesh& source, const Conversion& made, const MeshRun& run,
                   const std::string& path) {
  if (path.empty()) return;
  io::DrawOptions options;
  options.title = fmt::format("{}: {}, {}", short_name(run.reading.path),
                              counted(source.triangles.mesh.triangle_count(), "triangle"),
                              name_of(run.conversion.triangles.method));
  if (run.conversion.convex && made.not_convex.empty()) options.title += ", strictly convex";
  for (const SteinerPoint& s : made.result.steiner) options.steiner.push_back(s.vertex);
  io::draw_mesh(path, made.file, options);
}

void write_report(const SourceMesh& source, const Conversion& made, const MeshRun& run,
                  const OutputOptions& output, double write_seconds) {
  if (output.report.empty()) return;
  Json json = report_head("quadrangulate", run.reading.path, source.input_count);
  json["output"] = output.mesh;
  json["mesh"] = conversion_json(source, made, run.conversion);
  json["mesh"]["seconds"]["write"] = write_seconds;
  io::write_text(output.report, json.dump(2) + "\n");
}

void tell(const SourceMesh& source, const Conversion& made, const MeshRun& run,
          const OutputOptions& output) {
  if (output.quiet && made.ok()) return;
  std::FILE* to = output.mesh == "-" || output.report == "-" || !made.ok() ? stderr : stdout;
  fmt::print(to, "{}{}{}\n", conversion_facts(source, made, run.conversion),
             conversion_remarks(source, made, run.conversion), conversion_verdict(source, made));
}

// The triangles, with those that stand in the way of a perfect matching in colours.
void draw_witness(const SourceMesh& source, const Witness& witness, const MeshRun& run,
                  const std::string& path) {
  if (path.empty()) return;
  io::MeshFile file;
  file.mesh = to_polygon_mesh(source.triangles.mesh);
  io::DrawOptions options;
  options.colour = io::ColourBy::kGroup;
  options.group = witness.group;
  options.group_names = {"other triangles", "barrier", "in odd parts"};
  options.title = fmt::format("{}: no perfect matching, {} left", short_name(run.reading.path),
                              counted(witness.unmatched, "triangle"));
  io::draw_mesh(path, file, options);
}

// Leftover::kError: says and shows why not all triangles can be paired.
int explain(const SourceMesh& source, const MeshRun& run, const OutputOptions& output,
            const Error& error) {
  const Witness witness = explain_leftover(source, run.conversion);
  if (witness.unmatched == 0) throw Error(error);
  draw_witness(source, witness, run, output.picture);
  fmt::print(stderr, "quadloom: no perfect matching: {}\n", in_words(witness, source.source_face));
  return kGuaranteeMissed;
}

// A planar mesh whose own faces overlap has no conversion that tiles its region.
void blame_source(const SourceMesh& source) {
  if (source.space == Space::kSurface || source.polygons) return;
  CertifyOptions triangles;
  triangles.corners = 3;
  const Certificate verdict =
      certify_mesh(to_polygon_mesh(source.triangles.mesh), source.faces, triangles);
  if (verdict.ok()) return;
  throw Error(ErrorCode::kBadMesh, "the faces of the mesh overlap: " + verdict.sentence,
              verdict.culprits);
}

}  // namespace

int quadrangulate_mesh_file(FoundInput input, MeshRun run, const OutputOptions& output) {
  const SourceMesh source = read_source(run.reading, std::move(input));
  Conversion made;
  try {
    made = convert(source, run.conversion);
  } catch (const Error& e) {
    const TriangleOptions& o = run.conversion.triangles;
    if (e.code() != ErrorCode::kGuarantee || o.method != TriangleMethod::kPair ||
        o.leftover != Leftover::kError) {
      throw;
    }
    return explain(source, run, output, e);
  }
  if (!made.ok()) {  // nothing is written that the check refuses
    blame_source(source);
    tell(source, made, run, output);
    return kCheckFailed;
  }
  const Timer writing;
  io::write_mesh(output.mesh, made.file, output.mesh_format);
  const double write_seconds = writing.seconds();
  write_picture(source, made, run, output.picture);
  write_report(source, made, run, output, write_seconds);
  tell(source, made, run, output);
  return tell_not_convex(made.file.mesh, made.not_convex);
}

}  // namespace quadloom::app
