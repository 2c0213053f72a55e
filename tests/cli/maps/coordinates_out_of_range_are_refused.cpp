// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs beyond the range of coordinates end every command with one line that names the place; inputs at its ends are
// computed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

constexpr const char* kLayers = "medial-axis,power-crust,a-ball-medial-axis";

void require_refusal(const RunResult& result, const std::string& beginning) {
  INFO(result.err);
  CHECK(result.exit_code == 3);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: " + beginning));
  CHECK(std::ranges::count(result.err, '\n') == 1);
}

}  // namespace

TEST_CASE("extreme inputs are refused by every command, with line and column") {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"tests/data/subnormal_circumcentre.poff", ":3:1: \"5e-324\" is too small"},
      {"tests/data/mixed_scales_div0.poff", ":2:1: \"1e-300\" is too small"},
      {"tests/data/extreme_recursion.poff", ":2:1: \"5e-324\" is too small"},
      {"tests/data/extreme_sigfpe.poff", ":4:3: \"1e160\" is too large"},
      {"tests/data/extreme_session.json", ":1:59: data \"samples\": 1e-300 is too small"},
  };
  for (const auto& [file, place] : cases) {
    require_refusal(run({"compute", file, "--layers", kLayers}), file + place);
    require_refusal(run({"export", file, "--layer", "points", "--format", "csv"}), file + place);
    require_refusal(run({"render", file, "-o", (folder / "a.png").string()}), file + place);
    require_refusal(run({"evolve", file, "--evolution", "smooth", "--steps", "1"}), file + place);
  }
  require_refusal(run({"play", "tests/data/extreme_session.json"}), "tests/data/extreme_session.json:1:59: ");
  CHECK(folder.file_count() == 0);
}

TEST_CASE("both ends of the range are computed") {
  for (const char* input : {"0 0\n3.2e150 0\n1.6e150 3e120\n-1e150 2e150\n", "3.1e-151 0\n-3.1e-151 0\n0 3.1e-151\n",
                            "3.1e-151 0\n0 3.1e-121\n3.1e-121 1e-150\n", "0 0\n1 0\n0.5 1e-30\n0.5 -1\n"}) {
    INFO(input);
    const RunResult result = run({"compute", "-", "--layers", kLayers}, {.input = input});
    INFO(result.err);
    CHECK(result.exit_code == 0);
    const auto output = nlohmann::json::parse(result.out, nullptr, false);
    REQUIRE_FALSE(output.is_discarded());
    for (const auto& [layer, counts] : output.at("layers").items()) {
      INFO(layer);
      CHECK_THAT(counts.dump(), !Catch::Contains("null"));
      CHECK_FALSE(counts.contains("not_finite"));
    }
  }
}

TEST_CASE("an evolution that leaves the range ends with one line") {
  const RunResult result =
      run({"evolve", "-", "--evolution", "noise", "--steps", "60", "--set", "noise-factor=10"},
          {.input = "POFF 4 0 0\n-3e150 0\n3e150 2e150\n0 3e150\n0 1e149\n# loop closed 0 1 2 3\n"});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::Contains("leaves the range of coordinates: ") && Catch::Contains(" is too large: "));
  CHECK(std::ranges::count(result.err, '\n') == 1);
}

TEST_CASE("the help and the manual state the range") {
  for (const char* command : {"--help", "manual"}) {
    const std::string page = run({command}).out;
    CHECK_THAT(page, Catch::Contains("2^-500") && Catch::Contains("2^500") && Catch::Contains("2^100"));
  }
}
