// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdlib>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

constexpr const char* kDude = "tests/data/earcut_dude.poff";

}  // namespace

TEST_CASE("an output that cannot be written is exit code 4 and leaves nothing") {
  const TemporaryFolder folder;
  for (const std::string& output : {(folder / "no" / "folder.json").string(), folder.path().string()}) {
    const RunResult result = run({"compute", kDude, "-o", output});
    INFO(result.err);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::StartsWith("mesecina: " + output + ": cannot be written: "));
    CHECK(result.out.empty());
  }
  const RunResult picture = run({"render", kDude, "-o", (folder / "no" / "a.png").string()});
  CHECK(picture.exit_code == 4);
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a standard output that takes nothing is exit code 4") {
  RunOptions options;
  options.out_path = "/dev/full";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"compute", kDude}, {"list", "layers"}, {"export", kDude, "--layer", "points", "--format", "csv"}}) {
    const RunResult result = run(command, options);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Catch::Contains("standard output: cannot be written: No space left"));
  }
}

TEST_CASE("a reader that has had enough is no failure") {
  const TemporaryFolder folder;
  const std::string errors = (folder / "errors").string();
  const std::string command = "(sleep 0.2; exec \"$MESECINA_BINARY\" list layers) 2>" + errors + " | true";
  REQUIRE(std::system(command.c_str()) == 0);
  CHECK(contents_of(errors).empty());
}

TEST_CASE("a failed command leaves an older output as it was") {
  const TemporaryFolder folder;
  const auto output = folder.write("a.json", "old");
  const RunResult result = run({"compute", "-", "-o", output.string()}, {.input = "1 x\n"});
  CHECK(result.exit_code == 3);
  CHECK(contents_of(output) == "old");
  CHECK(folder.file_count() == 1);
}
