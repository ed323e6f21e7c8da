#include "fields.hpp"

#include <nanobind/stl/string.h>

namespace nb = nanobind;

namespace quadloom::python {
namespace {

nb::handle type_of(nb::handle self) { return self.type(); }

std::string text_of_value(nb::handle value) {
  if (!nb::hasattr(value, "__array_interface__")) return nb::repr(value).c_str();
  const nb::object shape = value.attr("shape");
  return std::string("array") + nb::repr(shape).c_str();
}

}  // namespace

std::string text_of_fields(nb::handle self) {
  std::string text = nb::cast<std::string>(type_of(self).attr("__name__")) + "(";
  bool first = true;
  for (const nb::handle name : type_of(self).attr("__match_args__")) {
    if (!first) text += ", ";
    first = false;
    text += nb::cast<std::string>(name) + "=" + text_of_value(nb::getattr(self, name));
  }
  return text + ")";
}

nb::dict fields_as_dict(nb::handle self) {
  nb::dict out;
  for (const nb::handle name : type_of(self).attr("__match_args__")) {
    out[name] = nb::getattr(self, name);
  }
  return out;
}

}  // namespace quadloom::python
