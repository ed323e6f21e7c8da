#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/picture_figures.hpp"
#include "io/picture_frame.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/io.hpp"

// Text needs fontconfig, which keeps what it has allocated.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }

namespace quadloom::io {
namespace {

namespace fs = std::filesystem;

class Picture : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("quadloom_picture_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string draw(const std::string& name, const MeshFile& file, const DrawOptions& options = {}) {
    draw_mesh(path(name), file, options);
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

// Width and height of a PNG.
std::pair<unsigned, unsigned> png_size(const std::string& bytes) {
  const auto number = [&](std::size_t at) {
    unsigned v = 0;
    for (std::size_t i = at; i < at + 4; ++i) v = v << 8 | static_cast<unsigned char>(bytes[i]);
    return v;
  };
  return {number(16), number(20)};
}

MeshFile mesh_of(std::vector<Point> points, const std::vector<std::vector<VertexId>>& faces) {
  MeshFile file;
  file.mesh.points = std::move(points);
  for (const auto& face : faces) file.mesh.add_face(face);
  return file;
}

MeshFile two_quads_and_a_triangle() {
  return mesh_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}, {3, 0}},
                 {{0, 1, 4, 5}, {1, 2, 3, 4}, {2, 6, 3}});
}

TEST_F(Picture, HasTheFormatOfItsName) {
  const MeshFile file = two_quads_and_a_triangle();
  EXPECT_EQ(draw("m.png", file).substr(1, 3), "PNG");
  EXPECT_EQ(draw("m.PDF", file).substr(0, 5), "%PDF-");
  EXPECT_NE(draw("m.svg", file).find("<svg"), std::string::npos);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_TRUE(entry.path().stem() == "m") << entry.path();  // no temporary file stays
  }
}

TEST_F(Picture, HasTheWidthAskedForAndTheMeshsProportions) {
  DrawOptions options;
  options.width = 500;
  options.colour = ColourBy::kNone;
  const auto [width, height] = png_size(draw("m.png", two_quads_and_a_triangle(), options));
  EXPECT_EQ(width, 500U);
  EXPECT_NEAR(height, 500 / 3.0, 30);
}

TEST_F(Picture, IsTheSameEveryTime) {
  EXPECT_EQ(draw("a.png", two_quads_and_a_triangle()), draw("b.png", two_quads_and_a_triangle()));
}

TEST_F(Picture, ShowsAddedPointsTitlesAndOverlays) {
  const MeshFile file = two_quads_and_a_triangle();
  const std::string plain = draw("m.png", file);
  DrawOptions options;
  options.steiner = {4, 12345};  // the second is no vertex and is passed over
  EXPECT_NE(draw("m.png", file, options), plain);
  options = {};
  options.title = "A title & <more>";
  EXPECT_NE(draw("m.png", file, options), plain);
  options = {};
  options.overlay = {{{{0, 0}, {1, 1}, {2, 0}}, false, 0}};
  EXPECT_NE(draw("m.png", file, options), plain);
}

TEST_F(Picture, ShowsGroupsOfFaces) {
  const MeshFile file = two_quads_and_a_triangle();
  DrawOptions options;
  options.colour = ColourBy::kGroup;
  options.group = {0, 0, 0};
  options.group_names = {"others", "barrier", "odd"};
  const std::string plain = draw("m.png", file, options);
  options.group = {0, 1, 2};
  EXPECT_NE(draw("m.png", file, options), plain);
  for (const std::vector<std::uint8_t>& bad :
       {std::vector<std::uint8_t>{0, 1}, std::vector<std::uint8_t>{0, 1, 4}}) {
    options.group = bad;
    EXPECT_THROW(draw("m.png", file, options), Error);
  }
}

TEST_F(Picture, WorksForCoordinatesOfAnySize) {
  for (const double scale : {1e-320, 1e-300, 1e-30, 1e30, 1e300, 8e307}) {
    MeshFile file = two_quads_and_a_triangle();
    for (Point& p : file.mesh.points) p = {(p.x - 1.5) * scale, p.y * scale};
    DrawOptions options;
    options.colour = ColourBy::kNone;
    const auto [width, height] = png_size(draw("m.png", file, options));
    EXPECT_EQ(width, 1600U) << scale;
    EXPECT_NEAR(height, 1600 / 3.0, 80) << scale;
  }
}

TEST_F(Picture, WorksForNothingOnePointALineAndAnEmptyFace) {
  EXPECT_GT(png_size(draw("m.png", MeshFile{})).second, 0U);
  EXPECT_GT(png_size(draw("m.png", mesh_of({{3, 4}}, {}))).second, 0U);
  EXPECT_GT(png_size(draw("m.png", mesh_of({{0, 0}, {1, 0}, {2, 0}}, {}))).second, 0U);
  EXPECT_GT(png_size(draw("m.png", mesh_of({{0, 0}, {0, 1}, {0, 2}}, {{0, 1, 2}}))).second, 0U);
  const MeshFile points = mesh_of(generate_points("decades", 500), {});
  EXPECT_GT(png_size(draw("m.png", points)).second, 0U);
}

TEST_F(Picture, SheetHasRowsAndColumns) {
  const MeshFile file = two_quads_and_a_triangle();
  DrawOptions options;
  options.width = 300;
  const std::vector<Panel> panels(3, Panel{&file, options});
  draw_sheet(path("s.png"), panels, 2);
  draw_sheet(path("one.png"), {panels.data(), 1}, 2);
  const auto size = [&](const char* name) {
    std::ifstream in(path(name), std::ios::binary);
    return png_size({std::istreambuf_iterator<char>(in), {}});
  };
  EXPECT_EQ(size("s.png").first, 600U);
  EXPECT_EQ(size("one.png").first, 300U);
  EXPECT_EQ(size("s.png").second, 2 * size("one.png").second);
}

TEST_F(Picture, RefusesWhatItCannotDraw) {
  const MeshFile file = two_quads_and_a_triangle();
  const auto code = [&](const std::string& name, const DrawOptions& options) {
    try {
      draw_mesh(path(name), file, options);
    } catch (const Error& e) {
      return e.code();
    }
    return ErrorCode::kCancelled;
  };
  DrawOptions narrow, wide;
  narrow.width = 10;
  wide.width = 1000000;
  EXPECT_EQ(code("m.jpg", {}), ErrorCode::kBadOption);
  EXPECT_EQ(code("m", {}), ErrorCode::kBadOption);
  EXPECT_EQ(code("m.png", narrow), ErrorCode::kBadOption);
  EXPECT_EQ(code("m.png", wide), ErrorCode::kBadOption);
  EXPECT_EQ(code("nowhere/m.png", {}), ErrorCode::kFile);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST(PictureFrame, KeepsProportionsUnlessTheBoxIsVeryLong) {
  const std::vector<Point> box = {{10, 20}, {14, 22}};
  const Frame frame(box, {});
  EXPECT_DOUBLE_EQ(frame.ratio(), 0.5);
  EXPECT_DOUBLE_EQ(frame.stretch(), 1);
  const PageRect page{100, 50, 400, 200};
  EXPECT_EQ(frame.place({10, 20}, page), (Point{100, 250}));
  EXPECT_EQ(frame.place({14, 22}, page), (Point{500, 50}));
  EXPECT_EQ(frame.place({12, 21}, page), (Point{300, 150}));

  const std::vector<Point> rod = {{0, 0}, {1e9, 1}};
  EXPECT_GT(Frame(rod, {}).stretch(), 1e7);
  const std::vector<Polyline> overlay = {{{{18, 20}}, false, 0}};
  EXPECT_DOUBLE_EQ(Frame(box, overlay).ratio(), 0.25);
}

TEST(PictureFigures, CountsKindsExactly) {
  const double up = 0x1p-60;
  const MeshFile file =
      mesh_of({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}, {1, up}, {1, -up}},
              {{0, 1, 2, 4}, {0, 5, 2, 4}, {0, 6, 2, 4}, {0, 2, 3}, {0, 1, 2, 3, 4}});
  const FaceFigures figures = measure_faces(file.mesh, ColourBy::kConvexity);
  EXPECT_EQ(figures.kind, (std::vector<FaceKind>{FaceKind::kFlatCornered, FaceKind::kNonConvex,
                                                 FaceKind::kStrictlyConvex, FaceKind::kTriangle,
                                                 FaceKind::kFlatCornered}));
  EXPECT_FALSE(figures.quads_only);
  EXPECT_TRUE(figures.shape.empty());
}

TEST(PictureFigures, ShapeIsOneForEqualAnglesAndZeroForAFlatCorner) {
  const MeshFile file =
      mesh_of({{0, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 0}, {3, 0}}, {{0, 1, 2, 3}, {0, 4, 1, 2, 3}});
  EXPECT_DOUBLE_EQ(face_shape(file.mesh, 0), 1);
  EXPECT_NEAR(face_shape(file.mesh, 1), 0, 1e-12);
  MeshFile hexagon = mesh_of(generate_points("circle", 6, 1), {});
  std::sort(hexagon.mesh.points.begin(), hexagon.mesh.points.end(),
            [](Point a, Point b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
  hexagon.mesh.add_face(std::vector<VertexId>{0, 1, 2, 3, 4, 5});
  EXPECT_NEAR(face_shape(hexagon.mesh, 0), 1, 1e-12);
}

}  // namespace
}  // namespace quadloom::io
