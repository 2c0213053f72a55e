// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments that come with the program, and those in its documents.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "workshop.h"

using namespace mes::test;
using Json = nlohmann::json;

TEST_CASE("the examples hold what structures have to hold") {
  const Workshop workshop;
  std::vector<std::string> words{"check"};
  // The axis of the polygon has a case of its own, for checking it takes minutes.
  for (const auto& entry : fs::directory_iterator("examples/experiments"))
    if (!entry.path().filename().string().starts_with("polygon_axis")) words.push_back(entry.path().string());
  CHECK(words.size() > 8);
  const std::string table = workshop.output_of(words);
  INFO(table);
  CHECK_THAT(table, Catch::Contains("gabriel"));
}

TEST_CASE("an example has the exact axis of a polygon, with a library of its own") {
  const Workshop workshop;
  const std::string file = workshop.write("box.poff", "POFF 4 0 0\n0 0\n4 0\n4 2\n0 2\n# loop closed 0 1 2 3\n");
  const Json out =
      Json::parse(workshop.output_of({"compute", file, "--with", "examples/experiments/polygon_axis.cpp", "--layers",
                                      "polygon-axis-lines,polygon-axis-arcs", "--no-timing"}));
  // The middle, and a diagonal to each corner.
  CHECK(out["layers"]["polygon-axis-lines"]["segments"] == 5);
  CHECK(out["layers"]["polygon-axis-lines"]["length"].get<double>() == Approx(2.0 + 4.0 * std::sqrt(2.0)));
  CHECK(out["layers"]["polygon-axis-arcs"]["segments"] == 0);
}

TEST_CASE("the sources in the documentation hold what they have to hold") {
  const Workshop workshop;
  const std::string text = content_of("docs/experiments.md");
  const std::string begin = "```cpp\n";
  int count = 0;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    const std::string file =
        workshop.write("block" + std::to_string(++count) + ".cpp", text.substr(from, text.find("```", from) - from));
    CHECK_THAT(workshop.output_of({"check", file}), Catch::Contains(" ok, "));
  }
  CHECK(count == 3);
}
