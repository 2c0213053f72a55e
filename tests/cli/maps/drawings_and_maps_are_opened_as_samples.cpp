// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/base/zlib.h"
#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;

namespace {

nlohmann::json axis_computed(const std::string& file) {
  const RunResult result = run({"compute", file, "--layers", "curve,curve-defects,medial-axis"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return nlohmann::json::parse(result.out);
}

/// A file of gzip that holds the text as it is.
std::string gzipped(const std::string& text) {
  const auto bytes_of = [](std::uint32_t number, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += static_cast<char>(number >> (8 * i) & 0xFFU);
    return out;
  };
  const auto size = static_cast<std::uint32_t>(text.size());
  return std::string("\x1F\x8B\x08\0\0\0\0\0\0\xFF\x01", 11) + bytes_of(size, 2) + bytes_of(~size, 2) + text +
         bytes_of(mes::crc32_of(text), 4) + bytes_of(size, 4);
}

}  // namespace

TEST_CASE("a compressed drawing is the drawing, and nothing else is expanded") {
  const std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H10V4H0z"/></svg>)";
  const TemporaryFolder folder;
  const RunResult whole = run({"sample", "-"}, {.input = svg});
  CHECK(whole.exit_code == 0);
  CHECK(run({"sample", "-"}, {.input = gzipped(svg)}).out == whole.out);
  CHECK(run({"sample", folder.write("a.svgz", gzipped(svg)).string()}).out == whole.out);
  for (const auto& [bytes, says] :
       {std::pair{gzipped("POFF 1 0 0\n0 0\n"), "this is gzip compressed data other than a drawing in SVG"},
        {gzipped(svg).substr(0, 60), "compressed data are cut or broken"}}) {
    const RunResult other = run({"sample", "-"}, {.input = bytes});
    CHECK(other.exit_code == 3);
    CHECK_THAT(other.err, Catch::Contains(says));
  }
}

TEST_CASE("the crust of a drawing is the drawing, where it is narrow too") {
  const TemporaryFolder folder;
  // A comb whose teeth leave slits of a hundredth of its width, a hole near its edge, and a stroke with a round end.
  const std::string file = folder.write("a.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100">
    <path d="M0 0H100V60C100 70 90 70 90 60V3H88V60C88 70 78 70 78 60V3H76V60C76 70 66 70 66 60V40H0z"/>
    <circle cx="30" cy="20" r="19"/>
    <path d="M120 10 q60 0 60 40 t-40 40 a3 3 0 010-6 q30-10 30-30 t-50-38z"/></svg>)");
  const nlohmann::json out = axis_computed(file);
  CHECK(out["input"]["format"] == "svg");
  CHECK(out["input"]["contours"] == 3);
  CHECK(out["layers"]["curve"]["segments"] == out["input"]["samples"]);
  CHECK(out["layers"]["curve-defects"]["points"] == 0);
  CHECK(out["structures"]["labels"]["conflicts"] == 0);
}

TEST_CASE("a map is opened with what was done to it on standard error") {
  const TemporaryFolder folder;
  const std::string map = R"({"type": "Polygon", "coordinates": [[[9, 50], [11, 50], [11, 51], [9, 51], [9, 50]]]})";
  const RunResult result = run({"compute", folder.write("a.json", map).string(), "--layers", "curve"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("metres about 10 E, 50.5 N"));
  const nlohmann::json out = nlohmann::json::parse(result.out);
  // Samples between the corners, which a remark says; the corners alone on request.
  CHECK(out["input"]["samples"] >= 400);
  CHECK_THAT(result.err, Catch::Contains("samples were added between the 4 vertices"));
  CHECK_THAT(result.err, Catch::Contains("--vertices takes the vertices alone"));
  const RunResult corners = run({"compute", (folder.path() / "a.json").string(), "--layers", "curve", "--vertices"});
  CHECK(nlohmann::json::parse(corners.out)["input"]["samples"] == 4);
  CHECK_FALSE(corners.err.contains("were added"));
  CHECK(out["structures"]["samples"]["height"].get<double>() == Approx(111238.7).epsilon(5e-3));
  CHECK(axis_computed(folder.write("a.wkt", "POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0))"))["layers"]["curve"]["length"]
            .get<double>() == Approx(12.0));
}

TEST_CASE("every command that reads a map keeps its degrees on request") {
  const TemporaryFolder folder;
  const std::string map = R"({"type": "Polygon", "coordinates": [[[9, 50], [11, 50], [11, 51.5], [9, 51.5]]]})";
  const std::string file = folder.write("a.geojson", map).string();
  const std::string remark = "mesecina: " + file + ": degrees are kept as coordinates of the plane\n";

  const RunResult computed = run({"compute", file, "--layers", "curve", "--degrees"});
  CHECK(computed.exit_code == 0);
  CHECK_THAT(computed.err, Catch::StartsWith(remark));
  const nlohmann::json samples = nlohmann::json::parse(computed.out)["structures"]["samples"];
  CHECK(samples["width"] == 2);
  CHECK(samples["height"] == 1.5);

  const RunResult points = run({"export", file, "--layer", "points", "--format", "csv", "--degrees"});
  CHECK(points.exit_code == 0);
  CHECK_THAT(points.out, Catch::Contains("51.5"));
  CHECK_THAT(run({"sample", file, "--rule", "vertices", "--degrees"}).out, Catch::Contains("11 51.5"));
  const std::string picture = (folder.path() / "a.svg").string();
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render", file, "--layers", "curve", "-o", picture, "--degrees"},
        {"decimate", file, "--degrees"},
        {"repair", file, "--degrees"},
        {"branches", file, "--degrees"}}) {
    const RunResult done = run(command);
    INFO(command.front() << ": " << done.err);
    CHECK(done.exit_code == 0);
    CHECK_THAT(done.err, Catch::StartsWith(remark));
  }
  // By standard input too.
  const RunResult piped = run({"compute", "-", "--layers", "curve", "--degrees"}, {.input = map});
  CHECK(nlohmann::json::parse(piped.out)["structures"]["samples"]["height"] == 1.5);
}

TEST_CASE("degrees are kept where there can be some, and are asked of nothing else") {
  const TemporaryFolder folder;
  const std::string points = folder.write("a.poff", "POFF 1 0 0\n1 2\n").string();
  const RunResult none = run({"compute", points, "--degrees"});
  CHECK(none.exit_code == 2);
  CHECK(none.out.empty());
  CHECK(none.err == "mesecina: " + points + ": only maps have degrees to keep, and this is none\n");
  // A map of the plane stays what it is.
  const RunResult plane =
      run({"compute", folder.write("a.wkt", "POINT (1 2)").string(), "--layers", "points", "--degrees"});
  CHECK(plane.exit_code == 0);
  CHECK(plane.err.empty());
}

TEST_CASE("a drawing that cannot be read ends the command in one line, with its place") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.svg", "<svg>\n<g></svg>");
  const RunResult result = run({"compute", file});
  CHECK(result.exit_code == 3);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: " + file + ":2:6: this is not XML"));
}
