// What the tests of readers and writers of meshes share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_formats.hpp"
#include "quadloom/io.hpp"

namespace quadloom::io {

inline void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) << a[i] << ' ' << b[i];
    EXPECT_FALSE(b[i] == 0 && std::signbit(b[i]));
  }
}

inline void expect_same_mesh(const MeshFile& a, const MeshFile& b) {
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  for (const Point p : b.mesh.points) EXPECT_FALSE(p.x == 0 && std::signbit(p.x));
  EXPECT_EQ(a.mesh.face_begin, b.mesh.face_begin);
  EXPECT_EQ(a.mesh.face_vertex, b.mesh.face_vertex);
  expect_same(a.z, b.z);
}

inline void expect_same_data(const std::vector<Attribute>& a, const std::vector<Attribute>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    expect_same(a[i].values, b[i].values);
  }
}

inline MeshFile read(std::string_view format, std::string_view text) {
  for (const auto& known : mesh_formats()) {
    if (known.name == format) return known.read({"mesh", text});
  }
  throw std::logic_error("no such format");
}

inline void expect_square(const MeshFile& file) {
  EXPECT_EQ(file.mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(file.mesh.face_vertex, (std::vector<VertexId>{0, 1, 2, 3}));
}

/// Cut anywhere, with any byte changed or any line lost, a file is read or refused, nothing else.
inline void expect_survives_damage(std::string_view format, const std::string& text) {
  std::size_t refused = 0, tried = 0;
  const auto attempt = [&](const std::string& damaged) {
    ++tried;
    try {
      const auto back = read(format, damaged);
      EXPECT_NO_THROW(check_writable(back));
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("mesh"), std::string::npos);
      ++refused;
    }
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    attempt(text.substr(0, i));
    for (const char c : {'9', '-', ' ', 'x', '\n', '\0', '"', '\xff'}) {
      auto changed = text;
      changed[i] = c;
      attempt(changed);
    }
    if (text[i] == '\n') {
      auto shorter = text;
      shorter.erase(i + 1, text.find('\n', i + 1) - i);
      attempt(shorter);
    }
  }
  EXPECT_GT(refused, tried / 10);
}

struct BadFile {
  std::string format, text, words;
  ErrorCode code = ErrorCode::kParse;
  std::vector<std::size_t> culprits = {};
};

inline void expect_fault(const BadFile& bad) {
  SCOPED_TRACE(bad.format + ": " + bad.text.substr(0, 300));
  try {
    read(bad.format, bad.text);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), bad.code) << error.what();
    EXPECT_NE(std::string(error.what()).find(bad.words), std::string::npos) << error.what();
    EXPECT_EQ(error.culprits(), bad.culprits) << error.what();
  }
}

inline constexpr auto kParse = ErrorCode::kParse;
inline constexpr auto kRange = ErrorCode::kIndexOutOfRange;
inline constexpr auto kInfinite = ErrorCode::kNotFinite;

}  // namespace quadloom::io
