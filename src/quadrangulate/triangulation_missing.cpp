// Methods that are still to come, one by one replaced by their files.
#include "quadrangulate/triangulation_fans.hpp"
#include "quadrangulate/triangulation_percolate.hpp"

namespace quadloom::quadrangulate {

[[noreturn]] static void missing() { throw Error(ErrorCode::kBadOption, "not there yet"); }

TriangleResult percolate_triangulation(const TriangleMesh&, const TriangleOptions&) { missing(); }

TriangleResult fan_triangulation(const TriangleMesh&, const TriangleOptions&) { missing(); }

}  // namespace quadloom::quadrangulate
