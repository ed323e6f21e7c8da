// quadloom triangulate for polygons.
#include "mesh_facts.hpp"
#include "triangulate.hpp"

namespace quadloom::app {

MadeTriangles triangulate_polygons(const TriangulateOptions& options, FoundInput found) {
  if (options.kind != TriangulationKind::kDelaunay) {
    no_such_kind(options.kind, "polygons", "delaunay");
  }
  MeshReading reading;
  reading.path = options.input.path;
  reading.format = options.input.reading.format;
  SourceMesh source = read_source(reading, std::move(found));
  MadeTriangles made;
  made.seconds = source.connect_seconds;
  made.file.mesh = to_polygon_mesh(source.triangles.mesh);
  made.file.z = source.z;
  made.file.vertex_data = source.vertex_data;
  made.file.face_data = source.face_data;
  made.file.edges = source.lines;
  made.certificate = certify_against(made.file, source, triangles_alone(0));
  made.verdict = source_verdict(made.certificate, source, false);
  return made;
}

}  // namespace quadloom::app
