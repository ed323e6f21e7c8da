#include "io/vtu_arrays.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>

#include "io/base64.hpp"
#include "io/binary.hpp"
#include "io/text.hpp"

namespace quadloom::io {
namespace {

/// Bytes in memory, decoded only as far as they are asked for: the length of an array is in its
/// header, and in appended data others follow.
class Bytes {
 public:
  static Bytes raw(std::string_view bytes) {
    Bytes out;
    out.raw_ = bytes;
    out.is_raw_ = true;
    return out;
  }
  static Bytes base64(std::string_view text) {
    Bytes out;
    out.text_ = text;
    return out;
  }

  /// At least the first `count` bytes, or all if there are fewer. False if they are no base64.
  bool decode(std::size_t count) {
    return is_raw_ || decoded_.size() >= count || from_base64(text_, count, decoded_);
  }
  std::string_view view() const { return is_raw_ ? raw_ : decoded_; }

 private:
  std::string_view raw_;
  std::string_view text_;
  std::string decoded_;
  bool is_raw_ = false;
};

class ArrayReader {
 public:
  ArrayReader(const Source& source, const VtuEncoding& encoding, pugi::xml_node array)
      : source_(source), encoding_(encoding), array_(array) {}

  std::vector<double> read() {
    const std::string_view format = array_.attribute("format").value();
    if (format == "binary") {
      appended_ = false;
      bytes_ = Bytes::base64(array_.text().get());
      return from_binary();
    }
    if (format == "appended") {
      appended_ = true;
      bytes_ = open_appended();
      return from_binary();
    }
    if (format == "ascii") return from_text();
    fail(fmt::format("has the format {}, only ascii, binary and appended can be read",
                     in_quotes(format)));
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    fail_in(source_,
            fmt::format("the array {} {}", in_quotes(array_.attribute("Name").value()), what));
  }

  Bytes open_appended() const {
    const auto offset = to_integer<std::uint64_t>(array_.attribute("offset").value());
    if (!offset || *offset > encoding_.appended.size()) {
      fail("has no offset into the appended data");
    }
    const auto rest = encoding_.appended.substr(*offset);
    return encoding_.raw ? Bytes::raw(rest) : Bytes::base64(rest);
  }

  std::vector<double> from_text() const {
    const Source text{source_.name, array_.text().get()};
    Words words(text);
    std::vector<double> out;
    for (auto word = words.next(); !word.empty(); word = words.next()) {
      const auto value = to_number(word);
      if (!value) {
        fail_in(source_, fmt::format("{} in the array {} is not a number", in_quotes(word),
                                     in_quotes(array_.attribute("Name").value())));
      }
      out.push_back(*value);
    }
    return out;
  }

  NumberType type() const {
    constexpr std::array<std::string_view, 10> names = {"Int8",    "UInt8",  "Int16", "UInt16",
                                                        "Int32",   "UInt32", "Int64", "UInt64",
                                                        "Float32", "Float64"};
    const std::string_view name = array_.attribute("type").value();
    const auto at = std::ranges::find(names, name);
    if (at == names.end())
      fail_in(source_, fmt::format("{} is no type of numbers", in_quotes(name)));
    return static_cast<NumberType>(at - names.begin());
  }

  std::vector<double> from_binary() {
    if (!encoding_.compressor.empty() && encoding_.compressor != "vtkZLibDataCompressor") {
      fail(fmt::format("is compressed by {}; only vtkZLibDataCompressor can be read",
                       in_quotes(encoding_.compressor)));
    }
    const NumberType number = type();
    std::string uncompressed;
    std::string_view data;
    if (!encoding_.compressor.empty()) {
      uncompressed = read_blocks();
      data = uncompressed;
    } else {
      data = read_plain();
    }
    const std::size_t size = size_of(number);
    if (data.size() % size != 0) {
      fail(fmt::format("has {} bytes, which are no whole numbers of {}", data.size(), size));
    }
    std::vector<double> out;
    out.reserve(data.size() / size);
    for (std::size_t at = 0; at < data.size(); at += size) {
      out.push_back(load_number(data.data() + at, number, encoding_.swap));
    }
    return out;
  }

  // ---- Binary data. ----

  std::size_t header_size() const { return encoding_.long_header ? 8 : 4; }

  /// The first `count` bytes, all there.
  std::string_view require(std::size_t count) {
    if (!bytes_.decode(count)) fail("is no base64");
    if (bytes_.view().size() < count) {
      fail(fmt::format("has {} bytes, its header needs {}", bytes_.view().size(), count));
    }
    return bytes_.view();
  }

  /// Number i of the header.
  std::uint64_t header(std::size_t i) {
    const char* const at = require(header_size() * (i + 1)).data() + header_size() * i;
    return encoding_.long_header ? load<std::uint64_t>(at, encoding_.swap)
                                 : load<std::uint32_t>(at, encoding_.swap);
  }

  /// More bytes than the whole file has are not asked for.
  void check_possible(std::uint64_t bytes) const {
    if (bytes <= source_.text.size()) return;
    fail(fmt::format("has a header that says {} bytes, which the file has not", bytes));
  }

  //    [size][data]
  std::string_view read_plain() {
    const std::uint64_t size = header(0);
    check_possible(size);
    const auto out = require(header_size() + size);
    if (!appended_ &&
        (!bytes_.decode(std::string_view::npos) || bytes_.view().size() != header_size() + size)) {
      fail(fmt::format("has {} bytes, its header says {}", bytes_.view().size() - header_size(),
                       size));
    }
    return (appended_ ? out : bytes_.view()).substr(header_size(), size);
  }

  //    [blocks][size of a block][size of the last block, or 0][compressed size of each block]
  //    [compressed block]...
  std::string read_blocks() {
    const std::uint64_t blocks = header(0);
    if (blocks == 0) return {};
    check_possible(blocks);
    const std::uint64_t block_size = header(1), last_size = header(2);
    std::size_t at = header_size() * (3 + blocks);
    require(at);
    std::string out;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t packed = header(3 + b);
      check_possible(packed);
      const bool last = b + 1 == blocks && last_size > 0;
      unpack(require(at + packed).substr(at, packed), last ? last_size : block_size, out);
      at += packed;
    }
    return out;
  }

  void unpack(std::string_view packed, std::uint64_t size, std::string& out) const {
    constexpr std::uint64_t most_shrunk = 1032;  // what zlib's format can do at best
    if (size / most_shrunk > packed.size()) {
      fail(fmt::format("has a block of {} bytes that says it holds {}", packed.size(), size));
    }
    const std::size_t before = out.size();
    out.resize(before + size);
    auto got = static_cast<uLongf>(size);
    const int result = uncompress(reinterpret_cast<Bytef*>(out.data() + before), &got,
                                  reinterpret_cast<const Bytef*>(packed.data()),
                                  static_cast<uLong>(packed.size()));
    if (result != Z_OK || got != size) fail("has a block that zlib cannot uncompress");
  }

  const Source& source_;
  const VtuEncoding& encoding_;
  pugi::xml_node array_;
  bool appended_ = false;
  Bytes bytes_;
};

}  // namespace

std::vector<double> read_vtu_array(const Source& source, const VtuEncoding& encoding,
                                   pugi::xml_node array) {
  return ArrayReader(source, encoding, array).read();
}

}  // namespace quadloom::io
