// SPDX-License-Identifier: GPL-3.0-or-later
// Components and cycles of the axis of what is imported: those of letters and maps, as anybody counts them.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using Json = nlohmann::json;

namespace {

struct Topology {
  int components = 0;
  int cycles = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

Topology topology_of(const std::string& file, const RunOptions& options = {}) {
  const RunResult computed = run({"compute", file, "--layers", "medial-axis", "--no-timing"}, options);
  INFO(computed.err);
  REQUIRE(computed.exit_code == 0);
  const Json axis = Json::parse(computed.out)["structures"]["medial-axis"];
  return {axis["components"].get<int>(), axis["cycles"].get<int>()};
}

/// A ring of positions about a centre, in degrees.
std::string ring(double x, double y, double radius) {
  constexpr int kCorners = 90;
  std::string out;
  for (int i = 0; i <= kCorners; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i % kCorners) / kCorners;
    out += (i == 0 ? "[" : ",[") + std::to_string(x + radius * std::cos(turn)) + ',' +
           std::to_string(y + radius * std::sin(turn)) + ']';
  }
  return '[' + out + ']';
}

}  // namespace

TEST_CASE("letters have the components and holes that one reads") {
  const std::vector<std::pair<std::string, Topology>> letters{{"B", {1, 2}}, {"i", {2, 0}}, {"8", {1, 2}},
                                                              {"O", {1, 1}}, {"o", {1, 1}}, {"B8", {2, 4}}};
  for (const auto& [text, expected] : letters) {
    INFO(text);
    const RunResult made = run({"text", text, "--samples", std::to_string(1500 * text.size())});
    REQUIRE(made.exit_code == 0);
    CHECK(topology_of("-", {.input = made.out}) == expected);
  }
}

TEST_CASE("a map has the islands and lakes that it was drawn with") {
  // An island with two lakes, in one of which lies an island; and an island by itself.
  const TemporaryFolder folder;
  const std::string json = R"({"type":"MultiPolygon","coordinates":[[)" + ring(10, 0, 1) + ',' + ring(9.5, 0, 0.3) +
                           ',' + ring(10.4, 0.1, 0.4) + "],[" + ring(10.4, 0.1, 0.15) + "],[" + ring(13, 1, 0.5) +
                           "]]}";
  const auto map = folder.write("map.geojson", json);
  CHECK(topology_of(map.string()) == Topology{3, 2});
}
