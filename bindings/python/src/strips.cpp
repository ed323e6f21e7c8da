#include "bind.hpp"
namespace quadloom::python {
void bind_strips(nanobind::module_&) {}
}  // namespace quadloom::python
