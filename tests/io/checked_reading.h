// SPDX-License-Identifier: GPL-3.0-or-later
// Reads files that must be good, or must be refused.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <string_view>

#include "core/io/format.h"

namespace mes::test {

/// Samples are the positions of the file.
constexpr ReadRequest kAtVertices{.keeps_vertices = true};

inline LoadedFile good(const Expected<LoadedFile>& read) {
  INFO((read ? std::string() : read.error().message()));
  REQUIRE(read.has_value());
  return *read;
}

/// Samples are the positions of the map.
inline LoadedFile read_map(std::string_view bytes, const std::string& name = "map", ReadRequest request = {}) {
  request.keeps_vertices = true;
  return good(read_sample_bytes(bytes, name, {}, request));
}

inline void check_refused(std::string_view bytes, const std::string& message, const std::string& name = "a") {
  const auto read = read_sample_bytes(bytes, name);
  INFO(bytes);
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().code == ErrorCode::bad_input);
  CHECK(read.error().message() == name + ":" + message);
}

}  // namespace mes::test
