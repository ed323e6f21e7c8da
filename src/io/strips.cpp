// .strip: triangles as strips of vertices, a text of words.
//
//     strips 1                   the format and its version
//     encoding restart           swap, repeat or restart
//     restart 4294967295         the index that begins a new strip (not with repeat)
//     points 4 2                 how many, and with how many coordinates
//     0 0
//     ...
//     indices 4                  the code, from 0
//     0 1 2 3
//     swaps 1                    (swap only) the places in the code, from 0, whose bit is set
//     3

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/output.hpp"
#include "io/strip_readers.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"swap", "repeat", "restart"};

class StripReader {
 public:
  explicit StripReader(const Source& source) : source_(source), words_(source) {}

  StripFile read() {
    require_word("strips");
    if (words_.index("the version") != 1) words_.fail("only version 1 of .strip is known");
    read_encoding();
    read_points();
    read_indices();
    if (file_.code.encoding == StripEncoding::kSwap) read_swaps();
    const auto more = words_.next();
    if (!more.empty()) words_.fail(fmt::format("{} after the end", in_quotes(more)));
    return std::move(file_);
  }

 private:
  void require_word(std::string_view word) {
    const auto found = words_.require(fmt::format("the word {}", word));
    if (found != word)
      words_.fail(fmt::format("{} instead of the word {}", in_quotes(found), word));
  }

  std::uint64_t count_after(std::string_view word) {
    require_word(word);
    return words_.index(fmt::format("the count of {}", word));
  }

  void read_encoding() {
    require_word("encoding");
    const auto name = words_.require("an encoding");
    const auto* found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
      words_.fail(
          fmt::format("{} is none of the encodings swap, repeat, restart", in_quotes(name)));
    }
    file_.code.encoding = static_cast<StripEncoding>(found - kNames.begin());
    if (file_.code.encoding == StripEncoding::kRepeat) return;
    require_word("restart");
    if (words_.index("the restart index") != kStripRestart) {
      words_.fail(fmt::format("the restart index must be {}", kStripRestart));
    }
  }

  void read_points() {
    const std::uint64_t count = count_after("points");
    const std::uint64_t coordinates = words_.index("the number of coordinates");
    if (coordinates != 2 && coordinates != 3) words_.fail("points have 2 or 3 coordinates");
    if (count > kMaxPoints) words_.fail("more points than 32-bit indices can number");
    for (std::uint64_t i = 0; i < count; ++i) {
      const double x = words_.finite("x"), y = words_.finite("y");
      file_.points.push_back({x, y});
      if (coordinates == 3) file_.z.push_back(words_.finite("z"));
    }
  }

  void read_indices() {
    const std::uint64_t count = count_after("indices");
    const bool restarts = file_.code.encoding != StripEncoding::kRepeat;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t v = words_.index("an index");
      if (v >= file_.points.size() && !(restarts && v == kStripRestart)) {
        fail_at(source_, words_.line(),
                fmt::format("index {} of {} points", v, file_.points.size()),
                ErrorCode::kIndexOutOfRange);
      }
      file_.code.index.push_back(static_cast<VertexId>(v));
    }
  }

  void read_swaps() {
    file_.code.swap.resize(file_.code.index.size());
    const std::uint64_t count = count_after("swaps");
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t at = words_.index("a place in the code");
      if (at >= file_.code.swap.size()) {
        words_.fail(fmt::format("place {} of {}", at, file_.code.swap.size()));
      }
      file_.code.swap[at] = 1;
    }
  }

  const Source& source_;
  Words words_;
  StripFile file_;
};

void check(const StripFile& file) {
  const bool heights = !file.z.empty();
  if (heights && file.z.size() != file.points.size()) {
    throw Error(ErrorCode::kBadMesh, "strips need a height a point, or none");
  }
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    const Point p = file.points[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && (!heights || std::isfinite(file.z[i])))
      continue;
    throw Error(ErrorCode::kNotFinite, fmt::format("point {} is not finite", i), {i});
  }
  const StripCode& code = file.code;
  for (std::size_t i = 0; i < code.index.size(); ++i) {
    const bool restart = code.encoding != StripEncoding::kRepeat && code.index[i] == kStripRestart;
    if (restart || code.index[i] < file.points.size()) continue;
    throw Error(ErrorCode::kIndexOutOfRange,
                fmt::format("index {} of the code is vertex {} of {}", i, code.index[i],
                            file.points.size()),
                {i, code.index[i]});
  }
  if (code.swap.size() != (code.encoding == StripEncoding::kSwap ? code.index.size() : 0)) {
    throw Error(ErrorCode::kBadMesh, "a code with swaps needs a bit an index, others none");
  }
}

/// A strip a line; without restarts some vertices a line.
void write_indices(Output& out, const StripCode& code) {
  constexpr std::size_t kLine = 24;
  const bool repeat = code.encoding == StripEncoding::kRepeat;
  out << "indices " << code.index.size() << '\n';
  for (std::size_t i = 0; i < code.index.size(); ++i) {
    const bool ends = i + 1 == code.index.size() ||
                      (repeat ? i % kLine == kLine - 1 : code.index[i] == kStripRestart);
    out << code.index[i] << (ends ? '\n' : ' ');
  }
}

void write_swaps(Output& out, const StripCode& code) {
  out << "swaps " << std::count(code.swap.begin(), code.swap.end(), 1) << '\n';
  for (std::size_t i = 0; i < code.swap.size(); ++i) {
    if (code.swap[i] != 0) out << i << '\n';
  }
}

}  // namespace

StripFile read_strips_text(const Source& source) { return StripReader(source).read(); }

StripFile read_strips(const std::string& path) {
  const TextBuffer text = read_file(path);
  return read_strips_text({source_name(path), without_mark(text.view())});
}

void write_strips(const std::string& path, const StripFile& file) {
  check(file);
  Output out(path);
  out << "strips 1\nencoding " << kNames[static_cast<std::size_t>(file.code.encoding)] << '\n';
  if (file.code.encoding != StripEncoding::kRepeat) out << "restart " << kStripRestart << '\n';
  out << "points " << file.points.size() << (file.z.empty() ? " 2\n" : " 3\n");
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    out << file.points[i].x << ' ' << file.points[i].y;
    if (!file.z.empty()) out << ' ' << file.z[i];
    out << '\n';
  }
  write_indices(out, file.code);
  if (file.code.encoding == StripEncoding::kSwap) write_swaps(out, file.code);
  out.commit();
}

}  // namespace quadloom::io
