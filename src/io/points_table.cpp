// Points from tables: .csv, .xyz, .txt. A record is split into fields only as far as the last
// column that is needed; records are lines, save where a quoted field of a .csv holds a line end.
//
//   1. the first record says which columns hold the coordinates
//   2. read_part   of each block of lines, on several threads; one block if there may be line ends within
//                  quotes
//   3. join        in order

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <string>
#include <utility>
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

  /// Of a part of the same text.
  CsvRecords at(const LineBlock& block) const {
    CsvRecords out = *this;
    out.rest_ = block.text;
    out.next_line_ = block.first_line;
    return out;
  }
  /// What is not read yet.
  std::vector<LineBlock> blocks(std::size_t block_bytes) const {
    const bool quotes = rest_.find('"') != std::string_view::npos;
    return line_blocks(rest_, next_line_, quotes ? rest_.size() + 1 : block_bytes);
  }

  /// The next record that is not empty, its first `most` fields; false at the end.
  bool next(Fields& fields, std::size_t most) {
    fields.clear();
    unquoted_.clear();
    while (!rest_.empty()) {
      line_ = next_line_;
      const auto end = std::min(rest_.find('\n'), rest_.size());
      const auto record = rest_.substr(0, end);
      const auto text = trimmed_of_end(record);
      const bool skip = text.empty() || text[0] == '#';
      if (!skip && record.find('"') != std::string_view::npos) {
        split_quoted(fields);
        return true;
      }
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++next_line_;
      if (skip) continue;
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
      if (c == '"' && !comment) inside = !inside;
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

/// Blanks and the like between the fields of an .xyz.
constexpr std::array<bool, 256> make_between() {
  std::array<bool, 256> out{};
  for (const char c : {' ', '\t', '\r', ',', ';'}) out[static_cast<unsigned char>(c)] = true;
  return out;
}
constexpr std::array<bool, 256> kBetween = make_between();

/// Records of an .xyz or .txt: one a line.
class XyzRecords {
 public:
  explicit XyzRecords(const Source& source) : source_(source), lines_(source) {}

  XyzRecords at(const LineBlock& block) const { return {source_, block}; }
  std::vector<LineBlock> blocks(std::size_t block_bytes) const {
    const LineBlock rest = lines_.rest();
    return line_blocks(rest.text, rest.first_line, block_bytes);
  }

  bool next(Fields& fields, std::size_t most) {
    fields.clear();
    if (!lines_.next_filled()) return false;
    const char* at = lines_.line().data();
    const char* const end = at + lines_.line().size();
    while (fields.size() < most) {
      while (at != end && is_between(*at)) ++at;
      if (at == end || *at == '#') break;
      const char* const begin = at;
      while (at != end && !is_between(*at)) ++at;
      fields.emplace_back(begin, static_cast<std::size_t>(at - begin));
    }
    return true;
  }

  std::size_t line() const { return lines_.number(); }

 private:
  XyzRecords(const Source& source, const LineBlock& block)
      : source_(source), lines_(source, block) {}

  static bool is_between(char c) { return kBetween[static_cast<unsigned char>(c)]; }

  const Source& source_;
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

/// Step 2.
template <class Records>
void read_part(const Source& source, const Columns& columns, Records records, PointTable& out) {
  Fields fields;
  while (records.next(fields, columns.last() + 1)) {
    const auto line = records.line();
    const double x = coordinate(source, line, fields, columns, columns.x);
    const double y = coordinate(source, line, fields, columns, columns.y);
    if (columns.z != kNoColumn) {
      out.z.push_back(coordinate(source, line, fields, columns, columns.z));
    }
    out.points.push_back({x, y});
    out.line.push_back(line);
  }
}

/// Step 3. Parts that are done with are freed.
PointTable join(std::vector<PointTable> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  PointTable out;
  const auto append = [&](auto field) {
    std::size_t size = 0;
    for (const PointTable& part : parts) size += (part.*field).size();
    (out.*field).reserve(size);
    for (PointTable& part : parts) {
      const auto values = std::exchange(part.*field, {});
      (out.*field).insert((out.*field).end(), values.begin(), values.end());
    }
  };
  append(&PointTable::points);
  append(&PointTable::z);
  append(&PointTable::line);
  return out;
}

template <class Records>
PointTable read_table(const Source& source, const std::string& wish, bool any_header,
                      std::size_t block_bytes) {
  Records records(source);
  const Records all = records;
  Fields fields;
  if (!records.next(fields, kAll)) {
    fail_in(source, "the file holds no points", ErrorCode::kTooFewPoints);
  }
  const Columns columns = choose_columns(source, records.line(), fields, wish, any_header);
  const Records& table = columns.has_header() ? records : all;
  PointTable out = join(read_blocks<PointTable>(table.blocks(block_bytes),
                                                [&](const LineBlock& block, PointTable& part) {
                                                  read_part(source, columns, table.at(block), part);
                                                }));
  if (out.points.empty()) {
    fail_in(source, "the file holds a header but no points", ErrorCode::kTooFewPoints);
  }
  return out;
}

}  // namespace

PointTable read_csv_points(const Source& source, const std::string& columns,
                           std::size_t block_bytes) {
  return read_table<CsvRecords>(source, columns, false, block_bytes);
}

PointTable read_xyz_points(const Source& source, const std::string& columns,
                           std::size_t block_bytes) {
  return read_table<XyzRecords>(source, columns, true, block_bytes);
}

}  // namespace quadloom::io
