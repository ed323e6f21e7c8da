// The meshes of Triangle, NAME.ele with the NAME.node beside it:
//
//    2 3 1              triangles, points a triangle (3, or 6 of which the first 3 are corners),
//    1  1 2 3  7          attributes
//    2  1 3 4  8        number, points, attributes
//
// Attributes are face data, attributes and markers of the points vertex data. Edges are the segments
// of the NAME.poly that Triangle writes (it has no points of its own), or else the edges of the
// NAME.edge whose marker is not 0; an .edge without markers holds all edges and says nothing.

#include <fmt/format.h>

#include <array>

#include "io/mesh_builder.hpp"
#include "io/mesh_formats.hpp"
#include "io/triangle_nodes.hpp"

namespace quadloom::io {
namespace {

constexpr std::uint64_t kMostAttributes = 1000;

std::optional<std::string> text_beside(const Source& source, std::string_view extension) {
  return source.beside ? source.beside(extension) : std::nullopt;
}

std::string name_beside(const Source& source, std::string_view extension) {
  return fmt::format("the .{} of {}", extension, source.name);
}

TriangleNodes read_nodes(const Source& source) {
  const auto text = text_beside(source, "node");
  if (!text) {
    fail_in(source, "the points are in the .node file of the same name, and there is none",
            ErrorCode::kFile);
  }
  const Source nodes{name_beside(source, "node"), *text};
  TriangleLines lines(nodes);
  return read_triangle_nodes(lines);
}

std::vector<Attribute> read_triangles(const Source& source, const TriangleNodes& nodes,
                                      MeshBuilder& mesh) {
  TriangleLines lines(source);
  lines.require("the number of triangles");
  const auto triangles = lines.count("the number of triangles");
  const auto points = lines.has_word() ? lines.count("the points of a triangle") : 3;
  const auto attributes = lines.has_word() ? lines.count("the number of attributes") : 0;
  if (points != 3 && points != 6) {
    lines.fail(fmt::format("{} points an element, triangles have 3 or 6", points));
  }
  if (attributes > kMostAttributes) {
    lines.fail(fmt::format("{} attributes a triangle are too many", attributes));
  }
  std::vector<Attribute> data;
  for (std::uint64_t a = 0; a < attributes; ++a) {
    data.push_back({fmt::format("attribute{}", a), {}});
  }
  mesh.reserve(0, triangles);
  for (std::uint64_t i = 0; i < triangles; ++i) {
    lines.require(fmt::format("triangle {} of {}", i + 1, triangles));
    lines.integer("the number of the triangle");
    std::array<std::uint64_t, 6> corner{};
    for (std::uint64_t k = 0; k < points; ++k) {
      corner[k] = read_triangle_point(lines, nodes.first, nodes.points.size());
    }
    mesh.add_face(std::span(corner).first(3), lines.number());
    for (Attribute& attribute : data) attribute.values.push_back(lines.finite(attribute.name));
  }
  if (lines.next()) lines.fail("more lines than the number of triangles says");
  return data;
}

/// False if there is no .poly without points of its own beside the .ele.
bool read_poly_segments(const Source& source, const TriangleNodes& nodes, MeshBuilder& mesh) {
  const auto text = text_beside(source, "poly");
  if (!text) return false;
  const Source poly{name_beside(source, "poly"), *text};
  TriangleLines lines(poly);
  lines.require("the number of points");
  if (lines.count("the number of points") != 0) return false;
  for (const auto [from, to] :
       read_triangle_segments(lines, nodes.first, nodes.points.size()).segments) {
    mesh.add_edge(from, to, lines.number());
  }
  return true;
}

void read_marked_edges(const Source& source, const TriangleNodes& nodes, MeshBuilder& mesh) {
  const auto text = text_beside(source, "edge");
  if (!text) return;
  const Source edge{name_beside(source, "edge"), *text};
  TriangleLines lines(edge);
  const auto edges = read_triangle_segments(lines, nodes.first, nodes.points.size());
  for (std::size_t i = 0; edges.has_markers && i < edges.segments.size(); ++i) {
    if (edges.marker[i] == 0) continue;
    mesh.add_edge(edges.segments[i].from, edges.segments[i].to, lines.number());
  }
}

}  // namespace

MeshFile read_ele(const Source& source) {
  TriangleNodes nodes = read_nodes(source);
  MeshBuilder mesh(source);
  mesh.reserve(nodes.points.size(), 0);
  for (const Point p : nodes.points) mesh.add_vertex(p.x, p.y, 0);
  auto face_data = read_triangles(source, nodes, mesh);
  if (!read_poly_segments(source, nodes, mesh)) read_marked_edges(source, nodes, mesh);
  MeshFile out = mesh.finish();
  out.vertex_data = std::move(nodes.data);
  out.face_data = std::move(face_data);
  return out;
}

}  // namespace quadloom::io
