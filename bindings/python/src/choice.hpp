// Options that are one of a few words.
#pragma once

#include <nanobind/nanobind.h>

#include <initializer_list>
#include <string>

#include "quadloom/core.hpp"

namespace quadloom::python {

/// One member of an enumeration: its word in Python, as on the command line, and what it means.
template <typename Enum>
struct Word {
  Enum value;
  const char* word;
  const char* doc;
};

/// Makes an enumeration of strings: the member ON_EDGE of the word "on-edge".
template <typename Enum>
void bind_words(nanobind::module_& module, const char* name, const char* doc,
                std::initializer_list<Word<Enum>> words) {
  nanobind::enum_<Enum> bound(module, name, nanobind::is_str(), doc);
  for (const Word<Enum>& w : words) {
    std::string member;
    for (const char* c = w.word; *c != 0; ++c) {
      member += *c == '-' ? '_' : static_cast<char>(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
    }
    bound.str_value(member.c_str(), w.value, w.word, w.doc);
  }
}

/// An argument that is a member of the enumeration or its word.
template <typename Enum>
struct Choice {
  nanobind::object given;

  /// Throws Error kBadOption, naming the words.
  Enum get(const char* option) const {
    Enum value{};
    if (nanobind::try_cast<Enum>(given, value)) return value;
    std::string words;
    for (const nanobind::handle member : nanobind::type<Enum>()) {
      words +=
          (words.empty() ? "" : "|") + std::string(nanobind::str(member.attr("value")).c_str());
    }
    throw Error(ErrorCode::kBadOption, std::string(option) + ": " + nanobind::repr(given).c_str() +
                                           " is none of " + words);
  }
};

}  // namespace quadloom::python

namespace nanobind::detail {

template <typename Enum>
struct type_caster<quadloom::python::Choice<Enum>> {
  NB_TYPE_CASTER(quadloom::python::Choice<Enum>, make_caster<Enum>::Name + const_name(" | str"))
  bool from_python(handle src, std::uint32_t, cleanup_list*) noexcept {
    value.given = borrow(src);
    return true;
  }
};

}  // namespace nanobind::detail
