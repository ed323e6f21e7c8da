// The arrays of numbers in VTK's XML files: as text; or as binary data, in base64 within the element
// or appended at the end of the file (base64 or raw), perhaps compressed in blocks by zlib.
#pragma once

#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "io/source.hpp"

namespace quadloom::io {

/// What the file says of all its binary arrays.
struct VtuEncoding {
  bool swap = false;            ///< in the other byte order than this machine's
  bool long_header = false;     ///< numbers of headers have 64 bits, not 32
  bool raw = false;             ///< the appended data are bytes, not base64
  std::string_view appended;    ///< the appended data after the underscore
  std::string_view compressor;  ///< empty: none
};

/// The numbers of the element DataArray. Throws Error kParse naming the array.
std::vector<double> read_vtu_array(const Source& source, const VtuEncoding& encoding,
                                   pugi::xml_node array);

}  // namespace quadloom::io
