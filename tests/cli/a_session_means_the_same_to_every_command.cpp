// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters, the number type, the layers and the evolution of a session hold for each command that reads it, unless
// the command says otherwise.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "run_binary.h"
#include "tests/cli/inputs.h"
#include "tests/io/temporary_folder.h"

using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;
using mes::test::with;
using nlohmann::json;

namespace {

/// An L of 11 samples with other settings than the defaults.
constexpr const char* kHouseSession = R"({"mesecina":"session","schema":1,
  "data":{"balls":[],"contours":[],"samples":[0,0,1,0,2,0,3,0,4,0,4,1,3,1,2,1,1.5,2,1,1,0,1]},
  "layers":{"layers":[{"layer":"medial-axis","visible":false},{"layer":"curve","visible":true},
                      {"layer":"lambda-medial-axis","visible":true}]},
  "settings":{"precision":"exact","parameters":{"lambda-limit":0.7,"keep-topology":1}},
  "evolution":{"id":"noise","seed":7,"step":0,"parameters":{"noise-factor":0.25}},
  "title":"x","timeline":[]})";

std::string headless_output_of(const std::vector<std::string>& arguments) {
  const RunResult result = run(arguments, {.environment = {"DISPLAY=", "WAYLAND_DISPLAY="}});
  INFO(arguments.front() << ": " << result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

json digests_computed(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "compute");
  arguments.insert(arguments.end(), {"--digest", "--no-timing"});
  json out = json::parse(headless_output_of(arguments));
  out.erase("input");
  return out;
}

json last_played(const std::string& file) {
  json out;
  std::istringstream lines(headless_output_of({"play", file}));
  for (std::string line; std::getline(lines, line);) out = json::parse(line);
  return out;
}

void check_as_played(const std::string& file) {
  const json played = last_played(file)["digests"];
  const json afresh = digests_computed({file})["layers"];
  REQUIRE(!played.empty());
  CHECK(afresh.size() == played.size());
  for (const auto& [layer, digest] : played.items()) {
    CAPTURE(layer);
    CHECK(afresh[layer]["digest"] == digest);
  }
}

struct Files {
  TemporaryFolder folder;
  std::string session = folder.write("s.json", kHouseSession).string();
  std::string samples =
      folder.write("s.poff", headless_output_of({"export", session, "--layer", "points", "--format", "poff"}))
          .string();
};

/// What each command is to be told about the samples alone to do as it does with the session.
const std::vector<std::string> kTold{"--precision", "exact", "--set", "lambda-limit=0.7", "--set", "keep-topology=1"};

}  // namespace

TEST_CASE("compute shows what play shows") {
  const Files files;
  check_as_played(files.session);
  check_as_played("tests/data/edited_bean.json");
  const json own = digests_computed({files.session});
  CHECK(own["precision"] == "exact");
  CHECK(own["layers"].contains("curve"));
  CHECK(own["layers"].contains("lambda-medial-axis"));
  CHECK_FALSE(own["layers"].contains("medial-axis"));
  CHECK(own == digests_computed(with({files.samples, "--layers", "curve,lambda-medial-axis"}, kTold)));
  CHECK(own["layers"] != digests_computed({files.samples, "--layers", "curve,lambda-medial-axis"})["layers"]);
}

TEST_CASE("export, branches, persistence and sweep compute by the session") {
  const Files files;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"export", "", "--layer", "lambda-medial-axis", "--format", "csv"},
        {"export", "", "--layer", "curve,lambda-medial-axis", "--format", "wkt"},
        {"branches", "", "--layer", "lambda-medial-axis"},
        {"persistence", "", "--of", "inner"},
        {"sweep", "", "--parameter", "angle-limit=0..30", "--steps", "2", "--layers",
         "lambda-medial-axis,angle-medial-axis"},
        {"compute", "", "--no-timing", "--layers", "lambda-medial-axis"}}) {
    CAPTURE(command.front());
    const auto of = [&](const std::string& file, const std::vector<std::string>& more = {}) {
      std::vector<std::string> arguments = command;
      arguments[1] = file;
      std::string out = headless_output_of(with(arguments, more));
      // Its name and its format are said.
      if (command.front() == "compute") out = out.substr(out.find("\"precision\""));
      return out;
    };
    CHECK(of(files.session) == of(files.samples, kTold));
    if (command.front() != "persistence") CHECK(of(files.session) != of(files.samples));
    // What the command says goes first, each by itself.
    CHECK(of(files.session, {"--set", "lambda-limit=0"}) ==
          of(files.samples, {"--precision", "exact", "--set", "keep-topology=1"}));
    CHECK(of(files.session, {"--precision", "fast"}) ==
          of(files.samples, {"--set", "keep-topology=1", "--set", "lambda-limit=0.7"}));
  }
  // Without layers those of the session.
  const std::string swept =
      headless_output_of({"sweep", files.session, "--parameter", "angle-limit=0..30", "--steps", "1"});
  CHECK_THAT(swept, Catch::Contains("layers.lambda-medial-axis.length"));
  CHECK_THAT(swept, !Catch::Contains("layers.medial-axis.length"));
}

TEST_CASE("a picture or a figure that carries the session means the same as the session") {
  const Files files;
  const json own = digests_computed({files.session});
  for (const char* name : {"s.png", "s.svg", "s.pdf", "s.ipe"}) {
    CAPTURE(name);
    const std::string file = (files.folder.path() / name).string();
    headless_output_of({"render", files.session, "--size", "200x150", "-o", file});
    CHECK(digests_computed({file}) == own);
    check_as_played(file);
    CHECK(headless_output_of({"branches", file, "--layer", "lambda-medial-axis"}) ==
          headless_output_of({"branches", files.session, "--layer", "lambda-medial-axis"}));
    CHECK(headless_output_of({"evolve", file, "--steps", "2"}) ==
          headless_output_of({"evolve", files.session, "--steps", "2"}));
    // What a command says is carried on, the rest stays.
    const std::string again = (files.folder.path() / (std::string("again-") + name)).string();
    headless_output_of({"render", file, "--set", "lambda-limit=0.2", "--size", "200x150", "-o", again});
    CHECK(digests_computed({again}) == digests_computed({files.session, "--set", "lambda-limit=0.2"}));
  }
}

TEST_CASE("render, too, changes only what it is told") {
  const Files files;
  const auto drawn = [&](const std::vector<std::string>& arguments) {
    const std::string file = (files.folder.path() / "x.svg").string();
    headless_output_of(with(with({"render"}, arguments),
                            {"--no-source", "--no-legend", "--size", "200x150", "--force", "-o", file}));
    return mes::test::contents_of(file);
  };
  const std::vector<std::string> layers{"--layers", "curve,lambda-medial-axis"};
  CHECK(drawn(with({files.session}, layers)) == drawn(with(with({files.samples}, layers), kTold)));
  CHECK(drawn(with({files.session, "--precision", "fast"}, layers)) ==
        drawn(with(with({files.samples}, layers), {"--set", "lambda-limit=0.7", "--set", "keep-topology=1"})));
  CHECK(drawn(with({files.session, "--set", "keep-topology=0"}, layers)) ==
        drawn(with(with({files.samples}, layers), {"--set", "lambda-limit=0.7"})));
}

TEST_CASE("the evolution of a session is that of evolve and of panes, with its seed and parameters") {
  const Files files;
  const std::string own = headless_output_of({"evolve", files.session, "--steps", "3"});
  CHECK(own == headless_output_of({"evolve", files.samples, "--steps", "3", "--evolution", "noise", "--seed", "7",
                                   "--set", "noise-factor=0.25"}));
  CHECK(headless_output_of({"evolve", files.session, "--steps", "3", "--seed", "8"}) ==
        headless_output_of({"evolve", files.samples, "--steps", "3", "--evolution", "noise", "--seed", "8", "--set",
                            "noise-factor=0.25"}));
  CHECK(headless_output_of({"evolve", files.session, "--steps", "3", "--evolution", "smooth"}) ==
        headless_output_of({"evolve", files.samples, "--steps", "3", "--evolution", "smooth"}));
  const RunResult none = run({"evolve", files.samples, "--steps", "3"});
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.err, Catch::Contains("--evolution is required"));
  const auto panes = [&](const std::vector<std::string>& arguments) {
    const std::string file = (files.folder.path() / "x.svg").string();
    headless_output_of(with(
        with({"render"}, arguments),
        {"--compare", "step=0,2", "--layers", "points", "--no-source", "--size", "400x200", "--force", "-o", file}));
    return mes::test::contents_of(file);
  };
  CHECK(panes({files.session}) ==
        panes(with({files.samples, "--evolution", "noise:seed=7,noise-factor=0.25"}, kTold)));
  CHECK(panes({files.session, "--evolution", "noise:seed=9"}) ==
        panes(with({files.samples, "--evolution", "noise:seed=9,noise-factor=0.25"}, kTold)));
  CHECK(run({"render", files.samples, "--compare", "step=0,2", "-o", (files.folder.path() / "y.svg").string()})
            .exit_code == 2);
}

TEST_CASE("commands that only read samples read those of a session as it is now") {
  const Files files;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"repair"}, {"decimate"}, {"sample", "--samples", "30"}}) {
    CAPTURE(command.front());
    const auto of = [&](const std::string& file) {
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.begin() + 1, file);
      return headless_output_of(arguments);
    };
    CHECK(of(files.session) == of(files.samples));
  }
}

TEST_CASE("a session without layers or settings is as samples are, and layers of a later version are counted") {
  const TemporaryFolder folder;
  const std::string bare =
      folder.write("a.json", R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,4,0,4,3,0,3]}})").string();
  const std::string samples = folder.write("a.poff", "POFF 4 0 0\n0 0\n4 0\n4 3\n0 3\n").string();
  CHECK(digests_computed({bare}) == digests_computed({samples}));
  const RunResult later =
      run({"compute", "-"}, {.input = R"({"mesecina":"session","schema":1,"data":{"samples":[0,0,4,0,4,3,0,3]},
    "layers":{"layers":[{"layer":"of-a-later-version","visible":true},{"layer":"points","visible":true}]}})"});
  CHECK(later.exit_code == 0);
  CHECK_THAT(later.err, Catch::Contains("1 layer is not available here"));
  CHECK(json::parse(later.out)["layers"].size() == 1);
}
