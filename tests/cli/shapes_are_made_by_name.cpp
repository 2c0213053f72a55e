// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

TEST_CASE("a shape is a file that other commands read") {
  const TemporaryFolder folder;
  const std::string file = (folder / "gear.poff").string();
  const RunResult made =
      run({"shape", "gear", "--set", "teeth=9", "--set", "inner=0.7", "--samples", "700", "-o", file});
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  const RunResult computed = run({"compute", file, "--layers", "curve", "--no-timing"});
  REQUIRE(computed.exit_code == 0);
  const Json out = Json::parse(computed.out);
  CHECK(out["input"]["contours"] == 1);
  CHECK(out["structures"]["samples"]["width"].get<double>() == Approx(2.0).epsilon(0.03));
  // Balls are WPOFF, and standard output is where nothing else is named.
  CHECK_THAT(run({"shape", "balls-along-curve"}).out, Catch::StartsWith("WPOFF 24 0 0"));
  CHECK_THAT(run({"shape", "polar", "--set", "r=2"}).out, Catch::StartsWith("POFF "));
}

TEST_CASE("equal seeds give equal bytes") {
  const auto bytes = [](const std::string& seed) {
    return run({"shape", "gaussian", "--samples", "50", "--jitter", "0.1", "--seed", seed}).out;
  };
  CHECK(bytes("3") == bytes("3"));
  CHECK(bytes("3") != bytes("4"));
}

TEST_CASE("every shape that is listed is made, and its samples are drawn") {
  const Json shapes = Json::parse(run({"list", "shapes", "--json"}).out);
  CHECK(shapes.size() == 25);
  for (const Json& shape : shapes) {
    const RunResult made = run({"shape", shape["id"].get<std::string>()});
    INFO(shape["id"] << made.err);
    REQUIRE(made.exit_code == 0);
    CHECK(run({"compute", "-", "--layers", "points,b-inner-disks"}, {.input = made.out}).exit_code == 0);
  }
}

TEST_CASE("wishes that make no sense end the command in one line") {
  struct Case {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  };
  for (const Case& test : std::vector<Case>{
           {{"stra"}, 2, "there is no shape \"stra\"; did you mean star"},
           {{"star", "--set", "foo=1"}, 2, "--set: star has no parameter \"foo\" (mesecina list shapes)"},
           {{"cocircular", "--set", "r=1"}, 2, "--set: cocircular has no parameter \"r\""},
           {{"star", "--set", "points=1"}, 2, "--set points expects a whole number from 2 to 10000, not \"1\""},
           {{"star", "--set", "inner=3"}, 2, "inner must be less than outer"},
           {{"polar", "--set", "r=1 +"}, 2, "the formula of r: "},
           {{"polar", "--set", "r=1/(t - t)"}, 3, "the formula gives no finite number at t = 0"},
           {{"circle", "--samples", "0"}, 2, "--samples expects a whole number from 1 to 10000000, not \"0\""},
           {{"circle", "--spacing", "x"}, 2, "--spacing expects a number"},
           {{"circle", "--spacing", "1e-9"}, 3, "the curves would have"},
           {{"uniform", "--spacing", "1"}, 2, "uniform has no curve"},
           {{"circle", "--seed", "-1"}, 2, "--seed expects a whole number from 0 to 2^64 - 1, not \"-1\""}}) {
    std::vector<std::string> arguments{"shape"};
    arguments.insert(arguments.end(), test.arguments.begin(), test.arguments.end());
    const RunResult result = run(arguments);
    INFO(test.says);
    CHECK(result.exit_code == test.exit_code);
    CHECK(result.out.empty());
    CHECK(std::ranges::count(result.err, '\n') == 1);
    CHECK_THAT(result.err, Catch::StartsWith("mesecina: " + test.says));
  }
}
