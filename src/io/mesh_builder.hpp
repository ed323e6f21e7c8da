// A mesh being read: vertices and faces as they come, with the checks that all formats share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "io/source.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

class MeshBuilder {
 public:
  /// `first_index` is the number that the format gives to the first vertex, for messages.
  explicit MeshBuilder(const Source& source, std::uint64_t first_index = 0)
      : source_(source), first_index_(first_index) {}

  /// Makes room, but never for more than the text could hold: counts in headers may lie.
  void reserve(std::uint64_t vertices, std::uint64_t faces);

  std::size_t vertex_count() const { return file_.mesh.points.size(); }
  std::size_t face_count() const { return file_.mesh.face_count(); }

  /// Coordinates are finite.
  void add_vertex(double x, double y, double z);

  /// Corners from 0; they may name vertices that come later. `line` is 0 if there are no lines.
  void add_face(std::span<const std::uint64_t> corners, std::size_t line);

  /// A line of the file, ends from 0 as for faces. One from a vertex to itself is none.
  void add_edge(std::uint64_t from, std::uint64_t to, std::size_t line);

  /// The mesh, every corner and end a vertex; heights that are all 0 are dropped.
  MeshFile finish();

 private:
  struct Forward {
    std::size_t index;
    std::uint64_t corner;
    std::size_t line;
  };
  void check_forward(const std::vector<Forward>& forward, std::string_view what) const;
  [[noreturn]] void fail(std::size_t line, const std::string& what, ErrorCode code,
                         std::vector<std::size_t> culprits) const;

  const Source& source_;
  std::uint64_t first_index_;
  MeshFile file_;
  std::vector<Forward> forward_;  // corners that named no vertex yet
  std::vector<Forward> forward_edges_;
};

}  // namespace quadloom::io
