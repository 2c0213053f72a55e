// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "run_binary.h"

using mes::test::run;
using mes::test::RunResult;

namespace {

RunResult evolve(const std::string& input, std::vector<std::string> arguments) {
  std::vector<std::string> all{"evolve", "-"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run(all, {.input = input});
}

constexpr const char* kSquare = "POFF 4 0 0\n0 0\n8 0\n8 8\n0 8\n";

}  // namespace

TEST_CASE("no step gives the samples as they are, and each step is that of the rule") {
  const std::string given = run({"export", "-", "--layer", "points", "--format", "poff"}, {.input = kSquare}).out;
  CHECK(evolve(kSquare, {"--evolution", "smooth", "--steps", "0"}).out == given);
  const RunResult once = evolve(kSquare, {"--evolution", "smooth", "--steps", "1"});
  CHECK(once.exit_code == 0);
  CHECK(once.err.empty());
  CHECK_THAT(once.out, Catch::Contains("2 2\n6 2\n6 6\n2 6\n"));
  const RunResult twice = evolve(once.out, {"--evolution", "smooth", "--steps", "1"});
  CHECK(twice.out == evolve(kSquare, {"--evolution", "smooth", "--steps", "2"}).out);
}

TEST_CASE("equal input gives equal bytes, and known loops go along") {
  const std::vector<std::string> noise{
      "evolve", "tests/data/ne_hawaii.poff", "--evolution", "noise", "--steps", "3", "--seed", "7"};
  const RunResult first = run(noise);
  CHECK(first.exit_code == 0);
  CHECK(first.out == run(noise).out);
  CHECK_THAT(first.out, Catch::Contains("# loop"));
  const RunResult refined = run({"evolve", "tests/data/ne_hawaii.poff", "--evolution", "subdivide", "--steps", "2"});
  CHECK(refined.exit_code == 0);
  CHECK_THAT(refined.out, Catch::Contains("# loop"));
  CHECK(refined.out.size() > 2 * first.out.size());
}

TEST_CASE("an evolution that makes no sense is refused in one line that names what there is") {
  const auto fault = [](std::vector<std::string> arguments) {
    const RunResult result = evolve(kSquare, std::move(arguments));
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(std::ranges::count(result.err, '\n') == 1);
    return result.err;
  };
  CHECK_THAT(fault({"--evolution", "smoth", "--steps", "1"}), Catch::Contains("smooth, subdivide, noise,"));
  CHECK_THAT(fault({"--evolution", "smooth", "--steps", "-1"}),
             Catch::Contains("--steps expects a whole number from 0 to 2^64 - 1, not \"-1\""));
  CHECK_THAT(fault({"--evolution", "smooth", "--steps", "1", "--set", "smooth-mu=2"}),
             Catch::Contains("--set smooth-mu expects a number from 0.001 to 1, not \"2\""));
  CHECK_THAT(fault({"--evolution", "smooth", "--steps", "1", "--set", "noise-factor=2"}),
             Catch::Contains("unknown parameter"));
  CHECK_THAT(fault({"--evolution", "a-growing", "--steps", "1"}), Catch::Contains("the parameter a-scale"));
}

TEST_CASE("steps that cannot be done leave no output") {
  const RunResult result = evolve(kSquare, {"--evolution", "subdivide", "--steps", "60"});
  CHECK(result.exit_code == 1);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::Contains("4000000 are the most"));
}
