// The module quadloom._core: everything of the library's public headers.
#include <nanobind/nanobind.h>

#include "bind.hpp"
#include "errors.hpp"
#include "quadloom/version.hpp"

NB_MODULE(_core, m) {
  using namespace quadloom;
  m.doc() = "Quadloom's C++ library; use it as the package quadloom.";
  m.attr("__version__") = kVersion;
  python::translate_errors();
  python::bind_mesh(m);
  python::bind_core(m);
  python::bind_kernel(m);
  python::bind_dual(m);
  python::bind_quadrangulate(m);
  python::bind_convex(m);
  python::bind_strips(m);
  python::bind_certify(m);
  python::bind_generate(m);
  python::bind_io(m);
}
