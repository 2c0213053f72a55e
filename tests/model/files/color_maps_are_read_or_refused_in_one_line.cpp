// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/store/looks/color_maps.h"
#include "app/store/sample_shapes.h"
#include "core/base/rng.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using render::ColorMap;

namespace {

std::string problem_with(std::string_view bytes) {
  const auto map = parse_color_map(bytes, "a", "a.map");
  return map ? "" : map.error().message();
}

}  // namespace

TEST_CASE("a colour map is a list of triples, however they stand in lines") {
  const auto map = parse_color_map("0 0 0  # black\n1 0.5\n 0.25 1 1 1", "three", "three.map");
  REQUIRE(map);
  CHECK(map->name == "three");
  REQUIRE(map->colors.size() == 3);
  CHECK(map->colors[1] == render::MapColor{1.0F, 0.5F, 0.25F});
  CHECK_FALSE(map->is_categorical);
}

TEST_CASE("what is no colour map is refused with its place") {
  CHECK(problem_with("") == "a.map:1:1: a colour map needs two colours, found 0");
  CHECK(problem_with("0 0 0") == "a.map:1:6: a colour map needs two colours, found 1");
  CHECK(problem_with("0 0 0\n1 1") == "a.map:2:4: the last colour has 2 of three numbers");
  CHECK(problem_with("0 0 0\n1 1 1.5") == "a.map:2:5: red, green and blue are numbers from 0 to 1, not \"1.5\"");
  CHECK(problem_with("0 0 0\n1 -1 1") == "a.map:2:3: red, green and blue are numbers from 0 to 1, not \"-1\"");
  CHECK(problem_with("0 0 0\nred 1 1").starts_with("a.map:2:1: "));
  CHECK(problem_with("0 0 nan 1 1 1").starts_with("a.map:1:5: "));
  CHECK(problem_with("\x89PNG\r\n\x1a\n").find("no colour map") != std::string::npos);
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "0 0 0\n";
  CHECK(problem_with(many) == "a.map:4097:1: a colour map has at most 4096 colours");
}

TEST_CASE("random and truncated bytes give a sound map or one line") {
  Rng random(11);
  const std::string good = "0.267004 0.004874 0.329415\n0.26851 0.009605 0.335427\n# end\n1 1 1\n";
  for (int round = 0; round < 20000; ++round) {
    std::string bytes = good.substr(0, random.below(good.size() + 1));
    for (std::uint64_t i = random.below(4); i > 0 && !bytes.empty(); --i)
      bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    const auto map = parse_color_map(bytes, "a", "a.map");
    if (map) {
      CHECK(map->colors.size() >= 2);
      for (const render::MapColor& color : map->colors)
        for (int i = 0; i < 3; ++i) CHECK((color[i] >= 0.0F && color[i] <= 1.0F));
    } else {
      const std::string text = map.error().message();
      CHECK(text.starts_with("a.map:"));
      CHECK(std::ranges::all_of(text, [](unsigned char c) { return c >= ' ' && c != 127; }));
    }
  }
}

TEST_CASE("the maps of the program lead, those of the user follow, broken ones are reported") {
  const test::TemporaryFolder folder;
  folder.write("bone.map", "0 0 0 1 1 1");
  folder.write("broken.map", "0 0 0 1 1");
  folder.write("viridis.map", "0 0 0 1 1 1");
  folder.write("notes.txt", "no map");
  std::filesystem::create_directory(folder / "folder.map");
  const LoadedColorMaps loaded = load_color_maps(find_assets({}), folder.path());
  std::vector<std::string> names;
  for (const ColorMap& map : loaded.maps) names.push_back(map.name);
  CHECK(names == std::vector<std::string>{"viridis", "cividis", "inferno", "grey", "categories", "bone"});
  REQUIRE(loaded.problems.size() == 3);
  for (const Error& problem : loaded.problems) CHECK(problem.file.find(folder.path().string()) == 0);
  // Its ends as published.
  CHECK(loaded.maps[0].at(0.0) == Rgb{68, 1, 84});
  CHECK(loaded.maps[0].at(1.0) == Rgb{253, 231, 37});

  CHECK(load_color_maps({}, {}).maps.size() == 2);
  CHECK(load_color_maps("/nowhere", "/nowhere").problems.empty());
}
