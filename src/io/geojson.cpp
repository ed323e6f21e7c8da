#include "io/geojson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace quadloom::io {
namespace {

using nlohmann::json;
using Tape = CoordinateTape;

/// Turns the events of the JSON parser into geometries. A stack of frames says where it is; only
/// frames of known members are looked into, so that foreign members may hold anything.
class Walker : public nlohmann::json_sax<json> {
 public:
  Walker(const Source& source, GeojsonVisitor& visitor) : source_(source), visitor_(visitor) {}

  bool null() override { return scalar(std::numeric_limits<double>::quiet_NaN()); }
  bool boolean(bool) override { return other_scalar(); }
  bool number_integer(number_integer_t v) override { return scalar(static_cast<double>(v)); }
  bool number_unsigned(number_unsigned_t v) override { return scalar(static_cast<double>(v)); }
  bool number_float(number_float_t v, const string_t&) override { return scalar(v); }
  bool binary(binary_t&) override { return other_scalar(); }

  bool string(string_t& text) override {
    if (!frames_.empty() && frames_.back().place == Place::kObject && key_ == "type") {
      frames_.back().type = text;
      return true;
    }
    return other_scalar();
  }

  bool key(string_t& text) override {
    key_ = text;
    return true;
  }

  bool start_object(std::size_t) override {
    frames_.push_back({object_place(), {}, false});
    key_.clear();
    return true;
  }

  bool start_array(std::size_t) override {
    const Place place = array_place();
    if (place == Place::kCoordinates) {
      if (top() == Place::kObject) {
        tape_.clear();
        frames_.back().has_coordinates = true;
      }
      tape_.add(Tape::Kind::kOpen);
    }
    frames_.push_back({place, {}, false});
    return true;
  }

  bool end_array() override {
    if (top() == Place::kCoordinates) tape_.add(Tape::Kind::kClose);
    frames_.pop_back();
    return true;
  }

  bool end_object() override {
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    if (frame.place == Place::kObject) finish(frame);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const auto read = source_.text.substr(0, position);
    const auto line = static_cast<std::size_t>(std::ranges::count(read, '\n')) + 1;
    std::string_view what = error.what();
    what.remove_prefix(std::min(what.find("] ") + 2, what.size()));
    const bool overflow = error.id == 406;
    fail_at(source_, line, fmt::format("{}", what),
            overflow ? ErrorCode::kNotFinite : ErrorCode::kParse);
  }

 private:
  enum class Place : std::uint8_t { kNowhere, kObject, kList, kCoordinates, kProperties, kSkipped };
  struct Frame {
    Place place;
    std::string type;
    bool has_coordinates;
  };

  Place top() const { return frames_.empty() ? Place::kNowhere : frames_.back().place; }

  Place object_place() const {
    switch (top()) {
      case Place::kNowhere:
      case Place::kList:
        return Place::kObject;
      case Place::kObject:
        return key_ == "geometry"     ? Place::kObject
               : key_ == "properties" ? Place::kProperties
                                      : Place::kSkipped;
      case Place::kCoordinates:
        fail_in(source_, "coordinates hold an object");
      default:
        return Place::kSkipped;
    }
  }

  Place array_place() const {
    switch (top()) {
      case Place::kNowhere:
        fail_in(source_, "this is no GeoJSON: an array instead of an object");
      case Place::kObject:
        return key_ == "coordinates"                        ? Place::kCoordinates
               : key_ == "features" || key_ == "geometries" ? Place::kList
                                                            : Place::kSkipped;
      case Place::kCoordinates:
        return Place::kCoordinates;
      default:
        return Place::kSkipped;
    }
  }

  bool scalar(double value) {
    if (top() == Place::kCoordinates) {
      if (value != value) fail_in(source_, "null among coordinates");
      tape_.add(value);
    } else if (top() == Place::kProperties) {
      properties_.emplace_back(key_, value);
    } else {
      return other_scalar();
    }
    return true;
  }

  bool other_scalar() {
    if (top() == Place::kNowhere) fail_in(source_, "this is no GeoJSON: no object");
    if (top() == Place::kCoordinates)
      fail_in(source_, "coordinates hold something else than numbers");
    return true;
  }

  void finish(const Frame& frame) {
    if (frame.type == "Feature") {
      visitor_.feature_end(properties_);
      properties_.clear();
    } else if (frame.has_coordinates) {
      if (frame.type.empty()) fail_in(source_, "a geometry without a type");
      visitor_.geometry(frame.type, tape_);
    } else if (frame.type != "FeatureCollection" && frame.type != "GeometryCollection") {
      fail_in(source_, frame.type.empty()
                           ? std::string("this is no GeoJSON: an object without a type")
                           : fmt::format("{} without coordinates", in_quotes(frame.type)));
    }
  }

  const Source& source_;
  GeojsonVisitor& visitor_;
  std::vector<Frame> frames_;
  std::string key_;
  Tape tape_;
  Properties properties_;
};

/// Reads a tape as nested lists of positions.
class TapeReader {
 public:
  TapeReader(const Source& source, std::string_view type, const Tape& tape)
      : source_(source), type_(type), tape_(tape) {}

  /// [ item item ... ]
  template <class Item>
  void list(Item item) {
    open();
    while (at(Tape::Kind::kOpen)) item();
    close();
  }

  Position position() {
    open();
    Position out;
    std::size_t count = 0;
    for (; at(Tape::Kind::kNumber); ++at_, ++count) {
      const double value = tape_.number[number_++];
      if (count == 0) out.x = value + 0.0;
      if (count == 1) out.y = value + 0.0;
      if (count == 2) out.z = value + 0.0;
    }
    if (count < 2) fail();
    out.has_z = count > 2;
    close();
    return out;
  }

  bool is_empty() const { return tape_.kind.size() == 2; }

 private:
  bool at(Tape::Kind kind) const { return at_ < tape_.kind.size() && tape_.kind[at_] == kind; }
  void open() {
    if (!at(Tape::Kind::kOpen)) fail();
    ++at_;
  }
  void close() {
    if (!at(Tape::Kind::kClose)) fail();
    ++at_;
  }
  [[noreturn]] void fail() const {
    fail_in(source_, fmt::format("the coordinates are not those of a {}", type_));
  }

  const Source& source_;
  std::string_view type_;
  const Tape& tape_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

}  // namespace

void CoordinateTape::clear() {
  kind.clear();
  number.clear();
}

void CoordinateTape::add(double value) {
  kind.push_back(Kind::kNumber);
  number.push_back(value);
}

std::vector<Position> positions_of(const Source& source, std::string_view type,
                                   const CoordinateTape& tape) {
  TapeReader reader(source, type, tape);
  std::vector<Position> out;
  if (reader.is_empty()) return out;
  if (type == "Point") {
    out.push_back(reader.position());
  } else {
    reader.list([&] { out.push_back(reader.position()); });
  }
  return out;
}

std::vector<std::vector<Ring>> polygons_of(const Source& source, std::string_view type,
                                           const CoordinateTape& tape) {
  TapeReader reader(source, type, tape);
  std::vector<std::vector<Ring>> out;
  if (reader.is_empty()) return out;
  const auto read_polygon = [&] {
    auto& rings = out.emplace_back();
    reader.list([&] {
      auto& ring = rings.emplace_back();
      reader.list([&] { ring.push_back(reader.position()); });
    });
  };
  if (type == "Polygon") {
    read_polygon();
  } else {
    reader.list(read_polygon);
  }
  return out;
}

void visit_geojson(const Source& source, GeojsonVisitor& visitor) {
  Walker walker(source, visitor);
  json::sax_parse(source.text.begin(), source.text.end(), &walker);
}

std::string json_string(std::string_view text) {
  return json(std::string(text)).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace quadloom::io
