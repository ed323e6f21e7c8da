// The bindings, a function a public header.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/vector.h>

namespace quadloom::python {

void bind_core(nanobind::module_& module);
void bind_mesh(nanobind::module_& module);
void bind_predicates(nanobind::module_& module);
void bind_kernel(nanobind::module_& module);
void bind_dual(nanobind::module_& module);
void bind_quadrangulate(nanobind::module_& module);
void bind_convex(nanobind::module_& module);
void bind_strips(nanobind::module_& module);
void bind_strip_codes(nanobind::module_& module);
void bind_certify(nanobind::module_& module);
void bind_generate(nanobind::module_& module);
void bind_io(nanobind::module_& module);

}  // namespace quadloom::python
