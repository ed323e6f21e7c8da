// The layers of a picture of a mesh, from the bottom up: faces, edges, overlay, points.
#pragma once

#include "io/picture_canvas.hpp"
#include "io/picture_figures.hpp"
#include "io/picture_frame.hpp"

namespace quadloom::io {

/// A mesh placed on the page.
struct PlacedMesh {
  const PolygonMesh* mesh = nullptr;
  PageRect page;
  std::vector<Point> at;       // the vertices on the page
  std::vector<float> spacing;  // of each face: four times its area over its perimeter, the side of
                               // a square; thin faces have a small one
  double typical = 0;          // a low quartile of the spacings: what most of the picture has
};
PlacedMesh place_mesh(const PolygonMesh& mesh, const Frame& frame, const PageRect& page);

/// The colour of a group of faces, below kMostGroups.
Colour group_colour(std::size_t group);

void paint_faces(const Canvas& canvas, const PlacedMesh& placed, const FaceFigures& figures,
                 ColourBy colour);

/// Each edge as wide as the narrower of its faces bears; edges of tiny faces vanish, the boundary
/// stays.
void paint_edges(const Canvas& canvas, const PlacedMesh& placed, ColourBy colour);

/// Open lines change colour along their length; rings have the colour of their value.
void paint_overlay(const Canvas& canvas, const Frame& frame, const PageRect& page,
                   std::span<const Polyline> overlay);

/// The radius of the rings around so many added points; 0 if there is no room for rings.
double added_mark_radius(const PlacedMesh& placed, std::size_t count);

/// Dots where there is room for them, and a ring around each added point.
void paint_points(const Canvas& canvas, const PlacedMesh& placed,
                  std::span<const VertexId> steiner);

/// The ring of an added point, in the picture and in its legend.
void paint_added_mark(const Canvas& canvas, Point at, double radius);

}  // namespace quadloom::io
