// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>

#include "core/io/format.h"
#include "temporary_folder.h"

using namespace mes;

TEST_CASE("content that names its format outweighs the extension") {
  const auto read = read_sample_bytes("POFF 1 0 0 1 2", "a.csv");
  REQUIRE(read.has_value());
  CHECK(read->format == "poff");
}

TEST_CASE("the extension decides between formats that the content allows") {
  for (const auto& [name, format] : std::vector<std::pair<std::string, std::string>>{
           {"a.xyz", "xyz"}, {"a.TXT", "pairs"}, {"a.csv", "csv"}, {"a", "pairs"}, {"a.unknown", "pairs"}}) {
    const auto read = read_sample_bytes("1 2\n3 4\n", name);
    REQUIRE(read.has_value());
    CHECK(read->format == format);
    CHECK(read->data.positions == std::vector<Vec2>{{1, 2}, {3, 4}});
  }
}

TEST_CASE("a named format is taken at its word") {
  CHECK(read_sample_bytes("1,2\n", "a.poff", "csv").has_value());
  const auto read = read_sample_bytes("1,2\n", "a.csv", "poff");
  REQUIRE_FALSE(read.has_value());
  CHECK_THAT(read.error().text, Catch::Contains("expected \"POFF\""));
}

TEST_CASE("every format has a name, and no extension has two formats") {
  std::set<std::string_view> ids;
  std::set<std::string_view> extensions;
  for (const FormatDescriptor& format : format_descriptors()) {
    CHECK(ids.insert(format.id).second);
    CHECK_FALSE(format.name.empty());
    for (const std::string_view extension : format.extensions) {
      CHECK(extensions.insert(extension).second);
      CHECK(extension.starts_with('.'));
    }
  }
  CHECK(ids.contains("poff"));
}

TEST_CASE("standard streams are read to their end") {
  const test::TemporaryFolder folder;
  std::string bytes = "x,y\n";
  for (int i = 0; i < 30000; ++i) bytes += std::to_string(i) + ",0.5\n";
  const auto path = folder.write("a", bytes);
  std::FILE* const stream = std::fopen(path.c_str(), "rb");
  REQUIRE(stream != nullptr);
  const auto read = read_sample_stream(fileno(stream), "-");
  std::fclose(stream);
  REQUIRE(read.has_value());
  CHECK(read->data.positions.size() == 30000);
  CHECK(read->data.positions.back() == Vec2{29999, 0.5});
}
