// quadloom draw: a picture of any mesh file.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "exit_codes.hpp"
#include "options.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

struct DrawVerbOptions {
  std::string mesh, format, output;
  io::DrawOptions draw;
};

// The vertices that quadrangulate marked as added, in the formats that carry it.
std::vector<VertexId> marked_as_added(const io::MeshFile& file) {
  std::vector<VertexId> vertices;
  const auto added = std::find_if(file.vertex_data.begin(), file.vertex_data.end(),
                                  [](const io::Attribute& a) { return a.name == "added"; });
  if (added == file.vertex_data.end()) return vertices;
  for (std::size_t v = 0; v < added->values.size(); ++v) {
    if (added->values[v] == 1) vertices.push_back(static_cast<VertexId>(v));
  }
  return vertices;
}

int draw(DrawVerbOptions o) {
  require_picture(o.output);
  const io::MeshFile file = io::read_mesh(o.mesh, o.format);
  o.draw.steiner = marked_as_added(file);
  io::draw_mesh(o.output, file, o.draw);
  return kDone;
}

}  // namespace

void add_draw(CLI::App& app, Run& run) {
  CLI::App* verb = app.add_subcommand("draw", "A picture of a mesh");
  verb->footer(
      "\n  quadloom draw mesh.vtu -o mesh.png\n"
      "  quadloom draw mesh.obj -o mesh.svg --colour convexity --title \"My mesh\"");
  const auto o = std::make_shared<DrawVerbOptions>();
  verb->add_option("MESH", o->mesh,
                   "The mesh: .obj, .off, .ply, .stl, .vtu, .msh, .14, .ele, .geojson, or -")
      ->required();
  verb->add_option("-o,--output", o->output, "The picture: .svg, .png or .pdf")->required();
  verb->add_option("--mesh-format", o->format, "Format of the mesh if not by the name");
  add_colour(*verb, o->draw.colour);
  verb->add_option("--title", o->draw.title, "One line above the picture");
  add_whole(*verb, "--width", o->draw.width, 100, 20000,
            "Width in pixels; points in .svg and .pdf");
  verb->callback([o, &run] { run = [o] { return draw(*o); }; });
}

}  // namespace quadloom::app
