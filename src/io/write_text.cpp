#include "io/output.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

void write_text(const std::string& path, std::string_view text) {
  Output out(path);
  out << text;
  out.commit();
}

}  // namespace quadloom::io
