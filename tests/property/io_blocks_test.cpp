// Reading in blocks of lines is reading line by line, whatever the text, its faults and the number of
// threads; writers put out the same bytes.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <limits>
#include <string>

#include "core/random.hpp"
#include "io/line_blocks.hpp"
#include "io/point_readers.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/io.hpp"
#include "quadloom/quadrangulate.hpp"
#include "support/on_threads.hpp"
#include "support/temporary_folder.hpp"

namespace quadloom::io {
namespace {

constexpr std::size_t kWhole = static_cast<std::size_t>(-1);

std::string number_text(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// A table of random lines: points, comments, blank lines, more fields than needed, and, seldom, faults.
std::string any_table(Random& random, char between, bool quotes) {
  const auto pick = [&](std::initializer_list<const char*> words) {
    return std::string(words.begin()[random.below(words.size())]);
  };
  const std::string end = pick({"\n", "\r\n"});
  std::string text = random.below(4) == 0 ? "\xef\xbb\xbf" : "";
  if (random.below(2) == 0) text += std::string("x") + between + "y" + end;
  const bool faults = random.below(2) == 0;
  for (std::size_t lines = random.below(60); lines > 0; --lines) {
    const auto any_number = [&] { return number_text(random.uniform() * 100 - 50); };
    const std::string point = any_number() + between + any_number();
    switch (random.below(faults ? 9 : 8)) {
      case 0:
        text += pick({"", " ", "\t ", "# a comment", "  # 1 2"});
        break;
      case 1:
        text += quotes ? '"' + any_number() + '"' + between + any_number() : point;
        break;
      case 2:
        text += point + between + any_number() + between + pick({"words", "7", "nan"});
        break;
      case 3:
        text += quotes ? point + between + "\"two\nlines\"" : point + "  ";
        break;
      case 8:
        text += pick({"1", "one two", "1e999,1e999", "nan nan", "1,x", "x;1"});
        break;
      default:
        text += point;
    }
    if (lines > 1 || random.below(2) == 0) text += end;
  }
  return text;
}

/// What comes of a text, the fault included, as one value.
template <class Read>
std::string outcome(const Read& read) {
  std::string out;
  try {
    const PointTable table = read();
    for (std::size_t i = 0; i < table.points.size(); ++i) {
      out += std::to_string(table.line[i]) + ": " + number_text(table.points[i].x) + ' ' +
             number_text(table.points[i].y);
      if (!table.z.empty()) out += ' ' + number_text(table.z[i]);
      out += '\n';
    }
  } catch (const Error& error) {
    out = std::to_string(static_cast<int>(error.code())) + error.what();
    for (const std::size_t culprit : error.culprits()) out += ' ' + std::to_string(culprit);
  }
  return out;
}

TEST(LineBlocks, AreTheTextWithItsLines) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::string text;
    for (std::size_t i = random.below(80); i > 0; --i) text += random.below(4) == 0 ? '\n' : 'a';
    const std::size_t bytes = 1 + random.below(30);
    const auto blocks = line_blocks(text, 5, bytes);
    ASSERT_FALSE(blocks.empty());
    std::string joined;
    std::size_t line = 5;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const bool last = i + 1 == blocks.size();
      EXPECT_EQ(blocks[i].first_line, line);
      EXPECT_TRUE(last || (blocks[i].text.ends_with('\n') && blocks[i].text.size() >= bytes));
      joined += blocks[i].text;
      line += static_cast<std::size_t>(std::ranges::count(blocks[i].text, '\n'));
    }
    EXPECT_EQ(joined, text);
  }
}

TEST(TablesInBlocks, AreReadAsLineByLine) {
  std::size_t faults = 0, tables = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const bool csv = seed % 2 == 0;
    const std::string text = any_table(random, csv ? ',' : ' ', csv && seed % 4 == 0);
    SCOPED_TRACE(text);
    const auto read = [&](std::size_t block_bytes) {
      const Source source{"input", text};
      return outcome([&] {
        return csv ? read_csv_points(source, {}, block_bytes)
                   : read_xyz_points(source, {}, block_bytes);
      });
    };
    const std::string wanted = read(kWhole);
    ++(wanted.find("input") == std::string::npos ? tables : faults);
    for (const std::size_t block_bytes : {1U, 7U, 40U, 300U}) EXPECT_EQ(read(block_bytes), wanted);
    for (const int threads : {2, 4}) {
      EXPECT_EQ(on_threads(threads, [&] { return read(20); }), wanted);
    }
  }
  EXPECT_GT(tables, 500U);
  EXPECT_GT(faults, 500U);
}

TEST(TablesInBlocks, ManyBlocksOfALongText) {
  Random random(1);
  std::string text;
  for (std::size_t i = 0; i < 200'000; ++i) {
    text += number_text(random.uniform()) + ' ' + number_text(random.uniform()) + '\n';
  }
  const auto read = [&] { return outcome([&] { return read_xyz_points({"input", text}, {}); }); };
  const std::string wanted = outcome([&] { return read_xyz_points({"input", text}, {}, kWhole); });
  EXPECT_EQ(wanted.substr(wanted.rfind("\n2000") + 1, 7), "200000:");
  for (const int threads : {1, 2, 4}) EXPECT_EQ(on_threads(threads, read), wanted);

  // Faults in several blocks: the first one is named.
  text.insert(text.find('\n', 6'000'000) + 1, "1 late\n");
  text.insert(text.find('\n', 3'000'000) + 1, "1 early\n");
  for (const int threads : {1, 2, 4}) {
    EXPECT_NE(on_threads(threads, read).find("'early' is not a number"), std::string::npos);
  }
}

TEST(Writers, PutOutTheSameBytesOnAnyNumberOfThreads) {
  const auto points = generate_points("uniform", 30'000, 3);
  MeshFile file;
  file.mesh = to_polygon_mesh(quadrangulate_points(points).mesh);
  file.vertex_data.push_back({"number", {}});
  for (std::size_t v = 0; v < file.mesh.points.size(); ++v) {
    file.vertex_data[0].values.push_back(static_cast<double>(v) / 7);
  }
  file.face_data.push_back({"third", std::vector<double>(file.mesh.face_count(), 1.0 / 3)});
  file.edges.push_back({0, 1});
  const test::TemporaryFolder folder;
  const auto written = [&](int threads, const std::string& format) {
    const std::string path = folder.path("mesh." + std::to_string(threads));
    on_threads(threads, [&] { write_mesh(path, file, format); });
    return folder.read("mesh." + std::to_string(threads));
  };
  for (const char* format : {"obj", "off", "ply", "vtu", "vtu-ascii", "msh", "msh22", "geojson"}) {
    SCOPED_TRACE(format);
    const std::string wanted = written(1, format);
    EXPECT_GT(wanted.size(), 100'000U);
    for (const int threads : {2, 4}) EXPECT_TRUE(written(threads, format) == wanted);
    const MeshFile back = read_mesh(folder.path("mesh.1"), format);
    if (std::string(format) == "geojson") continue;  // vertices by the order of the faces
    EXPECT_EQ(back.mesh.points, file.mesh.points);
    EXPECT_EQ(back.mesh.face_vertex, file.mesh.face_vertex);
  }
}

TEST(Writers, TheFirstNumberThatCannotBeWrittenIsNamed) {
  auto points = generate_points("uniform", 30'000, 3);
  points[20'000].x = std::numeric_limits<double>::infinity();
  points[25'000].y = std::numeric_limits<double>::quiet_NaN();
  const test::TemporaryFolder folder;
  for (const int threads : {1, 2, 4}) {
    try {
      on_threads(threads, [&] { write_points(folder.path("points.xyz"), points); });
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("inf"), std::string::npos) << error.what();
    }
    EXPECT_EQ(folder.file_count(), 0U);
  }
}

/// While it lives, no file of this process grows beyond so many bytes.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(Writers, ADiskThatIsFullHalfwayLeavesNothing) {
  const auto points =
      generate_points("uniform", 600'000, 3);  // more than blocks are put together at once
  const test::TemporaryFolder folder;
  folder.write("points.xyz", "old\n");
  for (const rlim_t bytes : {1'000U, 1'000'000U, 15'000'000U}) {
    for (const int threads : {1, 4}) {
      const SmallFiles small(bytes);
      try {
        on_threads(threads, [&] { write_points(folder.path("points.xyz"), points); });
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kFile);
      }
      EXPECT_EQ(folder.read("points.xyz"), "old\n");
      EXPECT_EQ(folder.file_count(), 1U);
    }
  }
}

}  // namespace
}  // namespace quadloom::io
