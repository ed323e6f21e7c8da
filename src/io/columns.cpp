#include "io/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 7> kPlane = {{
    {"x", "y"},
    {"lon", "lat"},
    {"lng", "lat"},
    {"long", "lat"},
    {"longitude", "latitude"},
    {"easting", "northing"},
    {"east", "north"},
}};
constexpr std::array<std::string_view, 8> kHeight = {
    "z", "elevation", "elev", "height", "altitude", "alt", "depth", "bathymetry"};

using Fields = std::vector<std::string_view>;

std::size_t find_name(const std::vector<std::string>& names, std::string_view name) {
  const auto same = [&](const std::string& other) { return lower_case(other) == name; };
  const auto at = std::ranges::find_if(names, same);
  return at == names.end() ? kNoColumn : static_cast<std::size_t>(at - names.begin());
}

bool is_number(const Fields& fields, std::size_t column) {
  return column < fields.size() && to_number(fields[column]).has_value();
}

std::vector<std::string> header_names(const Fields& fields) {
  return {fields.begin(), fields.end()};
}

std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 30;
  std::vector<std::string> shown;
  for (const auto& name : names) {
    if (shown.size() < most) shown.push_back(in_quotes(name));
  }
  return fmt::format("the columns are {}{}", fmt::join(shown, ", "),
                     names.size() > most ? ", ..." : "");
}

Fields split_wish(std::string_view wish) {
  Fields out;
  for (std::size_t begin = 0; begin <= wish.size();) {
    const auto end = std::min(wish.find(',', begin), wish.size());
    out.push_back(trimmed(wish.substr(begin, end - begin)));
    begin = end + 1;
  }
  return out;
}

/// The columns that were asked for.
Columns wished_columns(const Source& source, std::size_t line, const Fields& fields,
                       const std::string& wish) {
  const auto parts = split_wish(wish);
  if (parts.size() < 2 || parts.size() > 3) {
    throw Error(
        ErrorCode::kBadOption,
        fmt::format("columns {} should be two or three, as in x,y or 2,3,4", in_quotes(wish)));
  }
  const auto number_of = [](std::string_view part) { return to_integer<std::size_t>(part); };
  const bool by_name = std::ranges::any_of(parts, [&](auto p) { return !number_of(p); });
  Columns out;
  if (by_name || !is_number(fields, number_of(parts[0]).value_or(0) - 1)) {
    out.names = header_names(fields);
  }
  std::array<std::size_t, 3> column = {kNoColumn, kNoColumn, kNoColumn};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto number = number_of(parts[i]);
    column[i] = number ? *number - 1 : find_name(out.names, lower_case(parts[i]));
    if (column[i] < fields.size()) continue;
    if (number) {
      fail_at(source, line,
              fmt::format("there is no column {}, the line has {}", *number, fields.size()));
    }
    fail_at(source, line,
            fmt::format("there is no column {}; {}", in_quotes(parts[i]), list_of(out.names)));
  }
  out.x = column[0];
  out.y = column[1];
  out.z = column[2];
  return out;
}

bool find_by_name(Columns& out) {
  for (const auto& [x, y] : kPlane) {
    out.x = find_name(out.names, x);
    out.y = find_name(out.names, y);
    if (out.x == kNoColumn || out.y == kNoColumn) continue;
    for (const auto z : kHeight) {
      if (out.z == kNoColumn) out.z = find_name(out.names, z);
    }
    return true;
  }
  return false;
}

}  // namespace

std::size_t Columns::last() const { return std::max({x, y, z == kNoColumn ? std::size_t{0} : z}); }

std::string Columns::name(std::size_t column) const {
  return column < names.size() ? "column " + in_quotes(names[column])
                               : "column " + std::to_string(column + 1);
}

Columns choose_columns(const Source& source, std::size_t line, const Fields& fields,
                       const std::string& wish, bool any_header) {
  if (!wish.empty()) return wished_columns(source, line, fields, wish);
  Columns out;
  if (is_number(fields, 0) && (fields.size() < 2 || is_number(fields, 1))) {
    if (fields.size() < 2) fail_at(source, line, "expected two coordinates, found one number");
    if (is_number(fields, 2)) out.z = 2;
    return out;
  }
  out.names = header_names(fields);
  if (find_by_name(out)) return out;
  if (any_header) return {.x = 0, .y = 1, .z = kNoColumn, .names = out.names};
  fail_at(source, line, fmt::format("no columns x and y, or lon and lat; {}", list_of(out.names)));
}

}  // namespace quadloom::io
