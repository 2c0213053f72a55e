// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "run_binary.h"
#include "tests/cli/inputs.h"

using mes::test::kDude;
using mes::test::run;
using mes::test::RunResult;

namespace {

void require_usage_error(const std::vector<std::string>& arguments, const std::vector<std::string>& says) {
  const RunResult result = run(arguments);
  INFO(Catch::StringMaker<std::vector<std::string>>::convert(arguments));
  INFO(result.err);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("mesecina: "));
  CHECK(std::ranges::count(result.err, '\n') == 1);
  for (const std::string& part : says) CHECK_THAT(result.err, Catch::Contains(part));
}

}  // namespace

TEST_CASE("an unknown layer names the nearest ones") {
  require_usage_error({"compute", kDude, "--layers", "medial-axs"}, {"\"medial-axs\"", "did you mean medial-axis?"});
  require_usage_error({"compute", kDude, "--layers", "points,interior-voronoi-disk"}, {"interior-voronoi-disks"});
  require_usage_error({"compute", kDude, "--layers", "axis"}, {"medial-axis"});
  require_usage_error({"compute", kDude, "--layers", "points,,curve"}, {"unknown layer \"\""});
  require_usage_error({"export", kDude, "--layer", "Points", "--format", "csv"}, {"points"});
  require_usage_error({"render", kDude, "--layers", std::string(100'000, 'x'), "-o", "a.png"},
                      {"(100000 characters)"});
}

TEST_CASE("what this build cannot do is said, not ignored") {
  require_usage_error({"compute", kDude, "--set", "union-shortcut=0.5"}, {"whole number"});
  require_usage_error({"compute", kDude, "--precision", "exakt"}, {"unknown number type", "exact-roots"});
  require_usage_error({"export", kDude, "--layer", "points,curve", "--format", "csv"},
                      {"holds one layer", "geojson, wkt, gpkg, fgb, their areas, dxf and svg-path hold several"});
  require_usage_error({"export", kDude, "--layer", "points", "--format", "npoff"},
                      {"layer points has no curve with normals to write as npoff", "csv can hold it"});
  require_usage_error({"export", kDude, "--layer", "", "--format", "wkt"}, {"--layer"});
  require_usage_error(
      {"export", kDude, "--layer", "points", "--format", "xls"},
      {"csv, poff, wpoff, npoff, geojson, wkt, geojson-areas, wkt-areas, gpkg, gpkg-areas, fgb, fgb-areas, dxf or "
       "svg-path"});
  require_usage_error({"export", kDude, "--layer", "voronoi-disks", "--format", "poff"}, {"no points"});
  require_usage_error({"export", kDude, "--layer", "medial-axis", "--format", "wpoff"}, {"no disks"});
  require_usage_error({"render", kDude, "-o", "a.svgz"}, {"must end in .png", ".svg"});
  require_usage_error({"render", kDude, "-o", "a.jpeg"}, {".png"});
}

TEST_CASE("sizes, views, scales and colours are checked") {
  for (const char* size : {"0x10", "10", "10x", "x", "-1x5", "32769x1", "1e3x5", "10x10x10", "1 x1"})
    require_usage_error({"render", kDude, "-o", "a.png", "--size", size}, {"--size"});
  for (const char* view :
       {"all", "0,0,1", "0,0,1,1,1", "0,0,0,1", "0,0,nan,1", "0,0,1e999,1", "0,0,1,", "-1e308,0,1e308,1"})
    require_usage_error({"render", kDude, "-o", "a.png", "--view", view}, {"--view"});
  for (const char* option : {"--legend-at", "--scale-bar-at"})
    for (const char* place : {"left", "top-left:5", "top-left:5,", "bottom-right:-1,2", "top-right:1,6000"})
      require_usage_error({"render", kDude, "-o", "a.png", option, place},
                          {option, "expects top-left, top-right, bottom-left or bottom-right", "millimetres", place});
  for (const char* scale : {"0", "-1", "nan", "1000", "two"})
    require_usage_error({"render", kDude, "-o", "a.png", "--scale", scale}, {"--scale"});
  for (const char* color : {"white", "fff", "#12345", "12345g", ""})
    require_usage_error({"render", kDude, "-o", "a.png", "--background", color}, {"--background"});
}

TEST_CASE("an empty value is no value, and not the same as none") {
  require_usage_error({"render", kDude, "-o", "a.png", "--bundle", ""}, {"--bundle", "is empty"});
  require_usage_error({"render", kDude, "-o", ""}, {"--output", "is empty"});
  require_usage_error({"compute", "", "--layers", "curve"}, {"FILE", "is empty"});
  require_usage_error({"compute", kDude, "--layers", ""}, {"--layers", "is empty"});
  require_usage_error({"play", "tests/data/edited_bean.json", "--frames", ""}, {"--frames", "is empty"});
  require_usage_error({"demo", "--video", ""}, {"--video", "is empty"});
  require_usage_error({"evolve", kDude, "--evolution", "", "--steps", "1"}, {"--evolution", "is empty"});
  require_usage_error({"manual", "-o", ""}, {"--output", "is empty"});
}

TEST_CASE("settings need a parameter that exists") {
  require_usage_error({"compute", kDude, "--set", "lambda"}, {"NAME=VALUE"});
  require_usage_error({"compute", kDude, "--set", "=1"}, {"NAME=VALUE"});
  require_usage_error({"compute", kDude, "--set", "lambda=1"}, {"unknown parameter \"lambda\""});
}

TEST_CASE("missing and surplus arguments point to the help") {
  require_usage_error({"compute"}, {"FILE", "mesecina compute --help"});
  require_usage_error({"render", kDude}, {"--output"});
  require_usage_error({"export", kDude}, {"required"});
  require_usage_error({"list"}, {"WHAT"});
  require_usage_error({"list", "colours"}, {"layers"});
  require_usage_error({"compute", kDude, "second"}, {"second"});
  require_usage_error({"compute", kDude, "--colour", "red"}, {"--colour"});
  require_usage_error({"--colour"}, {"--colour", "mesecina --help"});
  require_usage_error({"compute", kDude, "--from", "docx"}, {"\"docx\"", "poff"});
}

TEST_CASE("what is wrong with options is said in plain words, and long or unprintable ones are cut") {
  require_usage_error({"compute", kDude, "--colour", "red"},
                      {"there is no option \"--colour\"; see mesecina compute"});
  require_usage_error({"compute", kDude, "--layer", "points"},
                      {"there is no option \"--layer\"; did you mean --layers?; see mesecina compute --help"});
  require_usage_error({"compute", kDude, "--layer=points"},
                      {"there is no option \"--layer\"; did you mean --layers?"});
  require_usage_error({"compute", kDude, "-x"}, {"there is no option \"-x\"; see"});
  require_usage_error({"compute", kDude, "second", "third"}, {"unexpected \"second\"; see"});
  require_usage_error({"compute", kDude, "--layers"}, {"--layers expects IDS; see"});
  require_usage_error({"render", kDude, "--size"}, {"--size expects WxH; see"});
  require_usage_error({"compute", kDude, "--layers", "points", "--layers", "curve"},
                      {"--layers is given more than once; see"});
  require_usage_error({"compute", kDude, "--no-timing=x"},
                      {"--no-timing expects no value, or true or false, not \"x\"; see"});
  for (const std::string& word : {std::string(100'000, 'x'), "--" + std::string(100'000, 'x')})
    require_usage_error({"compute", kDude, word}, {"characters)"});
  require_usage_error({"compute", kDude, "--a\x1b[31mb"}, {"there is no option \"--a\\x1b[31mb\""});
}

TEST_CASE("a mistyped command names the one that is meant") {
  require_usage_error({"rendr", kDude, "-o", "a.png"}, {"\"rendr\"", "did you mean render?"});
  require_usage_error({"lists"}, {"did you mean list?"});
  require_usage_error({"transects", kDude}, {"\"transects\" is neither a command nor a file"});
  CHECK(run({"help"}).out == run({"--help"}).out);
  CHECK(run({"help", "centerline"}).out == run({"centerline", "--help"}).out);
  CHECK(run({"help", "comput"}).err == "mesecina: unknown command \"comput\"; did you mean compute?\n");
}

TEST_CASE("help and version are results") {
  const RunResult version = run({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.out == "mesecina " MESECINA_VERSION "\n");
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{}, {"compute"}, {"export"}, {"render"}, {"list"}}) {
    std::vector<std::string> arguments = command;
    arguments.push_back("--help");
    const RunResult help = run(arguments);
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    CHECK_THAT(help.out, Catch::Contains("Usage:"));
    // Flags are named as they are typed.
    CHECK_THAT(help.out, !Catch::Contains("{"));
  }
}

TEST_CASE("a style that makes no sense is refused with what there is") {
  const auto refused = [](const std::string& style, const std::vector<std::string>& says) {
    require_usage_error(
        {"render", kDude, "--layers", "curve,curve-normals,points", "--set-style", style, "-o", "a.png"}, says);
  };
  refused("curve:color-map=virdis", {"unknown colour map \"virdis\"", "viridis"});
  refused("curve-normals:color-map=viridis", {"curve-normals has no number"});
  refused("curve", {"LAYER:KEY=VALUE"});
  refused("curve:", {"KEY=VALUE"});
  refused("curve:flat", {"KEY=VALUE"});
  refused("curve:opacity=2", {"from 0 to 1"});
  refused("curve:opacity=nan", {"from 0 to 1"});
  refused("curve:color=red", {"RRGGBB"});
  refused("curve:flat=yes", {"on or off"});
  refused("curve:colr=000000", {"unknown style key", "color"});
  refused("curve:range=3:1", {"LOW:HIGH"});
  refused("curv:flat=on", {"unknown layer", "curve"});
  refused("voronoi:flat=on", {"voronoi, which is not drawn"});
}

TEST_CASE("a count that is refused is refused in the same words, whatever is wrong with it") {
  const std::vector<std::string> never{"-3", "2.5", "1e3", "x", "+4", " 5", "18446744073709551616", "nan"};
  std::vector<std::string> from_one = never;
  from_one.emplace_back("0");
  const auto sweep = [](const std::string& steps) {
    return std::vector<std::string>{"sweep", kDude, "--parameter", "a-scale=1..2", "--steps", steps};
  };
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& what,
                          const std::string& value) {
    require_usage_error(arguments, {"mesecina: " + what + ", not \"" + value + "\"\n"});
  };
  for (const std::string& bad : from_one) {
    refused(sweep(bad), "--steps expects a whole number from 1 to 100000", bad);
    refused({"shape", "circle", "--samples", bad}, "--samples expects a whole number from 1 to 10000000", bad);
    refused({"text", "a", "--samples", bad}, "--samples expects a whole number from 1 to 10000000", bad);
    refused({"sample", "tests/data/does-not-matter.svg", "--samples", bad},
            "--samples expects a whole number from 1 to 10000000", bad);
  }
  refused(sweep("100001"), "--steps expects a whole number from 1 to 100000", "100001");
  for (const std::string& bad : never) {
    refused({"evolve", kDude, "--evolution", "smooth", "--steps", bad},
            "--steps expects a whole number from 0 to 2^64 - 1", bad);
    refused({"shape", "circle", "--seed", bad}, "--seed expects a whole number from 0 to 2^64 - 1", bad);
  }
  for (const char* bad : {"-3", "1", "2.5", "x", "10001", "nan"})
    refused({"shape", "gear", "--set", std::string("teeth=") + bad},
            "--set teeth expects a whole number from 2 to 10000", bad);
}
