// Every file of tests/corpus/ through its reader: the fuzzers' seeds, and what they found.
#include <gtest/gtest.h>

#include <filesystem>

#include "fuzz/try_reader.hpp"
#include "io/source.hpp"

namespace quadloom {
namespace {

TEST(Corpus, EveryFileIsReadOrRefused) {
  std::size_t read = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(QUADLOOM_CORPUS)) {
    if (!entry.is_regular_file()) continue;
    SCOPED_TRACE(entry.path().string());
    // tests/corpus/mesh_obj/square.obj
    const std::string folder = entry.path().parent_path().filename().string();
    const auto underscore = folder.find('_');
    if (underscore == std::string::npos) continue;
    const std::string kind = folder.substr(0, underscore), format = folder.substr(underscore + 1);
    if (kind != "points" && kind != "mesh" && kind != "planar" && kind != "strips") continue;
    const std::string text = io::read_all(entry.path().string());
    const bool ok = kind == "points"   ? test::try_points(format, text)
                    : kind == "mesh"   ? test::try_mesh(format, text)
                    : kind == "strips" ? test::try_strips(text)
                                       : test::try_planar(format, text);
    ++(ok ? read : refused);
    EXPECT_EQ(ok, !entry.path().filename().string().starts_with("bad"));
  }
  EXPECT_GT(read, 10U);
}

}  // namespace
}  // namespace quadloom
