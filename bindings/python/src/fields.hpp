// Small classes: fields, arrays that view them, and one text for all of them.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <type_traits>
#include <utility>

#include "arrays.hpp"

namespace quadloom::python {

/// "PointStatistics(hull_points=8, ...)"; arrays by their shape.
std::string text_of_fields(nanobind::handle self);
/// The fields by name.
nanobind::dict fields_as_dict(nanobind::handle self);

/// nb::class_ that remembers its fields: after done() they make the repr, as_dict() and __match_args__.
template <typename T, typename... Extra>
class Fields : public nanobind::class_<T, Extra...> {
 public:
  using Class = nanobind::class_<T, Extra...>;
  Fields(nanobind::module_& module, const char* name, const char* doc) : Class(module, name, doc) {}

  template <typename Value, typename Base>
  Fields& value(const char* name, Value Base::*member, const char* doc) {
    this->def_ro(name, member, doc);
    names_.append(name);
    return *this;
  }

  template <typename Get>
  Fields& get(const char* name, Get value_of, const char* doc) {
    this->def_prop_ro(name, value_of, doc);
    names_.append(name);
    return *this;
  }

  /// A view of a vector that the object owns, in rows of Width.
  template <std::size_t Width = 1, typename Value, typename Base>
  Fields& array(const char* name, Value Base::*member, const char* doc) {
    return get(
        name, [member](const T& self) { return view<Width>(self.*member); }, doc);
  }
  /// The same for `get(self)`, a reference to a vector or a span.
  template <std::size_t Width = 1, typename Get>
  requires(!std::is_member_pointer_v<Get>) Fields& array(const char* name, Get get_elements,
                                                         const char* doc) {
    return get(
        name, [get_elements](const T& self) { return view<Width>(get_elements(self)); }, doc);
  }

  /// The text and the names of the fields, in the order given.
  Class& done() {
    this->attr("__match_args__") = nanobind::tuple(names_);
    this->def("__repr__", [](nanobind::handle self) { return text_of_fields(self); });
    this->def(
        "as_dict", [](nanobind::handle self) { return fields_as_dict(self); },
        "The fields by name.");
    return *this;
  }

 private:
  nanobind::list names_;
};

}  // namespace quadloom::python
