// .strip: what is written is what is read.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/source.hpp"
#include "io/strip_readers.hpp"
#include "quadloom/generate.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom {
namespace {

ErrorCode code_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const Error& e) {
    return e.code();
  }
  return ErrorCode::kCancelled;
}

TEST(IoStrips, RoundTrip) {
  const test::TemporaryFolder folder;
  const Triangulation mesh = delaunay(generate_points("uniform", 200)).mesh;
  for (const bool heights : {false, true}) {
    for (const StripEncoding encoding :
         {StripEncoding::kSwap, StripEncoding::kRepeat, StripEncoding::kRestart}) {
      StripOptions options;
      options.encoding = encoding;
      io::StripFile file{mesh.points, {}, encode_strips(mesh, options).code};
      if (heights) file.z.assign(mesh.points.size(), 1.0 / 3);
      const std::string path = folder.path("m.strip");
      io::write_strips(path, file);
      const io::StripFile back = io::read_strips(path);
      EXPECT_EQ(back.points, file.points);
      EXPECT_EQ(back.z, file.z);
      EXPECT_EQ(back.code.encoding, encoding);
      EXPECT_EQ(back.code.index, file.code.index);
      EXPECT_EQ(back.code.swap, file.code.swap);
    }
  }
}

TEST(IoStrips, FaultsHaveALine) {
  const auto read = [](std::string_view text) {
    return [text] { io::read_strips_text({"m.strip", text}); };
  };
  EXPECT_EQ(code_of(read("")), ErrorCode::kParse);
  EXPECT_EQ(code_of(read("strips 1\nencoding repeat\npoints 1 2\n0 inf\nindices 0\n")),
            ErrorCode::kNotFinite);
  EXPECT_EQ(code_of(read("strips 1\nencoding repeat\npoints 1 2\n0 0\nindices 1\n1\n")),
            ErrorCode::kIndexOutOfRange);
  try {
    io::read_strips_text({"m.strip", "strips 1\nencoding repeat\npoints 1 2\n0 x\nindices 0\n"});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.culprits(), std::vector<std::size_t>{4});
    EXPECT_NE(std::string(e.what()).find("m.strip, line 4"), std::string::npos) << e.what();
  }
}

TEST(IoStrips, RefusesToWriteWhatNobodyCouldRead) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("m.strip");
  io::StripFile file{{{0, 0}, {1, 0}, {0, 1}}, {}, {StripEncoding::kRepeat, {0, 1, 2}, {}}};
  EXPECT_NO_THROW(io::write_strips(path, file));
  file.code.index[2] = 3;
  EXPECT_EQ(code_of([&] { io::write_strips(path, file); }), ErrorCode::kIndexOutOfRange);
  file.code.index[2] = kStripRestart;
  EXPECT_EQ(code_of([&] { io::write_strips(path, file); }), ErrorCode::kIndexOutOfRange);
  file.code = {StripEncoding::kSwap, {0, 1, 2}, {0}};
  EXPECT_EQ(code_of([&] { io::write_strips(path, file); }), ErrorCode::kBadMesh);
  file.code = {};
  file.z = {1};
  EXPECT_EQ(code_of([&] { io::write_strips(path, file); }), ErrorCode::kBadMesh);
  file.z.clear();
  file.points[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of([&] { io::write_strips(path, file); }), ErrorCode::kNotFinite);
}

}  // namespace
}  // namespace quadloom
