// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using Json = nlohmann::json;
using mes::test::contents_of;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

// A user without bundles of his own, and without a display.
RunOptions at_home(const TemporaryFolder& folder) {
  RunOptions options;
  options.environment = {"DISPLAY=", "WAYLAND_DISPLAY=", "XDG_DATA_HOME=" + folder.path().string()};
  return options;
}

RunResult render_bean(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"render", "assets/shapes/bean.poff", "--size", "90x80", "-o", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments, at_home(folder));
}

const std::string kTwo = R"({"mesecina":"bundles","schema":1,"bundles":[
  {"name":"mine","layers":[{"layer":"points","visible":true,"style":{"color":"#FF0000"}}]},
  {"name":"crust","layers":[{"layer":"points","visible":true},{"layer":"of tomorrow","visible":true}]}]})";

}  // namespace

TEST_CASE("bundles are listed, those of the user first") {
  const TemporaryFolder folder;
  const Json built_in = Json::parse(run({"list", "bundles", "--json"}, at_home(folder)).out);
  CHECK(built_in.size() >= 9);
  CHECK(built_in[0]["built_in"] == true);
  std::filesystem::create_directory(folder / "mesecina");
  folder.write("mesecina/bundles.json", kTwo);
  const Json all = Json::parse(run({"list", "bundles", "--json"}, at_home(folder)).out);
  CHECK(all.size() == built_in.size() + 2);
  CHECK(all[0]["id"] == "mine");
  CHECK(all[0]["built_in"] == false);
  CHECK(all[0]["layers"] == Json{"points"});
}

TEST_CASE("a broken file of bundles is reported and left alone") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "mesecina");
  folder.write("mesecina/bundles.json", "{");
  const RunResult result = run({"list", "bundles"}, at_home(folder));
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("this is not JSON"));
  CHECK(contents_of(folder / "mesecina/bundles.json") == "{");
}

TEST_CASE("a picture is drawn as a bundle has it") {
  const TemporaryFolder folder;
  const RunResult built_in = render_bean(folder, {"--bundle", "Inner disks"});
  CHECK(built_in.exit_code == 0);
  CHECK(built_in.err.empty());
  CHECK(built_in.out == render_bean(folder, {"--bundle", "inner DISKS"}).out);
  const std::string file = folder.write("two.json", kTwo).string();
  const RunResult red = render_bean(folder, {"--bundle", file});
  CHECK(red.exit_code == 0);
  CHECK_THAT(red.err, Catch::Contains("the first of its 2 bundles is taken, \"mine\""));
  CHECK(red.out != render_bean(folder, {"--layers", "points"}).out);
  const RunResult second = render_bean(folder, {"--bundle", file + ":CRUST"});
  CHECK(second.exit_code == 0);
  CHECK_THAT(second.err, !Catch::Contains("the first"));
  CHECK(second.out == render_bean(folder, {"--layers", "points"}).out);
  const RunResult changed = render_bean(folder, {"--bundle", file, "--set-style", "points:color=00ff00"});
  CHECK(changed.exit_code == 0);
  CHECK(changed.out != red.out);
}

TEST_CASE("a bundle that is not there is refused with the nearest names") {
  const TemporaryFolder folder;
  const RunResult unknown = render_bean(folder, {"--bundle", "Inner dsks"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.err, Catch::Contains("did you mean Inner disks"));
  CHECK(render_bean(folder, {"--bundle", "Inner disks", "--layers", "points"}).exit_code == 2);
  CHECK(render_bean(folder, {"--bundle", "none.bnd"}).exit_code == 3);
  const RunResult of_file = render_bean(folder, {"--bundle", "assets/bundles/starting.json:Crsut"});
  CHECK(of_file.exit_code == 2);
  CHECK_THAT(of_file.err, Catch::Contains("starting.json") && Catch::Contains("did you mean Crust"));
  CHECK(render_bean(folder, {"--bundle", "tests/data/earcut_dude.poff"}).exit_code == 3);
  CHECK(render_bean(folder, {"--bundle", folder.path().string()}).exit_code == 3);
}
