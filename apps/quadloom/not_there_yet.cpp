// Place-holders for what is still to come.
#include "quadloom/certify.hpp"
#include "quadloom/kernel.hpp"

namespace quadloom {

[[noreturn]] static void missing() { throw Error(ErrorCode::kBadOption, "not there yet"); }

__attribute__((weak)) Certificate certify_surface(const PolygonMesh&, std::span<const double>,
                                                  const PolygonMesh&, std::span<const double>,
                                                  const CertifyOptions&) {
  missing();
}
__attribute__((weak)) Quality measure_quality(const PolygonMesh&, std::span<const double>) {
  missing();
}

}  // namespace quadloom
