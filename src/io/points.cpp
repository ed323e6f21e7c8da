// Points in and out: which format, and the writers.

#include <fmt/format.h>

#include <cmath>

#include "io/output.hpp"
#include "io/point_readers.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

std::string format_of(const std::string& path) {
  const auto extension = extension_of(path);
  if (extension == "csv" || extension == "tsv") return "csv";
  if (extension == "xyz" || extension == "txt" || extension == "xy") return "xyz";
  if (extension == "geojson" || extension == "json") return "geojson";
  throw Error(ErrorCode::kBadOption,
              fmt::format("cannot tell the format of {}: the endings known for points are .csv, "
                          ".tsv, .xyz, .txt, .geojson and .json",
                          path));
}

void write_number(TextBuffer& out, double value, std::string_view what) {
  if (!std::isfinite(value)) {
    throw Error(ErrorCode::kNotFinite, fmt::format("cannot write {} {}", what, value));
  }
  out << value;
}

void write_coordinates(TextBuffer& out, Point p, const double* z, char between) {
  write_number(out, p.x, "the coordinate");
  out << between;
  write_number(out, p.y, "the coordinate");
  if (z == nullptr) return;
  out << between;
  write_number(out, *z, "the height");
}

void write_table(Output& out, std::span<const Point> points, std::span<const double> z,
                 char between) {
  out.each(points.size(), [&](TextBuffer& to, std::size_t i) {
    write_coordinates(to, points[i], z.empty() ? nullptr : &z[i], between);
    to << '\n';
  });
}

void write_multipoint(Output& out, std::span<const Point> points, std::span<const double> z) {
  out << R"({"type":"MultiPoint","coordinates":[)";
  out.each(points.size(), [&](TextBuffer& to, std::size_t i) {
    to << (i == 0 ? "\n[" : ",\n[");
    write_coordinates(to, points[i], z.empty() ? nullptr : &z[i], ',');
    to << ']';
  });
  out << "\n]}\n";
}

}  // namespace

PointTable read_points_text(const Source& source, const std::string& format,
                            const std::string& columns) {
  if (format == "csv") return read_csv_points(source, columns);
  if (format == "xyz") return read_xyz_points(source, columns);
  if (format == "geojson") return read_geojson_points(source);
  if (format == "node") return read_node_points(source);
  throw Error(ErrorCode::kBadOption,
              fmt::format("no format of points is called {}; there are csv, xyz, geojson and node",
                          in_quotes(format)));
}

PointTable read_points(const std::string& path, const ReadPointsOptions& options) {
  const std::string format = !options.format.empty()        ? options.format
                             : path == "-"                  ? "xyz"
                             : extension_of(path) == "node" ? "node"
                                                            : format_of(path);
  const TextBuffer text = read_file(path);
  return read_points_text({source_name(path), text.view()}, format, options.columns);
}

void write_points(const std::string& path, std::span<const Point> points,
                  std::span<const double> z) {
  if (!z.empty() && z.size() != points.size()) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("{} heights for {} points", z.size(), points.size()));
  }
  const std::string format = path == "-" ? "xyz" : format_of(path);
  Output out(path);
  if (format == "geojson") {
    write_multipoint(out, points, z);
  } else if (format == "csv") {
    const char between = extension_of(path) == "tsv" ? '\t' : ',';
    out << 'x' << between << 'y';
    if (!z.empty()) out << between << 'z';
    out << '\n';
    write_table(out, points, z, between);
  } else {
    write_table(out, points, z, ' ');
  }
  out.commit();
}

}  // namespace quadloom::io
