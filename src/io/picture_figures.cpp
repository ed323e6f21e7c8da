#include "io/picture_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadloom/kernel.hpp"

namespace quadloom::io {
namespace {

Point corner(const PolygonMesh& mesh, std::span<const VertexId> face, std::size_t i) {
  return mesh.points[face[i % face.size()]];
}

FaceKind face_kind(const PolygonMesh& mesh, std::span<const VertexId> face) {
  if (face.size() == 3) return FaceKind::kTriangle;
  FaceKind kind = FaceKind::kStrictlyConvex;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const int turn =
        orient2d(corner(mesh, face, i), corner(mesh, face, i + 1), corner(mesh, face, i + 2));
    if (turn < 0) return FaceKind::kNonConvex;
    if (turn == 0) kind = FaceKind::kFlatCornered;
  }
  return kind;
}

// The inner angle at b of a, b, c, in [0, 2 pi).
double inner_angle(Point a, Point b, Point c) {
  const double ux = c.x - b.x, uy = c.y - b.y, vx = a.x - b.x, vy = a.y - b.y;
  const double angle = std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

double face_shape(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  if (face.size() == 4) {
    return quad_shape(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2),
                      corner(mesh, face, 3));
  }
  const auto k = static_cast<double>(face.size());
  const double even = std::numbers::pi * (k - 2) / k;
  double worst = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const double angle =
        inner_angle(corner(mesh, face, i), corner(mesh, face, i + 1), corner(mesh, face, i + 2));
    worst = std::max(worst, std::fabs(angle - even) / std::min(even, std::numbers::pi - even));
  }
  return std::max(0.0, 1 - worst);
}

FaceFigures measure_faces(const PolygonMesh& mesh, ColourBy colour) {
  FaceFigures figures;
  figures.kind.reserve(mesh.face_count());
  if (colour == ColourBy::kQuality) figures.shape.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const FaceKind kind = face_kind(mesh, mesh.face(f));
    figures.kind.push_back(kind);
    ++figures.count[static_cast<std::size_t>(kind)];
    if (mesh.face(f).size() > 4) figures.quads_only = false;
    if (colour == ColourBy::kQuality) {
      figures.shape.push_back(static_cast<float>(face_shape(mesh, f)));
    }
  }
  return figures;
}

void add_groups(FaceFigures& figures, std::span<const std::uint8_t> group) {
  if (group.size() != figures.kind.size()) {
    throw Error(ErrorCode::kBadOption, std::to_string(group.size()) + " groups for " +
                                           std::to_string(figures.kind.size()) + " faces");
  }
  for (const std::uint8_t g : group) {
    if (g >= kMostGroups) {
      throw Error(ErrorCode::kBadOption, "a picture has no group " + std::to_string(g));
    }
    ++figures.group_count[g];
  }
  figures.group.assign(group.begin(), group.end());
}

}  // namespace quadloom::io
