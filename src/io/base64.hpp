// Base64, as .vtu files use it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/text_buffer.hpp"

namespace quadloom::io {

std::string to_base64(std::string_view bytes);

/// Likewise, at the end of `out`.
void append_base64(std::string_view bytes, TextBuffer& out);

/// Decodes into `out`; blanks and line ends are skipped, and several encoded pieces with their
/// padding may follow each other. False if the text is no base64.
bool from_base64(std::string_view text, std::string& out);

/// Likewise, but only until `out`, to which it adds, holds `enough` bytes, or a few more; what was
/// read is taken off the front of `text`.
bool from_base64(std::string_view& text, std::size_t enough, std::string& out);

}  // namespace quadloom::io
