// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::run;
using mes::test::RunOptions;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

TEST_CASE("waiting for input, a command ends at the first interruption") {
  const TemporaryFolder folder;
  for (const auto& [signal, code] : std::vector<std::pair<int, int>>{{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    RunOptions options;
    options.input = "POFF 3 0 0\n0 0\n";
    options.keep_input_open = true;
    options.interrupt_with = signal;
    const RunResult result = run({"compute", "-", "-o", (folder / "a.json").string()}, options);
    CHECK(result.exit_code == code);
    CHECK(result.out.empty());
    CHECK(result.err.empty());
    CHECK(folder.file_count() == 0);
  }
}

TEST_CASE("whenever it is interrupted, there is a whole result or none") {
  const TemporaryFolder folder;
  std::string input;
  for (int i = 0; i < 60000; ++i) input += std::to_string(i % 250) + ' ' + std::to_string(i / 250) + ".5\n";
  const std::string samples = folder.write("a.txt", input).string();
  int interrupted = 0;
  for (unsigned delay = 0; delay <= 240; delay += 15) {
    RunOptions options;
    options.interrupt_with = SIGINT;
    options.interrupt_after_ms = delay;
    const RunResult result =
        run({"compute", samples, "--layers", "all", "-o", (folder / "a.json").string()}, options);
    if (result.exit_code != 0) {
      CHECK(result.exit_code == 130);
      ++interrupted;
    }
    // Interrupted between writing and ending, the file may be there; then it is whole.
    if (std::filesystem::exists(folder / "a.json")) {
      CHECK(nlohmann::json::accept(contents_of(folder / "a.json")));
      std::filesystem::remove(folder / "a.json");
    } else {
      CHECK(result.exit_code == 130);
    }
    CHECK(folder.file_count() == 1);
  }
  CHECK(interrupted > 0);
}
