#include "bind.hpp"
namespace quadloom::python {
void bind_dual(nanobind::module_&) {}
}  // namespace quadloom::python
