// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
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

TEST_CASE("waiting for a pipe on either side, a command ends at the first interruption") {
  const TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string samples = folder.write("a.poff", "POFF 3 0 0\n0 0\n1 0\n0 1\n").string();
  const std::vector<std::vector<std::string>> commands{
      {"compute", pipe}, {"compute", samples, "-o", pipe}, {"evolve", pipe, "--evolution", "smooth", "--steps", "1"}};
  for (const std::vector<std::string>& command : commands) {
    const RunResult result = run(command, {.interrupt_with = SIGTERM});
    CHECK(result.exit_code == 143);
    CHECK(result.out.empty());
    CHECK(folder.file_count() == 2);
  }
}

namespace {

/// A take is made, and then the program that is to make a video of it never ends.
struct Filming {
  TemporaryFolder folder;
  Filming() {
    for (const char* name : {"bin", "tmp", "out"}) std::filesystem::create_directory(folder / name);
    const auto program =
        folder.write("bin/ffmpeg",
                     "#!/bin/sh\nfor last; do :; done\necho half > \"${last#file:}\"\necho $$ > \"$STARTED\"\n"
                     "exec sleep 1000\n");
    ::chmod(program.c_str(), 0755);
  }
  RunOptions options(int signal) const {
    return {.environment = {"PATH=" + (folder / "bin").string() + ":/usr/bin:/bin",
                            "TMPDIR=" + (folder / "tmp").string(), "STARTED=" + started().string()},
            .interrupt_with = signal,
            .interrupt_when = [this] { return !contents_of(started()).empty(); }};
  }
  std::vector<std::string> command() const {
    return {"play", "tests/data/edited_bean.json", "--size", "64x48", "--video", (folder / "out" / "a.mp4").string()};
  }
  std::filesystem::path started() const { return folder / "started"; }
  std::size_t files_in(const char* name) const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder / name), {}));
  }
  bool maker_runs() const {
    const pid_t pid = std::stoi(contents_of(started()));
    std::ifstream status("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("State:")) return line.find('Z') == std::string::npos;
    return false;
  }
};

}  // namespace

TEST_CASE("interrupted while a video is made, a command leaves neither frames nor a part of it nor its maker") {
  for (const auto& [signal, code] : std::vector<std::pair<int, int>>{{SIGINT, 130}, {SIGTERM, 143}}) {
    const Filming filming;
    const RunResult result = run(filming.command(), filming.options(signal));
    CHECK(result.exit_code == code);
    CHECK(filming.files_in("tmp") == 0);
    CHECK(filming.files_in("out") == 0);
    CHECK_FALSE(filming.maker_runs());
  }
}

TEST_CASE("what a killed command leaves is removed by the next one") {
  const Filming filming;
  REQUIRE(run(filming.command(), filming.options(SIGKILL)).exit_code == -SIGKILL);
  ::kill(std::stoi(contents_of(filming.started())), SIGKILL);
  CHECK(filming.files_in("tmp") == 1);
  CHECK(filming.files_in("out") == 1);
  filming.folder.write("bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\necho whole > \"${last#file:}\"\n");
  REQUIRE(run(filming.command(), {.environment = filming.options(0).environment}).exit_code == 0);
  CHECK(filming.files_in("tmp") == 0);
  CHECK(filming.files_in("out") == 1);
  CHECK(contents_of(filming.folder / "out" / "a.mp4") == "whole\n");
}
