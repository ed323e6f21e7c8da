// Which columns of a table hold x, y and z.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/source.hpp"

namespace quadloom::io {

inline constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

/// Columns from 0; z is kNoColumn where there is none.
struct Columns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::size_t z = kNoColumn;
  std::vector<std::string> names;  ///< of the header, empty without one

  bool has_header() const { return !names.empty(); }
  std::size_t last() const;
  /// "column x" or "column 2", for messages.
  std::string name(std::size_t column) const;
};

/// Decides from the first line's fields and the caller's wish ("" or two or three names or numbers
/// from 1, separated by commas). The first line is a header if a column is asked for by name or a
/// field that should be a coordinate is no number. With `any_header`, a header without usable names
/// is skipped and the columns are taken in order.
Columns choose_columns(const Source& source, std::size_t line,
                       const std::vector<std::string_view>& fields, const std::string& wish,
                       bool any_header);

}  // namespace quadloom::io
