// Polygons and segments in: which format, and the .node beside a .poly.

#include <fmt/format.h>

#include "io/planar_readers.hpp"

namespace quadloom::io {

PlanarFile read_planar_text(const Source& source, const std::string& format,
                            const std::function<std::string()>& read_nodes) {
  if (format == "geojson" || format == "json") return read_geojson_planar(source);
  if (format == "poly") return read_poly(source, read_nodes);
  throw Error(ErrorCode::kBadOption,
              fmt::format("no format of polygons is called {}; there are geojson and poly",
                          in_quotes(format)));
}

PlanarFile read_planar(const std::string& path, const std::string& format) {
  const std::string name = format.empty() ? extension_of(path) : format;
  const auto read_nodes = [&] {
    if (path == "-") {
      throw Error(ErrorCode::kFile,
                  "standard input: the points are in a .node file, give the .poly by name");
    }
    return read_all(path.substr(0, path.find_last_of('.')) + ".node");
  };
  if (name != "geojson" && name != "json" && name != "poly" && format.empty()) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("cannot tell the format of {}: the endings known for polygons are "
                            ".geojson, .json and .poly",
                            path));
  }
  const TextBuffer text = read_file(path);
  return read_planar_text({source_name(path), text.view()}, name, read_nodes);
}

}  // namespace quadloom::io
