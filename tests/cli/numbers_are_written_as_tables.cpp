// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/io/text/text_numbers.h"
#include "run_binary.h"
#include "tests/cli/inputs.h"
#include "tests/io/temporary_folder.h"

using mes::Vec2;
using mes::test::contents_of;
using mes::test::kDude;
using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;

namespace {

using Table = std::vector<std::vector<std::string>>;

Table table_of(const std::string& csv) {
  Table out;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    out.emplace_back();
    std::istringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');) out.back().push_back(cell);
  }
  return out;
}

std::size_t column(const Table& table, const std::string& name) {
  const auto found = std::ranges::find(table.front(), name);
  INFO(name);
  REQUIRE(found != table.front().end());
  REQUIRE(std::ranges::count(table.front(), name) == 1);
  return static_cast<std::size_t>(found - table.front().begin());
}

}  // namespace

TEST_CASE("a swept parameter gives a line for each value, with the numbers of compute") {
  const RunResult result = run({"sweep", kDude, "--parameter", "lambda-limit=0..12.5", "--steps", "5", "--layers",
                                "lambda-medial-axis,medial-axis", "--set", "keep-topology=1"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  const Table table = table_of(result.out);
  REQUIRE(table.size() == 7);
  for (const auto& line : table) CHECK(line.size() == table.front().size());
  CHECK(table.front().front() == "lambda-limit");
  CHECK(table[1][0] == "0");
  CHECK(table[2][0] == "2.5");
  CHECK(table[6][0] == "12.5");
  const std::size_t length = column(table, "layers.lambda-medial-axis.length");
  const std::size_t components = column(table, "structures.lambda-axis.components");
  for (std::size_t i = 1; i < table.size(); ++i) {
    CHECK(table[i][components] == table[1][components]);
    CHECK(table[i][column(table, "structures.medial-axis.length")] ==
          table[1][column(table, "structures.medial-axis.length")]);
    if (i > 1) CHECK(std::stod(table[i][length]) <= std::stod(table[i - 1][length]));
    const RunResult alone = run({"compute", kDude, "--layers", "lambda-medial-axis", "--set", "keep-topology=1",
                                 "--set", "lambda-limit=" + table[i][0]});
    REQUIRE(alone.exit_code == 0);
    const auto json = nlohmann::json::parse(alone.out);
    CHECK(std::stod(table[i][length]) ==
          Approx(json["layers"]["lambda-medial-axis"]["length"].get<double>()).epsilon(1e-12));
    CHECK(std::stoll(table[i][column(table, "structures.lambda-axis.edges")]) ==
          json["structures"]["lambda-axis"]["edges"].get<std::int64_t>());
  }
  CHECK(std::stod(table[6][length]) < std::stod(table[1][length]));
}

TEST_CASE("a swept parameter need not change anything, nor rise, and a file is written") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "x.csv").string();
  const RunResult result =
      run({"sweep", kDude, "--parameter", "a-scale=2..1", "--steps", "2", "--layers", "curve", "-o", file});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.empty());
  const Table table = table_of(contents_of(file));
  REQUIRE(table.size() == 4);
  CHECK(table[1][0] == "2");
  CHECK(table[2][0] == "1.5");
  CHECK(table[3][0] == "1");
  CHECK(std::equal(table[1].begin() + 1, table[1].end(), table[3].begin() + 1));
}

TEST_CASE("ranges and steps that cannot be are usage errors, and limits beyond their range are taken to its end") {
  const auto fault = [](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"sweep", kDude, "--layers", "curve"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(std::ranges::count(result.err, '\n') == 1);
    return result.err;
  };
  CHECK_THAT(fault({"--parameter", "lambda-limit", "--steps", "3"}), Catch::Contains("NAME=FROM..TO"));
  CHECK_THAT(fault({"--parameter", "lambda-limit=3", "--steps", "3"}), Catch::Contains("NAME=FROM..TO"));
  CHECK_THAT(fault({"--parameter", "lamda-limit=0..3", "--steps", "3"}),
             Catch::Contains("did you mean lambda-limit"));
  CHECK_THAT(fault({"--parameter", "a-scale=1..200", "--steps", "3"}),
             Catch::Contains("--parameter a-scale expects a number from "));
  CHECK_THAT(fault({"--parameter", "a-scale=1..x", "--steps", "3"}), Catch::Contains("a-scale"));
  CHECK_THAT(fault({"--parameter", "a-scale=1..2", "--steps", "0"}), Catch::Contains("--steps"));
  CHECK_THAT(fault({"--parameter", "a-scale=1..2", "--steps", "1e9"}), Catch::Contains("--steps"));
  CHECK_THAT(fault({"--parameter", "a-scale=1..2"}), Catch::Contains("--steps"));
  CHECK_THAT(fault({"--steps", "2"}), Catch::Contains("--parameter"));

  const RunResult clamped =
      run({"sweep", kDude, "--layers", "angle-medial-axis", "--parameter", "angle-limit=80..120", "--steps", "1"});
  CHECK(clamped.exit_code == 0);
  CHECK_THAT(clamped.err, Catch::Contains("angle-limit") && Catch::Contains("above 90"));
  CHECK(std::ranges::count(clamped.err, '\n') == 1);
  CHECK(table_of(clamped.out).back().front() == "90");
  const RunResult computed = run({"compute", kDude, "--layers", "lambda-medial-axis", "--set", "lambda-limit=-3"});
  CHECK(computed.exit_code == 0);
  CHECK(computed.err == "mesecina: --set lambda-limit: \"-3\" is below 0, which is taken instead\n");
}

TEST_CASE("samples without an axis are swept as well") {
  const TemporaryFolder folder;
  const std::string file = folder.write("two.xyz", "0 0\n1 1\n").string();
  const RunResult result = run({"sweep", file, "--parameter", "lambda-limit=0..1", "--steps", "1", "--layers",
                                "lambda-medial-axis,angle-medial-axis,feature-size"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const Table table = table_of(result.out);
  CHECK(table.size() == 3);
  CHECK(table[1][column(table, "structures.lambda-axis.edges")] == "0");
  CHECK(result.out.find("nan") == std::string::npos);
  CHECK(result.out.find("inf") == std::string::npos);
  CHECK_THAT(run({"compute", file, "--layers", "lambda-medial-axis"}).out, Catch::Contains("nothing_because"));
}

TEST_CASE("branches are a table whose lengths add up to the layer's") {
  for (const std::vector<std::string>& of :
       {std::vector<std::string>{"--layer", "medial-axis"},
        {"--layer", "lambda-medial-axis", "--set", "lambda-limit=6"},
        {"--layer", "cover-medial-axis", "--set", "scale-axis-factor=1"},
        {"--layer", "angle-medial-axis", "--set", "angle-limit=40", "--set", "keep-topology=1"}}) {
    std::vector<std::string> arguments{"branches", kDude};
    arguments.insert(arguments.end(), of.begin(), of.end());
    const RunResult result = run(arguments);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains(std::to_string(std::ranges::count(result.out, '\n') - 1) + " branches") &&
                               Catch::Contains("% of the shape"));
    const Table table = table_of(result.out);
    REQUIRE(table.size() > 3);
    double sum = 0.0;
    double before = std::stod(table[1][column(table, "length")]);
    for (std::size_t i = 1; i < table.size(); ++i) {
      REQUIRE(table[i].size() == table.front().size());
      CHECK(table[i][0] == std::to_string(i));
      const double length = std::stod(table[i][column(table, "length")]);
      CHECK(length <= before);
      before = length;
      sum += length;
    }
    arguments[0] = "compute";
    arguments[2] = "--layers";
    const RunResult computed = run(arguments);
    REQUIRE(computed.exit_code == 0);
    CHECK(sum == Approx(nlohmann::json::parse(computed.out)["layers"][of[1]]["length"].get<double>()).epsilon(1e-10));
  }
  const RunResult wrong = run({"branches", kDude, "--layer", "curve"});
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Catch::Contains("angle-medial-axis"));
  const TemporaryFolder folder;
  const RunResult none = run({"branches", folder.write("two.xyz", "0 0\n1 1\n").string()});
  CHECK(none.exit_code == 0);
  CHECK(std::ranges::count(none.out, '\n') == 1);
  CHECK_THAT(none.err, Catch::Contains("no branch: fewer than three samples"));
}

TEST_CASE("an undersampled curve is repaired, and a dense one decimated, and what was done is said") {
  const TemporaryFolder folder;
  std::string sparse;
  for (int i = 0; i < 16; ++i) {
    const double t = 2.0 * 3.14159265358979 * (i + 0.3) / 16.0;
    sparse += std::to_string(3.0 * std::cos(t)) + ' ' + std::to_string(std::sin(t)) + '\n';
  }
  const std::string file = folder.write("sparse.xyz", sparse).string();
  const std::string dense = (folder.path() / "dense.poff").string();
  const RunResult repaired = run({"repair", file, "-o", dense});
  INFO(repaired.err);
  REQUIRE(repaired.exit_code == 0);
  CHECK_THAT(repaired.err, Catch::Contains("samples inserted") && Catch::Contains("the theorem is proved"));
  const auto computed = nlohmann::json::parse(run({"compute", dense, "--layers", "sampling-epsilon"}).out);
  CHECK(computed["structures"]["feature-size"]["epsilon"].get<double>() <= 0.25);
  // The message ends with the verdict that `compute` gives of what was written.
  const auto said = computed["diagnostics"]["text"].get<std::string>();
  CHECK_THAT(repaired.err, Catch::Contains("; now: " + said + "\n"));

  const RunResult thin = run({"decimate", "tests/data/earcut_dude.poff", "--epsilon", "0.4"});
  INFO(thin.err);
  REQUIRE(thin.exit_code == 0);
  CHECK_THAT(thin.err, Catch::Contains("removed; the axis has") && Catch::Contains(" as before; estimated epsilon "));
  for (const char* wrong : {"0", "-1", "1.5", "x", "nan", ""}) {
    INFO(wrong);
    for (const char* command : {"repair", "decimate"}) CHECK(run({command, file, "--epsilon", wrong}).exit_code == 2);
  }
  for (const char* few : {"0 0\n", "0 0\n1 1\n"}) {
    const RunResult nothing = run({"repair", folder.write("few.xyz", few).string()});
    CHECK(nothing.exit_code == 0);
    CHECK_THAT(nothing.err, Catch::Contains("there is no axis"));
  }
  // Samples at a crossing are never dense enough, however many there are.
  const std::string bow_tie = folder.write("bow-tie.wkt", "POLYGON ((0 0, 20 5, 20 0, 0 5, 0 0))").string();
  const RunResult crossed = run({"repair", bow_tie});
  CHECK(crossed.exit_code == 0);
  CHECK_THAT(crossed.err,
             Catch::EndsWith("nothing was repaired: sides of outlines cross once, and no samples are dense "
                             "enough there\n"));
  const std::size_t samples =
      nlohmann::json::parse(run({"compute", bow_tie, "--layers", "points"}).out)["input"]["samples"];
  CHECK(crossed.out.starts_with("POFF " + std::to_string(samples) + " "));
}

TEST_CASE("births and deaths are a table, the longest first") {
  const RunResult result = run({"persistence", kDude});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::Contains("components") && Catch::Contains("the longest hole"));
  const Table table = table_of(result.out);
  REQUIRE(table.size() > 10);
  CHECK(table[1][column(table, "death")].empty());
  CHECK(table[1][column(table, "dimension")] == "0");
  double before = std::stod(table[2][column(table, "persistence")]);
  for (std::size_t i = 2; i < table.size(); ++i) {
    REQUIRE(table[i].size() == table.front().size());
    const double persistence = std::stod(table[i][column(table, "persistence")]);
    CHECK(0.0 < persistence);
    CHECK(persistence <= before);
    before = persistence;
  }
  const TemporaryFolder folder;
  // Two balls of radius 1 whose centres are 4 apart are there before they grow, and meet at sqrt(3).
  const std::string balls = folder.write("two.wpoff", "WPOFF\n2 0 0\n0 0 1\n4 0 1\n").string();
  const RunResult own = run({"persistence", balls, "--of", "own"});
  REQUIRE(own.exit_code == 0);
  const Table grown = table_of(own.out);
  REQUIRE(grown.size() == 3);
  CHECK(grown[1][column(grown, "birth")] == "-1");
  CHECK(std::stod(grown[2][column(grown, "death")]) == Approx(std::sqrt(3.0)));
  const RunResult scaled = run({"persistence", balls, "--of", "own", "--set", "b-scale=2"});
  CHECK(std::stod(table_of(scaled.out)[2][column(grown, "death")]) == 0.0);
  CHECK(run({"persistence", balls, "--of", "samples"}).exit_code == 0);
  const RunResult wrong = run({"persistence", balls, "--of", "outer"});
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Catch::Contains("samples, inner, polar or own"));
  CHECK(run({"persistence", kDude, "--of", "inner"}).exit_code == 0);
  const RunResult none = run({"persistence", folder.write("one.xyz", "0 0\n").string()});
  CHECK(none.exit_code == 0);
  CHECK_THAT(none.err, Catch::Contains("1 component, 0 holes"));
  CHECK(run({"persistence", folder.write("bad.xyz", "0 zero\n").string()}).exit_code == 3);
}

TEST_CASE("tables of a structure are written for other programs") {
  const auto exported = [](const std::string& name) {
    const RunResult result = run({"export", kDude, "--structure", "delaunay", "--table", name, "--format", "csv"});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.empty());
    return table_of(result.out);
  };
  const Table sites = exported("sites");
  const Table faces = exported("faces");
  std::map<std::string, Vec2> position;
  for (std::size_t i = 1; i < sites.size(); ++i)
    position[sites[i][column(sites, "row")]] = {std::stod(sites[i][column(sites, "position_x")]),
                                                std::stod(sites[i][column(sites, "position_y")])};
  std::size_t finite = 0;
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i][column(faces, "is_finite")] == "0") continue;
    ++finite;
    const Vec2 center{std::stod(faces[i][column(faces, "circumcenter_x")]),
                      std::stod(faces[i][column(faces, "circumcenter_y")])};
    const double radius = std::stod(faces[i][column(faces, "circumradius")]);
    for (const char* corner : {"sites_0", "sites_1", "sites_2"})
      CHECK(distance(center, position.at(faces[i][column(faces, corner)])) == Approx(radius).epsilon(1e-9));
  }
  const RunResult counts = run({"compute", kDude, "--layers", "delaunay"});
  REQUIRE(counts.exit_code == 0);
  CHECK(finite == nlohmann::json::parse(counts.out)["structures"]["delaunay"]["faces"].get<std::size_t>());

  const TemporaryFolder folder;
  const std::string file = (folder / "edges.npy").string();
  const RunResult written =
      run({"export", kDude, "--structure", "labels", "--table", "faces", "--format", "npy", "-o", file});
  INFO(written.err);
  REQUIRE(written.exit_code == 0);
  const std::string bytes = contents_of(file);
  CHECK(bytes.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
  CHECK(bytes.find("'is_inside'") < bytes.find('\n'));
}

TEST_CASE("a table that cannot be written is named") {
  const auto refused = [](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"export", kDude};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const RunResult result = run(arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    return result.err;
  };
  CHECK(refused({"--format", "csv"}) ==
        "mesecina: export needs --layer (mesecina list layers), --structure (mesecina list structures) or --cells\n");
  CHECK(refused({"--structure", "delauney", "--format", "csv"}) ==
        "mesecina: unknown structure \"delauney\"; did you mean delaunay? (mesecina list structures)\n");
  CHECK(refused({"--structure", "delaunay", "--format", "csv"}) ==
        "mesecina: --table says which table of delaunay: sites, faces, edges or samples\n");
  CHECK(refused({"--structure", "delaunay", "--table", "balls", "--format", "csv"}) ==
        "mesecina: delaunay has no table \"balls\"; it has sites, faces, edges or samples\n");
  CHECK(refused({"--structure", "delaunay", "--table", "faces", "--format", "wkt"}) ==
        "mesecina: a table is written as csv or npy, not \"wkt\"\n");
  CHECK(refused({"--structure", "settings", "--format", "csv"}) == "mesecina: the structure settings has no table\n");
  CHECK(refused({"--table", "faces", "--format", "csv"}) ==
        "mesecina: --table needs --structure (mesecina list structures)\n");
  CHECK(refused({"--layer", "curve", "--structure", "delaunay", "--format", "csv"}) ==
        "mesecina: export takes --layer or --structure, not both\n");
}
