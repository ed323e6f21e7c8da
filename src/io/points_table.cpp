// Points from tables: .csv, .xyz, .txt. A record is split into fields only as far as the last
// column that is needed; records are lines, save where a quoted field of a .csv holds a line end.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "io/columns.hpp"
#include "io/point_readers.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::size_t kAll = static_cast<std::size_t>(-1);

/// Records of a .csv.
class CsvRecords {
 public:
  explicit CsvRecords(const Source& source)
      : source_(source), rest_(without_mark(source.text)), separator_(guess_separator()) {}

  /// The next record that is not empty, its first `most` fields; false at the end.
  bool next(Fields& fields, std::size_t most) {
    fields.clear();
    unquoted_.clear();
    while (!rest_.empty()) {
      line_ = next_line_;
      const auto end = std::min(rest_.find('\n'), rest_.size());
      const auto record = rest_.substr(0, end);
      if (record.find('"') != std::string_view::npos) {
        split_quoted(fields);
        return true;
      }
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++next_line_;
      const auto text = trimmed_of_end(record);
      if (text.empty() || text[0] == '#') continue;
      split_plain(text, fields, most);
      return true;
    }
    return false;
  }

  std::size_t line() const { return line_; }

 private:
  static std::string_view trimmed_of_end(std::string_view record) {
    while (record.ends_with('\r')) record.remove_suffix(1);
    // Separators count where they are tabs: an empty last field is a field.
    const auto first = record.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{} : record;
  }

  /// The most frequent separator of the first record outside quotes; a comma wins ties.
  char guess_separator() const {
    constexpr std::array separators = {',', ';', '\t'};
    std::array<std::size_t, 3> count = {};
    bool inside = false, comment = false, filled = false;
    for (const char c : rest_) {
      if (c == '"') inside = !inside;
      if (c == '\n' && !inside) {
        if (filled) break;
        comment = false;
        count = {};
        continue;
      }
      if (c == '#' && !filled) comment = true;
      if (!is_blank(c) && !comment) filled = true;
      if (inside || comment) continue;
      for (std::size_t i = 0; i < separators.size(); ++i) count[i] += c == separators[i] ? 1 : 0;
    }
    const auto most = std::ranges::max_element(count);
    return separators[static_cast<std::size_t>(most - count.begin())];
  }

  void split_plain(std::string_view record, Fields& fields, std::size_t most) const {
    for (std::size_t begin = 0; begin <= record.size() && fields.size() < most;) {
      const auto end = std::min(record.find(separator_, begin), record.size());
      fields.push_back(trimmed(record.substr(begin, end - begin)));
      begin = end + 1;
    }
  }

  /// Splits the record at the front of rest_, which has quotes: "" within a quoted field is a
  /// quote, separators and line ends within it are text.
  void split_quoted(Fields& fields) {
    bool more = true;
    while (more) {
      while (!rest_.empty() && (rest_[0] == ' ' || (rest_[0] == '\t' && separator_ != '\t'))) {
        rest_.remove_prefix(1);
      }
      if (rest_.starts_with('"')) {
        fields.push_back(take_quoted());
      } else {
        const auto end =
            std::min(rest_.find_first_of(std::array{separator_, '\n', '\0'}.data()), rest_.size());
        fields.push_back(trimmed(rest_.substr(0, end)));
        rest_.remove_prefix(end);
      }
      more = end_field();
    }
  }

  std::string_view take_quoted() {
    rest_.remove_prefix(1);
    std::string field;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (rest_[i] == '"') {
        const bool doubled = i + 1 < rest_.size() && rest_[i + 1] == '"';
        if (!doubled) {
          rest_.remove_prefix(i + 1);
          return unquoted_.emplace_back(std::move(field));
        }
        ++i;
      } else if (rest_[i] == '\n') {
        ++next_line_;
      }
      field += rest_[i];
    }
    fail_at(source_, line_, "a quoted field does not end");
  }

  /// Moves over what follows a field; true if it is a separator, false at the end of the record.
  bool end_field() {
    while (!rest_.empty() && rest_[0] != separator_ && is_blank(rest_[0])) rest_.remove_prefix(1);
    if (rest_.empty()) return false;
    const char c = rest_[0];
    if (c != separator_ && c != '\n') {
      fail_at(source_, line_, "text after the closing quote of a field");
    }
    rest_.remove_prefix(1);
    if (c == '\n') ++next_line_;
    return c == separator_;
  }

  const Source& source_;
  std::string_view rest_;
  char separator_;
  std::size_t line_ = 0;
  std::size_t next_line_ = 1;
  std::deque<std::string> unquoted_;  // of the current record
};

/// Records of an .xyz or .txt: one a line.
class XyzRecords {
 public:
  explicit XyzRecords(const Source& source) : lines_(source) {}

  bool next(Fields& fields, std::size_t most) {
    fields.clear();
    if (!lines_.next_filled()) return false;
    const std::string_view text = lines_.line();
    std::size_t end = 0;
    while (fields.size() < most) {
      const auto begin = text.find_first_not_of(kBetween, end);
      if (begin == std::string_view::npos || text[begin] == '#') break;
      end = std::min(text.find_first_of(kBetween, begin), text.size());
      fields.push_back(text.substr(begin, end - begin));
    }
    return true;
  }

  std::size_t line() const { return lines_.number(); }

 private:
  static constexpr std::string_view kBetween = " \t\r,;";
  Lines lines_;
};

double coordinate(const Source& source, std::size_t line, const Fields& fields,
                  const Columns& columns, std::size_t column) {
  if (column >= fields.size()) {
    fail_at(
        source, line,
        fmt::format("the line has {} columns, {} is missing", fields.size(), columns.name(column)));
  }
  const auto value = to_number(fields[column]);
  if (value && std::isfinite(*value)) return *value + 0.0;
  return finite_number(source, line, fields[column], "a number in " + columns.name(column));
}

template <class Records>
PointTable read_table(const Source& source, const std::string& wish, bool any_header) {
  Records records(source);
  PointTable out;
  Fields fields;
  bool more = records.next(fields, kAll);
  if (!more) fail_in(source, "the file holds no points", ErrorCode::kTooFewPoints);
  const Columns columns = choose_columns(source, records.line(), fields, wish, any_header);
  const std::size_t needed = columns.last() + 1;
  if (columns.has_header()) more = records.next(fields, needed);
  for (; more; more = records.next(fields, needed)) {
    const auto line = records.line();
    const double x = coordinate(source, line, fields, columns, columns.x);
    const double y = coordinate(source, line, fields, columns, columns.y);
    if (columns.z != kNoColumn) {
      out.z.push_back(coordinate(source, line, fields, columns, columns.z));
    }
    out.points.push_back({x, y});
    out.line.push_back(line);
  }
  if (out.points.empty()) {
    fail_in(source, "the file holds a header but no points", ErrorCode::kTooFewPoints);
  }
  return out;
}

}  // namespace

PointTable read_csv_points(const Source& source, const std::string& columns) {
  return read_table<CsvRecords>(source, columns, false);
}

PointTable read_xyz_points(const Source& source, const std::string& columns) {
  return read_table<XyzRecords>(source, columns, true);
}

}  // namespace quadloom::io
