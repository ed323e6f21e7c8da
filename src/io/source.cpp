#include "io/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

namespace quadloom::io {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr std::size_t kMostQuoted = 40;

struct Close {
  void operator()(std::FILE* f) const {
    if (f != stdin) std::fclose(f);
  }
};

[[noreturn]] void fail_to_read(const std::string& path, int error) {
  throw Error(ErrorCode::kFile,
              fmt::format("cannot read {}: {}", source_name(path), std::strerror(error)));
}

}  // namespace

std::string source_name(const std::string& path) { return path == "-" ? "standard input" : path; }

TextBuffer read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> file(path == "-" ? stdin
                                                           : std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, errno);
  TextBuffer text;
  std::error_code no_size;
  const auto size = path == "-" ? 0 : std::filesystem::file_size(path, no_size);
  std::size_t asked =
      (no_size ? 0 : static_cast<std::size_t>(size)) + 1;  // one more: the end is seen
  for (;; asked = std::max(kChunk, text.size())) {
    errno = 0;
    const std::size_t got = std::fread(text.room(asked), 1, asked, file.get());
    text.added(got);
    if (got == asked) continue;
    if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
    return text;
  }
}

std::string read_all(const std::string& path) { return std::string(read_file(path).view()); }

std::string extension_of(const std::string& path) {
  const auto dot = path.find_last_of("./\\");
  if (dot == std::string::npos || path[dot] != '.') return {};
  std::string out = path.substr(dot + 1);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

void fail_at(const Source& source, std::size_t line, const std::string& what, ErrorCode code) {
  throw Error(code, fmt::format("{}, line {}: {}", source.name, line, what), {line});
}

void fail_in(const Source& source, const std::string& what, ErrorCode code,
             std::vector<std::size_t> culprits) {
  throw Error(code, fmt::format("{}: {}", source.name, what), std::move(culprits));
}

std::string in_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text.substr(0, kMostQuoted)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 32 || byte == 127 ? '?' : c;
  }
  if (text.size() > kMostQuoted) out += "...";
  return out += '\'';
}

}  // namespace quadloom::io
