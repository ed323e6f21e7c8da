#include "errors.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <exception>

#include "quadloom/core.hpp"

namespace nb = nanobind;

namespace quadloom::python {

void translate_errors() {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& e) {
      const nb::object type = nb::module_::import_("quadloom._errors").attr("Error");
      const nb::object error = type(e.what(), e.code(), e.culprits());
      PyErr_SetObject(type.ptr(), error.ptr());
    }
  });
}

}  // namespace quadloom::python
