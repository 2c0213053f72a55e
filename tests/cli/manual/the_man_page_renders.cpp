// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

TEST_CASE("the man page names each command and each key") {
  const std::string page = run({"manual", "--man"}).out;
  CHECK_THAT(page, Catch::Contains(".TH MESECINA 1"));
  for (const std::string command : {"compute", "sweep", "branches", "persistence", "repair", "decimate", "export",
                                    "render", "play", "demo", "evolve", "list", "manual", "completions"})
    CHECK_THAT(page, Catch::Contains(".SS mesecina " + command + '\n'));
  for (const std::string title : {"NAME", "SYNOPSIS", "EXAMPLES", "EXIT CODES", "KEYS OF THE WINDOW", "FILES"})
    CHECK_THAT(page, Catch::Contains(".SH " + title + '\n'));
  for (const nlohmann::json& action : nlohmann::json::parse(run({"list", "actions", "--json"}).out)) {
    if (action["keys"].empty()) continue;
    INFO(action["id"]);
    CHECK_THAT(page, Catch::Contains(action["name"].get<std::string>() + ':'));
  }
}

TEST_CASE("the man page renders without a warning") {
  const TemporaryFolder folder;
  const auto file = (folder / "mesecina.1").string();
  REQUIRE(run({"manual", "--man", "-o", file}).exit_code == 0);
  if (run({"-c", "command -v groff"}, {.program = "sh"}).exit_code != 0) {
    WARN("groff is not installed: the man page is not rendered");
    return;
  }
  const RunResult rendered = run({"-man", "-Tutf8", "-Kutf8", "-ww", file}, {.program = "groff"});
  CHECK(rendered.exit_code == 0);
  CHECK(rendered.err.empty());
  CHECK_THAT(rendered.out, Catch::Contains("medial"));
}
