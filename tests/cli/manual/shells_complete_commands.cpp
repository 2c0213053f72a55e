// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

bool is_installed(const std::string& shell) {
  return run({"-c", "command -v " + shell}, {.program = "sh"}).exit_code == 0;
}

// What bash offers for the last of the words.
std::string offered(const TemporaryFolder& folder, const std::string& words) {
  const auto script = folder / "completions";
  if (!std::filesystem::exists(script)) REQUIRE(run({"completions", "bash", "-o", script.string()}).exit_code == 0);
  // Only a shell that is being typed into has it.
  const std::string ask = "compopt() { :; }\n. '" + script.string() + "'\nCOMP_WORDS=(" + words +
                          ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_mesecina\nprintf '%s\\n' \"${COMPREPLY[@]}\"";
  const RunResult result = run({"-c", ask}, {.program = "bash"});
  CHECK(result.err.empty());
  return result.out;
}

}  // namespace

TEST_CASE("each shell can read its completions") {
  const TemporaryFolder folder;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    INFO(shell);
    const auto script = (folder / shell).string();
    REQUIRE(run({"completions", shell, "-o", script}).exit_code == 0);
    if (!is_installed(shell)) continue;
    const RunResult read = run({"-n", script}, {.program = shell});
    CHECK(read.exit_code == 0);
    CHECK(read.err.empty());
  }
}

TEST_CASE("bash offers commands, options and values") {
  const TemporaryFolder folder;
  CHECK(offered(folder, "mesecina exp") == "export\n");
  CHECK(offered(folder, "mesecina --ver") == "--version\n");
  CHECK(offered(folder, "mesecina render --back") == "--background\n");
  CHECK(offered(folder, "mesecina compute --precision na") == "naive\n");
  CHECK(offered(folder, "mesecina render --compare pr") == "precision=\n");
  CHECK(offered(folder, "mesecina compute --precision = na") == "naive\n");
  CHECK(offered(folder, "mesecina compute --set a-sc") == "a-scale=\n");
  CHECK(offered(folder, "mesecina shape gear --set tee") == "teeth=\n");
  CHECK(offered(folder, "mesecina shape gear --set a-sc") == "\n");
  CHECK(offered(folder, "mesecina list color") == "color-maps\n");
  CHECK(offered(folder, "mesecina compute assets/shapes/gea") == "assets/shapes/gear.poff\n");
  CHECK(offered(folder, "mesecina compute --frames x") == "\n");
}

TEST_CASE("bash completes the last of a list of layers") {
  const TemporaryFolder folder;
  CHECK(offered(folder, "mesecina render a.poff --layers theorem") == "theorem-check\n");
  CHECK(offered(folder, "mesecina render a.poff --layers points,theorem") == "points,theorem-check\n");
}

TEST_CASE("a shell without completions is refused") {
  const RunResult result = run({"completions", "tcsh"});
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::Contains("bash, zsh or fish"));
  CHECK(result.out.empty());
}
