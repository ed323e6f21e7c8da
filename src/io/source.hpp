// The text that a reader reads: a whole file in memory, with the name that messages give it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_buffer.hpp"
#include "quadloom/core.hpp"

namespace quadloom::io {

struct Source {
  std::string name;
  std::string_view text;
  /// The text of the file of the same name with another extension ("node"), if there is one; empty:
  /// there are no files beside this text.
  std::function<std::optional<std::string>(std::string_view extension)> beside = {};
};

/// The bytes of a file; "-" is standard input. Throws Error kFile.
TextBuffer read_file(const std::string& path);
std::string read_all(const std::string& path);

/// What messages call a path: the path itself, or "standard input".
std::string source_name(const std::string& path);

/// The part of a path after the last dot of its last name, in lower case; empty if there is none.
std::string extension_of(const std::string& path);

/// Throws Error `code` with "NAME, line LINE: WHAT" and the line as the culprit.
[[noreturn]] void fail_at(const Source& source, std::size_t line, const std::string& what,
                          ErrorCode code = ErrorCode::kParse);

/// Throws Error `code` with "NAME: WHAT", where no line is to blame.
[[noreturn]] void fail_in(const Source& source, const std::string& what,
                          ErrorCode code = ErrorCode::kParse,
                          std::vector<std::size_t> culprits = {});

/// 'text', abridged and with unprintable bytes as ?, for messages.
std::string in_quotes(std::string_view text);

}  // namespace quadloom::io
