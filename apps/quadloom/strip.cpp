// quadloom strip, quadloom unstrip: triangles to strips of vertices and back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include "choice.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "options.hpp"
#include "progress_bar.hpp"
#include "quadloom/strips.hpp"
#include "timer.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

const std::map<std::string, StripEncoding> kEncodings = {
    {"swap", StripEncoding::kSwap},
    {"repeat", StripEncoding::kRepeat},
    {"restart", StripEncoding::kRestart},
};
const std::map<std::string, PathEffort> kEfforts = {
    {"fast", PathEffort::kFast},
    {"standard", PathEffort::kStandard},
    {"thorough", PathEffort::kThorough},
};

struct StripVerbOptions {
  std::string mesh, format, output, picture;
  StripOptions strips;
};

struct UnstripVerbOptions {
  std::string strips, output, output_format;
};

// ---- The mesh. ----

struct Source {
  Triangulation triangles;
  std::vector<double> z;
  std::string remark;
};

/// Triangles as the file has them; if there are quads, all faces by connect_triangles.
Source read_triangles(const std::string& path, const std::string& format) {
  io::MeshFile file = io::read_mesh(path, format);
  const PolygonMesh& mesh = file.mesh;
  std::size_t quads = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() > 4) {
      throw Error(ErrorCode::kBadMesh,
                  fmt::format("face {} has {} corners: strips are made of triangles and of quads "
                              "cut in two",
                              f, mesh.face(f).size()),
                  {f});
    }
    quads += mesh.face(f).size() == 4;
  }
  if (quads == 0) {
    return {triangles_with_twins(std::move(file.mesh.points), std::move(file.mesh.face_vertex)),
            std::move(file.z), ""};
  }
  ConnectedMesh connected = connect_triangles(mesh, file.z);
  return {std::move(connected.triangles.mesh), std::move(file.z),
          counted(quads, "quad") + " cut into two triangles each\n"};
}

// ---- The picture. ----

Point middle(std::span<const Point> points, std::span<const VertexId> corners) {
  Point sum;
  for (const VertexId v : corners) {
    sum.x += points[v].x / static_cast<double>(corners.size());
    sum.y += points[v].y / static_cast<double>(corners.size());
  }
  return sum;
}

/// A line for each strip, from triangle to triangle over the edges between them.
std::vector<io::Polyline> lines_of(std::span<const Point> points,
                                   std::span<const VertexId> triangles) {
  std::vector<io::Polyline> lines;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const auto corners = triangles.subspan(i, 3);
    std::vector<VertexId> shared;
    if (i > 0) {
      const auto before = triangles.subspan(i - 3, 3);
      std::copy_if(corners.begin(), corners.end(), std::back_inserter(shared), [&](VertexId v) {
        return std::find(before.begin(), before.end(), v) != before.end();
      });
    }
    if (shared.size() == 2) {
      lines.back().points.push_back(middle(points, shared));
    } else {
      // Steps of the golden ratio: neighbours in the order get colours far apart.
      const double turn = 0.6180339887498949 * static_cast<double>(lines.size() + 1);
      lines.push_back({{}, false, turn - std::floor(turn)});
    }
    lines.back().points.push_back(middle(points, corners));
  }
  return lines;
}

void draw(const StripVerbOptions& o, const Source& source, std::span<const VertexId> triangles,
          std::size_t strips) {
  if (o.picture.empty()) return;
  io::MeshFile file;
  file.mesh = to_polygon_mesh(source.triangles);
  file.z = source.z;
  io::DrawOptions drawing;
  drawing.colour = io::ColourBy::kNone;
  drawing.overlay = lines_of(source.triangles.points, triangles);
  drawing.title =
      fmt::format("{}: {} in {}", short_name(o.mesh),
                  counted(source.triangles.triangle_count(), "triangle"), counted(strips, "strip"));
  io::draw_mesh(o.picture, file, drawing);
}

// ---- The verbs. ----

double per_triangle(const StripResult& result) {
  return result.triangles == 0 ? 0
                               : static_cast<double>(result.code.index.size()) /
                                     static_cast<double>(result.triangles);
}

/// The indices a triangle of every encoding, that of the result known.
std::string comparison(const Source& source, const StripVerbOptions& o, const StripResult& made) {
  std::string line = "indices a triangle:";
  for (const auto& [name, encoding] : kEncodings) {
    StripOptions options = o.strips;
    options.encoding = encoding;
    const double figure = encoding == o.strips.encoding
                              ? per_triangle(made)
                              : per_triangle(encode_strips(source.triangles, options));
    line += fmt::format("{} {} {:.4f}{}", line.back() == ':' ? "" : ",", name, figure,
                        encoding == StripEncoding::kSwap ? " and a bit an index" : "");
  }
  return line + '\n';
}

int strip(const StripVerbOptions& o) {
  require_writable(o.output);
  require_picture(o.picture);
  require_different({o.output, o.picture});
  const Source source = read_triangles(o.mesh, o.format);
  ProgressBar bar;
  StripOptions options = o.strips;
  options.progress = bar.callback();
  const Timer timer;
  StripResult made = encode_strips(source.triangles, options);
  const double seconds = timer.seconds();
  const std::vector<VertexId> decoded = decode_strips(made.code);
  if (!same_triangles(decoded, source.triangles.tri_vertex)) {
    fmt::print(stderr, "NOT CERTIFIED: the strips decode to other triangles\n");
    return kCheckFailed;
  }
  const std::string compared = comparison(source, o, made);
  const io::StripFile file{source.triangles.points, source.z, std::move(made.code)};
  io::write_strips(o.output, file);
  draw(o, source, decoded, made.strips);
  fmt::print(o.output == "-" ? stderr : stdout,
             "{}, {}: {}, {}, {:.2f} s\n{}{}certified: decoded, each triangle once and the same "
             "way around\n",
             counted(source.triangles.points.size(), "point"), counted(made.triangles, "triangle"),
             counted(made.strips, "strip"), counted(file.code.index.size(), "index", "indices"),
             seconds, compared, source.remark);
  return kDone;
}

int unstrip(const UnstripVerbOptions& o) {
  require_mesh(o.output, o.output_format);
  io::StripFile strips = io::read_strips(o.strips);
  const Timer timer;
  io::MeshFile file;
  file.mesh.face_vertex = decode_strips(strips.code);
  const double seconds = timer.seconds();
  file.mesh.points = std::move(strips.points);
  file.z = std::move(strips.z);
  for (std::size_t end = 3; end <= file.mesh.face_vertex.size(); end += 3) {
    file.mesh.face_begin.push_back(static_cast<std::uint32_t>(end));
  }
  io::write_mesh(o.output, file, o.output_format);
  fmt::print(o.output == "-" ? stderr : stdout, "{}, {}: {}, {:.2f} s\n",
             counted(file.mesh.points.size(), "point"),
             counted(strips.code.index.size(), "index", "indices"),
             counted(file.mesh.face_count(), "triangle"), seconds);
  return kDone;
}

}  // namespace

void add_strip(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand("strip", "Triangles to strips of vertices");
  verb->footer(
      "\nEncodings: swap, strips with a bit an index that says where the last two vertices change\n"
      "places; repeat, one strip in which vertices sent again make empty triangles; restart, the\n"
      "same with an index that begins a new strip. Triangles are kept as they are, whichever way\n"
      "they turn, on surfaces too; quads are cut in two. Vertices keep their numbers.\n"
      "\n"
      "  quadloom strip coast.14 -o coast.strip --picture coast.png\n"
      "  quadloom unstrip coast.strip -o coast.obj");
  const auto o = std::make_shared<StripVerbOptions>();
  verb->add_option("MESH", o->mesh,
                   "The mesh: .obj, .off, .ply, .stl, .vtu, .msh, .14, .ele, .geojson, or -")
      ->required();
  verb->add_option("-o,--output", o->output, "The strips as .strip, or - for standard output")
      ->required();
  verb->add_option("--mesh-format", o->format, "Format of the mesh if not by the name");
  add_choice(*verb, "--encoding", o->strips.encoding, kEncodings, "How strips are joined and turn");
  add_choice(*verb, "--effort", o->strips.effort, kEfforts,
             "How long to look for fewer indices: half a microsecond a triangle in standard, ten "
             "times as long in thorough");
  add_whole(*verb, "--seed", o->strips.seed, 0, kNoLimit, "Which of many equal choices");
  verb->add_option("--picture", o->picture, "Also draw the strips: .svg, .png or .pdf");
  verb->callback([o, &run] { run = [o] { return strip(*o); }; });
}

void add_unstrip(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand("unstrip", "Strips of vertices to triangles");
  verb->footer(
      "\nThe triangles stand in the order in which the strips draw them.\n"
      "\n"
      "  quadloom unstrip coast.strip -o coast.obj");
  const auto o = std::make_shared<UnstripVerbOptions>();
  verb->add_option("STRIPS", o->strips, "The strips: .strip, or - for standard input")->required();
  verb->add_option("-o,--output", o->output,
                   "Mesh: .obj, .off, .ply, .vtu, .msh, .geojson, or - for standard output")
      ->required();
  verb->add_option("--output-format", o->output_format, "Format of the mesh if not by the name");
  verb->callback([o, &run] { run = [o] { return unstrip(*o); }; });
}

}  // namespace quadloom::app
