#include <cstddef>
#include <cstdint>

#include "fuzz/try_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quadloom::test::try_strips({reinterpret_cast<const char*>(data), size});
  return 0;
}
