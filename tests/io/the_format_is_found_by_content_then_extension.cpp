// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>

#include "core/io/format_spec.h"
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
  NamedList<Format> formats;
  add_formats(formats);
  for (const auto& each : formats.all()) {
    const FormatDescriptor& format = each->descriptor;
    CHECK(ids.insert(format.id).second);
    CHECK_FALSE(format.name.empty());
    for (const std::string_view extension : format.extensions) {
      CHECK(extensions.insert(extension).second);
      CHECK(extension.starts_with('.'));
    }
  }
  CHECK(ids.contains("poff"));
}

TEST_CASE("formats that there are can be others than those of the program") {
  NamedList<Format> formats;
  add_formats(formats);
  const auto dots = std::make_shared<const Format>(
      Format{.descriptor = {.id = "dots", .name = "Dots", .extensions = {".dots"}, .can_read = true},
             .match = [](std::string_view bytes) { return bytes.starts_with("...") ? Match::surely : Match::no; },
             .read = [](std::string_view bytes, const std::string&, ReadJob&) -> Expected<LoadedFile> {
               LoadedFile out;
               for (std::size_t i = 0; i < bytes.size(); ++i)
                 out.data.positions.push_back({static_cast<double>(i), 0});
               return out;
             }});
  formats.add("dots", dots);
  const ReadRequest request{.formats = &formats};
  const auto read = read_sample_bytes("....", "a", {}, request);
  REQUIRE(read.has_value());
  CHECK(read->format == "dots");
  CHECK(read->data.positions.size() == 4);
  CHECK_FALSE(read_sample_bytes("....", "a").has_value());
  CHECK(read_sample_bytes("1 2\n", "a.dots", "dots", request)->data.positions.size() == 4);
  CHECK(read_sample_bytes("1 2\n", "a.dots", "dots").error().code == ErrorCode::usage);
  CHECK(read_sample_bytes("x,y\n1,2\n", "a", {}, request)->format == "csv");

  REQUIRE(formats.remove("csv"));
  CHECK(read_sample_bytes("x,y\n1,2\n", "a", "csv", request).error().code == ErrorCode::usage);
  REQUIRE(formats.remove("dots"));
  CHECK(read_sample_bytes("....", "a", {}, request).error().code == ErrorCode::bad_input);
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
