// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

void require_one_line(const RunResult& result, int exit_code, const std::string& beginning) {
  INFO(result.err);
  CHECK(result.exit_code == exit_code);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith(beginning));
  CHECK(std::ranges::count(result.err, '\n') == 1);
  CHECK(result.err.ends_with('\n'));
  CHECK(result.err.size() < 500);
}

}  // namespace

TEST_CASE("what is wrong with a file is said with its place, by every command") {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.poff", "POFF 2 0 0\n1 2\n3 nan\n").string();
  const std::string says = "mesecina: " + bad + ":3:3: \"nan\" is not a finite number";
  require_one_line(run({"compute", bad}), 3, says);
  require_one_line(run({"export", bad, "--layer", "points", "--format", "csv"}), 3, says);
  require_one_line(run({"render", bad, "-o", (folder / "a.png").string()}), 3, says);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a negative radius is refused with its place") {
  require_one_line(run({"compute", "-"}, {.input = "WPOFF 2 0 0\n0 0 1\n1 1 -2\n"}), 3,
                   "mesecina: -:3:5: the radius is negative: \"-2\"");
}

TEST_CASE("files that are missing, folders and pictures are refused") {
  const TemporaryFolder folder;
  require_one_line(run({"compute", "no/such/file.poff"}), 3,
                   "mesecina: no/such/file.poff: cannot be read: No such file or directory");
  require_one_line(run({"compute", folder.path().string()}), 3,
                   "mesecina: " + folder.path().string() + ": cannot be read: Is a directory");
  const std::string picture = folder.write("p.csv", "\x89PNG\r\n\x1a\n").string();
  require_one_line(run({"compute", picture}), 3,
                   "mesecina: " + picture + ": the picture is broken: the file ends at byte 8, ");
}

TEST_CASE("a file of bundles is not a file of samples, and is recognised") {
  const std::string says = ":1:1: these are bundles of layers, not samples";
  require_one_line(run({"compute", "assets/bundles/starting.json"}), 3,
                   "mesecina: assets/bundles/starting.json" + says);
  require_one_line(run({"compute", "-"}, {.input = std::string("\0\0\0\xB3\0\0\0\1", 8)}), 3, "mesecina: -" + says);
}

TEST_CASE("standard input is called - in messages") {
  require_one_line(run({"compute", "-"}, {.input = "1 2\n3 x\n"}), 3, "mesecina: -:2:3: expected a number");
  require_one_line(run({"compute", "-"}, {.input = ""}), 3, "mesecina: -:1:1: the file is empty");
  require_one_line(run({"compute", "-", "--from", "poff"}, {.input = "1 2\n"}), 3,
                   "mesecina: -:1:1: expected \"POFF\"");
}

TEST_CASE("a token of a million characters and control characters stay out of the terminal") {
  require_one_line(run({"compute", "-"}, {.input = "POFF 1 0 0\n1 " + std::string(1'000'000, 'x')}), 3,
                   "mesecina: -:2:3: expected a number, found \"xxx");
  require_one_line(run({"compute", "-"}, {.input = "POFF 1 0 0\n1 \x1b[31m\n"}), 3,
                   "mesecina: -:2:3: expected a number, found \"\\x1b[31m\"");
  require_one_line(run({"compute", "bad\nname\x1b"}), 3, "mesecina: bad\\x0aname\\x1b: cannot be read");
}

TEST_CASE("what is odd but bearable is said, and the result is given") {
  const RunResult result = run({"compute", "-"}, {.input = "POFF 1 0 0\n1 2 3\n"});
  CHECK(result.exit_code == 0);
  CHECK_FALSE(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: -:2:5: "));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("too little memory is said in one line") {
  std::string input = "POFF 400000 0 0\n";
  for (int i = 0; i < 400000; ++i) {
    const double angle = 1.5e-5 * i;
    const double radius = 1e5 + 3e4 * std::cos(7 * angle);
    input += std::to_string(radius * std::cos(angle)) + ' ' + std::to_string(radius * std::sin(angle)) + '\n';
  }
  // Enough to start and to read, not enough to compute.
  const RunResult result = run({"compute", "-", "--layers", "all"}, {.input = input, .address_space_mib = 300});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: ") && Catch::Contains("memory"));
  CHECK(std::ranges::count(result.err, '\n') == 1);
}
#endif
