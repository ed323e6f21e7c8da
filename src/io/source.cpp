#include "io/source.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

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

std::string read_all(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> file(path == "-" ? stdin
                                                           : std::fopen(path.c_str(), "rb"));
  if (!file) fail_to_read(path, errno);
  std::string text;
  for (std::size_t size = 0;;) {
    text.resize(std::max(size + kChunk, size + size / 2));
    errno = 0;
    const std::size_t got = std::fread(text.data() + size, 1, text.size() - size, file.get());
    size += got;
    if (size < text.size()) {
      if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
      text.resize(size);
      return text;
    }
  }
}

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
