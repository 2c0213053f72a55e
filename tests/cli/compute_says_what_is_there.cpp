// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "run_binary.h"
#include "tests/cli/inputs.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::kDude;
using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;
using OrderedJson = nlohmann::ordered_json;

namespace {

OrderedJson json_of(const RunResult& result) {
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return OrderedJson::parse(result.out);
}

std::vector<std::string> keys_of(const OrderedJson& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

// A circle of n samples and, around the same centre, one half as large.
std::string annulus(int n) {
  std::string out;
  for (const double radius : {10.0, 5.0})
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * 3.14159265358979 * (i + (radius < 6.0 ? 0.37 : 0.0)) / n;
      out += std::to_string(radius * std::cos(angle)) + ' ' + std::to_string(radius * std::sin(angle)) + '\n';
    }
  return out;
}

}  // namespace

TEST_CASE("compute answers with the promised keys") {
  const OrderedJson out = json_of(run({"compute", kDude, "--layers", "medial-axis,interior-voronoi-disks"}));
  CHECK(keys_of(out) ==
        std::vector<std::string>{"schema", "version", "input", "precision", "structures", "layers", "diagnostics"});
  CHECK(out["schema"] == 1);
  CHECK(out["precision"] == "fast");
  CHECK(out["input"] ==
        OrderedJson{
            {"file", kDude}, {"format", "poff"}, {"samples", 104}, {"distinct", 104}, {"contours", 3}, {"balls", 0}});
  CHECK(keys_of(out["layers"]) == std::vector<std::string>{"medial-axis", "interior-voronoi-disks"});
  CHECK(out["diagnostics"]["theorem"] == "yellow");
  CHECK(keys_of(out["diagnostics"]) == std::vector<std::string>{"theorem", "epsilon", "text", "reasons"});
  const OrderedJson& epsilon = out["diagnostics"]["epsilon"];
  CHECK(epsilon["value"] == out["structures"]["feature-size"]["epsilon"]);
  CHECK(epsilon["estimate"] == true);
  CHECK(keys_of(epsilon) ==
        std::vector<std::string>{"value", "estimate", "exempt_corners", "exempt_ends", "exempt_junctions"});
  CHECK(epsilon["exempt_corners"].get<int>() + epsilon["exempt_junctions"].get<int>() > 0);
  CHECK_THAT(out["diagnostics"]["text"].get<std::string>(),
             Catch::StartsWith("estimated epsilon ") &&
                 Catch::EndsWith(" exempt); the theorem is not proved for these samples"));
  REQUIRE(out["diagnostics"]["reasons"].size() >= 1);
  CHECK(out["diagnostics"]["reasons"][0]["count"].get<int>() > 0);
  for (const char* structure : {"delaunay", "one-step-crust", "labels", "inner-balls", "medial-axis"}) {
    INFO(structure);
    REQUIRE(out["structures"].contains(structure));
    CHECK(out["structures"][structure]["ms"].get<double>() >= 0.0);
  }
  CHECK_FALSE(out["structures"].contains("curve"));
  CHECK(out["structures"]["delaunay"]["vertices"] == 104);
  const OrderedJson& axis = out["layers"]["medial-axis"];
  CHECK(axis["segments"].get<int>() + axis["zero_length"].get<int>() > 0);
  CHECK(axis["length"].get<double>() == Approx(out["structures"]["medial-axis"]["length"].get<double>()));
  const OrderedJson& disks = out["layers"]["interior-voronoi-disks"];
  CHECK(disks["disks"] == out["structures"]["labels"]["inside"]);
  CHECK(disks["radius_sum"].get<double>() > 0.0);
}

TEST_CASE("samples without inner balls have nothing to prove, however few or however open their curve") {
  const TemporaryFolder folder;
  for (const char* samples :
       {"POFF 0 0 0\n", "POFF 1 0 0\n1 2\n", "POFF 2 0 0\n0 0\n4 0\n", "POFF 3 0 0\n0 0\n1 0\n2 0\n"}) {
    INFO(samples);
    folder.write("few.poff", samples);
    const OrderedJson out = json_of(run({"compute", (folder / "few.poff").string()}));
    CHECK(out["diagnostics"]["theorem"].is_null());
    CHECK(out["diagnostics"]["text"] == "there is nothing to prove");
  }
}

TEST_CASE("balls of a WPOFF file are counted, and one of radius zero has a centre only") {
  const RunResult result = run({"compute", "tests/data/balls.wpoff"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: tests/data/balls.wpoff:8:7: a ball has radius zero"));
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  const OrderedJson out = OrderedJson::parse(result.out);
  CHECK(out["input"] == OrderedJson{{"file", "tests/data/balls.wpoff"},
                                    {"format", "wpoff"},
                                    {"samples", 0},
                                    {"distinct", 0},
                                    {"contours", 0},
                                    {"balls", 6}});
  const OrderedJson& balls = out["structures"]["balls"];
  CHECK(balls["balls"] == 6);
  CHECK(balls["zero_radius"] == 1);
  CHECK(balls["radius_min"] == 0.0);
  CHECK(balls["radius_max"] == 2.0);
  CHECK(out["layers"]["b-inner-disks"]["disks"] == 5);
  CHECK(out["layers"]["b-inner-disks"]["radius_sum"].get<double>() == Approx(6.2));
  CHECK(out["layers"]["b-inner-circles"]["circles"] == 5);
  CHECK(out["layers"]["b-inner-centers"]["points"] == 6);
}

TEST_CASE("the boundary of a union has as many arcs as pieces, and a length") {
  const OrderedJson out =
      json_of(run({"compute", "-", "--layers", "b-union-boundary"}, {.input = "WPOFF 2 0 0\n0 0 5\n20 1 2\n"}));
  const OrderedJson& layer = out["layers"]["b-union-boundary"];
  CHECK(layer["arcs"] == 2);
  CHECK(layer["length"].get<double>() == Approx(14.0 * std::numbers::pi));
  CHECK_FALSE(layer.contains("zero_length"));
}

TEST_CASE("without balls there are no radii to tell") {
  const OrderedJson out = json_of(run({"compute", kDude, "--layers", "b-inner-disks"}));
  CHECK(out["structures"]["balls"]["balls"] == 0);
  CHECK(out["structures"]["balls"]["radius_min"].is_null());
  CHECK(out["layers"]["b-inner-disks"]["disks"] == 0);
}

TEST_CASE("without times the same command gives the same bytes") {
  const std::vector<std::string> command{"compute", kDude, "--layers", "all", "--no-timing"};
  const RunResult first = run(command);
  CHECK(first.exit_code == 0);
  CHECK(first.out == run(command).out);
  CHECK_THAT(first.out, !Catch::Contains("\"ms\""));
  CHECK(OrderedJson::parse(first.out)["layers"].size() > 15);
}

TEST_CASE("the axis of an annulus is one component with one cycle") {
  const OrderedJson out = json_of(run({"compute", "-", "--layers", "medial-axis"}, {.input = annulus(60)}));
  CHECK(out["input"]["file"] == "-");
  CHECK(out["input"]["format"] == "pairs");
  CHECK(out["structures"]["medial-axis"]["components"] == 1);
  CHECK(out["structures"]["medial-axis"]["cycles"] == 1);
  // The middle circle, drawn by chords between nodes.
  CHECK(out["structures"]["medial-axis"]["length"].get<double>() == Approx(2 * 3.14159 * 7.5).epsilon(0.02));
}

TEST_CASE("an open star of segments, rays and lines is counted by kind") {
  // Two samples: their Voronoi diagram is one line.
  const OrderedJson two = json_of(run({"compute", "-", "--layers", "voronoi,delaunay"}, {.input = "0 0\n1 0\n"}));
  CHECK(two["layers"]["voronoi"]["lines"] == 1);
  CHECK(two["layers"]["delaunay"]["segments"] == 1);
  CHECK(two["layers"]["delaunay"]["length"] == 1.0);
  // A unit square: cocircular, so one Voronoi edge has no length.
  const OrderedJson square = json_of(run({"compute", "-", "--layers", "voronoi"}, {.input = "0 0\n1 0\n1 1\n0 1\n"}));
  CHECK(square["layers"]["voronoi"]["rays"] == 4);
  CHECK(square["layers"]["voronoi"]["segments"] == 0);
  CHECK(square["layers"]["voronoi"]["zero_length"] == 1);
}

TEST_CASE("duplicates count as samples and once as distinct") {
  const OrderedJson out = json_of(run({"compute", "-"}, {.input = "0 0\n1 0\n0 0\n-0 0\n0 1\n"}));
  CHECK(out["input"]["samples"] == 5);
  CHECK(out["input"]["distinct"] == 3);
}

TEST_CASE("degenerate samples give numbers or null, never NaN") {
  for (const char* input : {"POFF 0 0 0", "0 0\n", "0 0\n0 0\n", "0 0\n1 1\n2 2\n", "1e150 0\n-1e150 0\n0 1e150\n",
                            "1e-150 0\n-1e-150 0\n0 1e-150\n", "0 0\n1e-30 1\n1 0\n"}) {
    INFO(input);
    const RunResult result = run({"compute", "-", "--layers", "all"}, {.input = input});
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK(OrderedJson::accept(result.out));
    CHECK_THAT(result.out, !Catch::Contains("nan", Catch::CaseSensitive::No));
    CHECK_THAT(result.out, !Catch::Contains("infinity", Catch::CaseSensitive::No));
  }
}

TEST_CASE("the result goes to a file when one is named, and nowhere else") {
  const TemporaryFolder folder;
  const RunResult result = run({"compute", kDude, "--no-timing", "-o", (folder / "a.json").string()});
  CHECK(result.exit_code == 0);
  CHECK(result.out.empty());
  CHECK(contents_of(folder / "a.json") == run({"compute", kDude, "--no-timing", "-o", "-"}).out);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a name that is not UTF-8 does not spoil the JSON") {
  const TemporaryFolder folder;
  const std::string path = folder.write("a\xff.txt", "0 0\n").string();
  CHECK_NOTHROW(json_of(run({"compute", path})));
}
