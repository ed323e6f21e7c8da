#include "io/mesh_builder.hpp"

#include <fmt/format.h>

namespace quadloom::io {

void MeshBuilder::reserve(std::uint64_t vertices, std::uint64_t faces) {
  // A vertex or a face takes two bytes of a text at the very least.
  const std::uint64_t most = source_.text.size() / 2;
  file_.mesh.points.reserve(std::min(vertices, most));
  file_.z.reserve(std::min(vertices, most));
  file_.mesh.face_begin.reserve(std::min(faces, most) + 1);
  file_.mesh.face_vertex.reserve(std::min(4 * std::min(faces, most), most));
}

void MeshBuilder::fail(std::size_t line, const std::string& what, ErrorCode code,
                       std::vector<std::size_t> culprits) const {
  const std::string place = line == 0 ? "" : fmt::format(", line {}", line);
  throw Error(code, fmt::format("{}{}: {}", source_.name, place, what), std::move(culprits));
}

void MeshBuilder::add_vertex(double x, double y, double z) {
  if (vertex_count() >= kNone - 1) {
    fail(0, "more vertices than 32-bit indices can number", ErrorCode::kTooManyPoints, {});
  }
  file_.mesh.points.push_back({x + 0.0, y + 0.0});
  file_.z.push_back(z + 0.0);
}

void MeshBuilder::add_face(std::span<const std::uint64_t> corners, std::size_t line) {
  auto& mesh = file_.mesh;
  if (corners.size() < 3) {
    fail(line, fmt::format("a face of {} corners, three are the least", corners.size()),
         ErrorCode::kParse, line == 0 ? std::vector<std::size_t>{} : std::vector{line});
  }
  if (mesh.face_vertex.size() + corners.size() >= kNone) {
    fail(line, "more corners than 32-bit indices can number", ErrorCode::kTooManyPoints, {});
  }
  for (const auto corner : corners) {
    if (corner >= vertex_count()) forward_.push_back({face_count(), corner, line});
    mesh.face_vertex.push_back(static_cast<VertexId>(std::min<std::uint64_t>(corner, kNone)));
  }
  mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.face_vertex.size()));
}

void MeshBuilder::add_edge(std::uint64_t from, std::uint64_t to, std::size_t line) {
  if (from == to && from < vertex_count()) return;
  for (const auto end : {from, to}) {
    if (end >= vertex_count()) forward_edges_.push_back({file_.edges.size(), end, line});
  }
  file_.edges.push_back({static_cast<VertexId>(std::min<std::uint64_t>(from, kNone)),
                         static_cast<VertexId>(std::min<std::uint64_t>(to, kNone))});
}

void MeshBuilder::check_forward(const std::vector<Forward>& forward, std::string_view what) const {
  for (const auto& [index, corner, line] : forward) {
    if (corner < vertex_count()) continue;
    fail(line,
         fmt::format("{} {} names vertex {}, there are {}", what, index + first_index_,
                     corner + first_index_, vertex_count()),
         ErrorCode::kIndexOutOfRange, {index, static_cast<std::size_t>(corner)});
  }
}

MeshFile MeshBuilder::finish() {
  check_forward(forward_, "face");
  check_forward(forward_edges_, "edge");
  std::erase_if(file_.edges, [](const Segment& s) { return s.from == s.to; });
  if (std::ranges::all_of(file_.z, [](double z) { return z == 0; })) file_.z.clear();
  return std::move(file_);
}

}  // namespace quadloom::io
