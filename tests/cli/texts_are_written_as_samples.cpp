// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina text`, with the font that comes with the program.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

TEST_CASE("the crust of letters is their outlines, as many contours as everybody knows") {
  // Each letter by itself, for the crust joins what stands close together; and none with an acute corner, such as those
  // at the ends of a C, where it promises nothing.
  for (const auto& [text, contours] :
       std::vector<std::pair<std::string, int>>{{"B", 3}, {"i", 2}, {"o", 2}, {"8", 3}}) {
    INFO(text);
    const RunResult made = run({"text", text, "--samples", "1500"});
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
    const RunResult computed =
        run({"compute", "-", "--layers", "curve,curve-defects", "--no-timing"}, {.input = made.out});
    REQUIRE(computed.exit_code == 0);
    const Json out = Json::parse(computed.out);
    CHECK(out["input"]["contours"] == contours);
    // As many edges as samples, none of them a defect: the crust is closed curves, and follows the contours.
    CHECK(out["layers"]["curve"]["segments"] == out["input"]["samples"]);
    CHECK(out["layers"]["curve-defects"]["points"] == 0);
  }
}

TEST_CASE("size, lines and kerning are as asked, and equal requests give equal bytes") {
  const auto width = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "text");
    const RunResult made = run(arguments);
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
    const RunResult computed = run({"compute", "-", "--layers", "points", "--no-timing"}, {.input = made.out});
    return Json::parse(computed.out)["structures"]["samples"]["width"].get<double>();
  };
  CHECK(width({"AVA", "--size", "200"}) == Approx(2.0 * width({"AVA"})).epsilon(1e-9));
  CHECK(width({"AVA"}) < width({"AVA", "--no-kerning"}));
  CHECK(run({"text", "AVA", "--jitter", "0.1", "--seed", "5"}).out ==
        run({"text", "AVA", "--jitter", "0.1", "--seed", "5"}).out);
}

TEST_CASE("fonts that are not there and characters without a glyph end in one line") {
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  };
  for (const Case& test : std::vector<Case>{
           {{"a", "--font", "No Such Font"}, 2, "there is no font \"No Such Font\""},
           {{"a", "--font", "./nowhere.otf"}, 2, "the font file \"./nowhere.otf\" does not exist"},
           {{"a", "--font", "tests/data/balls.wpoff"},
            3,
            "tests/data/balls.wpoff: this is not a TrueType or OpenType font"},
           {{"\xE5\xAD\x97"}, 3, "Inter has no glyph for \"\xE5\xAD\x97\" (U+5B57)"},
           {{" "}, 3, "nothing of this text is drawn"},
           {{"a", "--size", "0"}, 2, "the size of a text is a positive number"},
           {{"a", "--size", "big"}, 2, "--size expects a number, not \"big\""},
           {{"a", "--line-spacing=-1"}, 2, "the distance of lines is a number from 0 to 1000"},
           {{"a", "--samples", "0"}, 2, "--samples expects a whole number from 1 to 10000000, not \"0\""},
           {{}, 2, "TEXT is required"}}) {
    std::vector<std::string> arguments = test.arguments;
    arguments.insert(arguments.begin(), "text");
    const RunResult result = run(arguments);
    INFO(result.err);
    CHECK(result.exit_code == test.exit_code);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Catch::StartsWith("mesecina: ") && Catch::Contains(test.says));
    CHECK(std::ranges::count(result.err, '\n') == 1);
  }
  const RunResult some = run({"text", "o\xE5\xAD\x97"});
  CHECK(some.exit_code == 0);
  CHECK(some.err == "mesecina: Inter has no glyph for \"\xE5\xAD\x97\" (U+5B57); left out\n");
}

TEST_CASE("fonts can be listed, as a table and as JSON") {
  const RunResult table = run({"list", "fonts"});
  const RunResult json = run({"list", "fonts", "--json"});
  REQUIRE(table.exit_code == 0);
  REQUIRE(json.exit_code == 0);
  CHECK(static_cast<std::size_t>(std::ranges::count(table.out, '\n')) == Json::parse(json.out).size());
}
