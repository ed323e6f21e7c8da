// The reader of strips from a text in memory.
#pragma once

#include "io/source.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

StripFile read_strips_text(const Source& source);

}  // namespace quadloom::io
