// SPDX-License-Identifier: GPL-3.0-or-later
// Silhouettes as FILE of commands. They are PGM, which a test can write by hand; a disk of radius 60 and a speck.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;

namespace {

constexpr int kSide = 150;

std::string silhouette(bool is_dark, double radius = 60.0) {
  std::string out = "P5 150 150 255\n";
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const bool is_speck = x < 4 && y < 4 && x > 1 && y > 1;
      const bool is_inside = std::hypot(x - 75.3, y - 74.8) <= radius || is_speck;
      out += static_cast<char>(is_inside != is_dark ? 220 : 30);
    }
  return out;
}

RunResult compute(const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"compute", file, "--layers", "curve,medial-axis"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

}  // namespace

TEST_CASE("a silhouette is samples of its outline") {
  const TemporaryFolder folder;
  for (const bool is_dark : {true, false}) {
    const std::string file = folder.write("disk.pgm", silhouette(is_dark)).string();
    const RunResult result = compute(file);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const nlohmann::json out = nlohmann::json::parse(result.out);
    CHECK(out["input"]["format"] == "picture");
    CHECK(out["input"]["contours"] == 1);
    CHECK(out["layers"]["curve"]["length"].get<double>() == Approx(2 * std::numbers::pi * 60.0).epsilon(0.004));
    CHECK(out["diagnostics"]["theorem"] == "green");
    CHECK(result.err == "mesecina: " + file + ": traced all pixels " +
                            (is_dark ? "of grey value 124 or darker" : "lighter than grey value 124") +
                            "; left out: 1 speck smaller than 16 square pixels\n");
    // By standard input too.
    const RunResult piped = run({"compute", "-", "--layers", "curve", "--no-timing"}, {.input = silhouette(is_dark)});
    CHECK(nlohmann::json::parse(piped.out)["layers"]["curve"] == out["layers"]["curve"]);
  }
}

TEST_CASE("threshold, specks and side are chosen by options") {
  const TemporaryFolder folder;
  const std::string file = folder.write("disk.pgm", silhouette(false)).string();
  const RunResult all = compute(file, {"--specks", "0", "--threshold", "200"});
  REQUIRE(all.exit_code == 0);
  CHECK(nlohmann::json::parse(all.out)["input"]["contours"] == 2);
  CHECK(all.err == "mesecina: " + file + ": traced all pixels lighter than grey value 200\n");
  const RunResult around = compute(file, {"--figure-side", "dark"});
  REQUIRE(around.exit_code == 0);
  CHECK_THAT(around.err, Catch::Contains("darker") && Catch::Contains("1 hole"));
  CHECK(nlohmann::json::parse(around.out)["input"]["contours"] == 2);  // the disk is a hole of it
}

TEST_CASE("a picture without a figure, and what is no picture, end the command in one line") {
  const TemporaryFolder folder;
  const std::string gray = folder.write("gray.pgm", "P5 2 2 255\naaaa").string();
  const RunResult empty = compute(gray);
  CHECK(empty.exit_code == 3);
  CHECK(empty.out.empty());
  CHECK(empty.err == "mesecina: " + gray + ": no figure stands out: every pixel has the grey value 97\n");
  const std::string small = folder.write("small.pgm", silhouette(false, 1.5)).string();
  CHECK_THAT(compute(small).err, Catch::Contains("no figure stands out") && Catch::Contains("only specks") &&
                                     Catch::Contains("the largest of"));
  CHECK(compute(small).exit_code == 3);
  const std::string cut = folder.write("cut.pgm", silhouette(false).substr(0, 5000)).string();
  CHECK(compute(cut).exit_code == 3);

  const std::string points = folder.write("a.poff", "POFF 1 0 0\n1 2\n").string();
  const RunResult none = compute(points, {"--threshold", "9"});
  CHECK(none.exit_code == 2);
  CHECK(none.err == "mesecina: " + points + ": only pictures are traced, and this is none\n");
  for (const auto& [option, value] : {std::pair{"--threshold", "255"},
                                      {"--threshold", "x"},
                                      {"--specks", "-1"},
                                      {"--specks", "nan"},
                                      {"--figure-side", "blue"}}) {
    const RunResult bad = compute(gray, {option, value});
    CHECK(bad.exit_code == 2);
    CHECK_THAT(bad.err, Catch::StartsWith("mesecina: " + std::string(option) + " expects"));
  }
}
