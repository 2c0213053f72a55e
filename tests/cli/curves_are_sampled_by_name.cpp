// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

constexpr const char* kDrawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg"><ellipse cx="0" cy="0" rx="30" ry="10"/></svg>)";
constexpr const char* kWedge = R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L100 -10L100 10Z"/></svg>)";

}  // namespace

TEST_CASE("a drawing is sampled by local feature size, and the theorem is proved for what is written") {
  const TemporaryFolder folder;
  const std::string file = (folder / "dense.poff").string();
  const RunResult made = run({"sample", "-", "--epsilon", "0.2", "-o", file}, {.input = kDrawing});
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  CHECK_THAT(made.err, Catch::Contains("the theorem is proved for these samples"));
  const RunResult computed = run({"compute", file, "--layers", "curve,medial-axis", "--no-timing"});
  REQUIRE(computed.exit_code == 0);
  const Json out = Json::parse(computed.out);
  CHECK(out["input"]["contours"] == 1);
  CHECK(out["diagnostics"]["theorem"] == "green");
}

TEST_CASE("rules are what options ask for, and can be named") {
  const auto samples = [](std::vector<std::string> options) {
    options.insert(options.begin(), {"sample", "-"});
    const RunResult made = run(options, {.input = kDrawing});
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
    return std::stoul(made.out.substr(made.out.find(' ') + 1));
  };
  CHECK(samples({"--samples", "100"}) == 100);
  CHECK(samples({"--spacing", "1"}) > 130);
  CHECK(samples({"--rule", "vertices"}) < 20);
  CHECK(samples({"--rule", "curvature", "--samples", "60"}) > 60);
  CHECK(samples({"--rule", "nearness", "--samples", "50"}) >= 50);
  CHECK(samples({"--rule", "feature-size"}) > samples({"--epsilon", "0.5"}));
}

TEST_CASE("corners are said to be in the way of an epsilon, and can be rounded") {
  const RunResult sharp = run({"sample", "-", "--rule", "feature-size"}, {.input = kWedge});
  CHECK(sharp.exit_code == 0);
  CHECK_THAT(sharp.err, Catch::Contains("epsilon 0.2") && Catch::Contains("(3 corners exempt); "));
  const RunResult round = run({"sample", "-", "--rule", "feature-size", "--corner-radius", "2"}, {.input = kWedge});
  CHECK_THAT(round.err, !Catch::Contains("corner") && Catch::Contains("the theorem is proved"));
}

TEST_CASE("samples without curves get curves through them") {
  const RunResult sparse = run({"shape", "ellipse", "--samples", "40"});
  REQUIRE(sparse.exit_code == 0);
  const RunResult dense = run({"sample", "-", "--samples", "300"}, {.input = sparse.out});
  INFO(dense.err);
  REQUIRE(dense.exit_code == 0);
  CHECK_THAT(dense.out, Catch::StartsWith("POFF 300 "));
}

TEST_CASE("samplings that make no sense end the command in one line") {
  struct Case {
    std::vector<std::string> options;
    int exit_code;
    std::string says;
  };
  for (const Case& test :
       std::vector<Case>{{{"--rule", "dense"}, 2, "--rule: there is no rule \"dense\"; the rules are vertices"},
                         {{"--rule", "number", "--turn", "5"},
                          2,
                          "--turn is for the rule curvature, and samples are taken by the rule number"},
                         {{"--spacing", "1", "--epsilon", "0.2"}, 2, "--epsilon is for the rule feature-size"},
                         {{"--rule", "spacing"}, 2, "the rule spacing needs --spacing"},
                         {{"--epsilon", "2"}, 2, "epsilon must be from 0.01 to 1"},
                         {{"--epsilon", "x"}, 2, "--epsilon expects a number, not \"x\""},
                         {{"--jitter", "-1"}, 2, "the jitter must be from 0 to 100"},
                         {{"--corner-radius", "-1"}, 2, "the radius of corners must not be negative"},
                         {{"--spacing", "1e-9"}, 3, "as many as there may be"},
                         {{"--spacing", "5e-324"}, 3, "the curves would have far too many samples;"},
                         {{"--turn", "0.001"}, 2, "the turn between samples must be from 0.06 to 183 degrees"},
                         {{"--corner-angle", "190"}, 2, "the angle of corners must be from 0 to 183 degrees"}}) {
    std::vector<std::string> arguments{"sample", "-"};
    arguments.insert(arguments.end(), test.options.begin(), test.options.end());
    const RunResult result = run(arguments, {.input = kDrawing});
    INFO(result.err);
    CHECK(result.exit_code == test.exit_code);
    CHECK_THAT(result.err, Catch::Contains(test.says));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  }
  // Options that name no rule ask for one, and two of them exclude each other.
  const std::string wkt = "POLYGON ((0 0, 10 0, 10 4, 0 4, 0 0))";
  CHECK(run({"sample", "-", "--vertices"}, {.input = wkt}).out.starts_with("POFF 4 0 0\n"));
  for (const std::vector<std::string>& other : {std::vector<std::string>{"--vertices", "--samples", "50"},
                                                {"--vertices", "--rule", "spacing", "--spacing", "1"},
                                                {"--samples", "50", "--spacing", "1"}}) {
    std::vector<std::string> arguments{"sample", "-"};
    arguments.insert(arguments.end(), other.begin(), other.end());
    CHECK(run(arguments, {.input = wkt}).exit_code == 2);
  }
  CHECK(run({"sample", "-"}, {.input = "POFF 0 0 0\n"}).exit_code == 3);
  CHECK(run({"sample", "-"}, {.input = "POFF 1 0 0\n3 4\n"}).exit_code == 0);
}
