// SPDX-License-Identifier: GPL-3.0-or-later
// Sources of a user's own, by --with, new and check.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/inputs.h"
#include "workshop.h"

using namespace mes::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr const char* kGabriel = "examples/experiments/gabriel.cpp";

/// An experiment with a structure, by the body of its `rebuild`.
std::string source_with(const std::string& rebuild, const std::string& rest = {}) {
  return "#include <mesecina/experiment.h>\n"
         "using namespace mesecina;\n"
         "struct Mine final : Structure {\n"
         "  std::vector<double> values;\n"
         "  void rebuild(const Inputs& inputs) override {\n" +
         rebuild + "\n  }\n" + rest +
         "  std::vector<OwnTable> tables() const override {\n"
         "    std::vector<OwnTable> out;\n"
         "    out.emplace_back(\"sites\", \"Mine\").rows_of(\"delaunay/sites\").column(\"value\", \"Mine\", "
         "values);\n"
         "    return out;\n"
         "  }\n"
         "};\n"
         "MESECINA_EXPERIMENT(experiment) {\n"
         "  experiment.add_structure<Mine>({.id = \"mine\", .inputs = {\"delaunay\"}});\n"
         "  experiment.add_layer({.id = \"mine-layer\", .rows = \"mine/sites\", .kinds = {PrimitiveKind::point}},\n"
         "                       [](const Inputs&) { return [](Row, Drawn&) {}; });\n"
         "}\n";
}

void check_one_line(const RunResult& ran, int exit_code) {
  INFO(ran.err);
  CHECK(ran.exit_code == exit_code);
  CHECK(std::ranges::count(ran.err, '\n') == 1);
  CHECK_THAT(ran.err, Catch::StartsWith("mesecina: "));
}

}  // namespace

TEST_CASE("an experiment is compiled once, and is there for every command") {
  const Workshop workshop;
  CHECK_THAT(workshop.output_of({"list", "layers", "--with", kGabriel}), Catch::Contains("\ngabriel "));
  CHECK(workshop.calls() == 1);
  const Json computed = Json::parse(
      workshop.output_of({"compute", kBean, "--with", kGabriel, "--layers", "gabriel,delaunay", "--no-timing"}));
  CHECK(computed["layers"]["gabriel"]["segments"] == computed["structures"]["gabriel"]["gabriel_edges"]);
  CHECK(computed["layers"]["gabriel"]["segments"] < computed["layers"]["delaunay"]["segments"]);
  const std::string picture = (workshop / "gabriel.png").string();
  workshop.output_of(
      {"render", kBean, "--with", kGabriel, "--layers", "gabriel", "--size", "200x200", "-o", picture});
  CHECK(fs::file_size(picture) > 1000);
  CHECK_THAT(workshop.output_of({"export", kBean, "--with", kGabriel, "--structure", "gabriel", "--table", "edges",
                                 "--format", "csv"}),
             Catch::Contains("is_gabriel"));
  CHECK(workshop.calls() == 1);
  // Without it there is no such layer.
  CHECK(workshop.run({"compute", kBean, "--layers", "gabriel"}).exit_code == 2);
}

TEST_CASE("an experiment is compiled again when a file that it includes has changed") {
  const Workshop workshop;
  workshop.write("number.h", "inline double number() { return 1.0; }\n");
  const std::string file =
      workshop.write("mine.cpp", "#include \"number.h\"\n" +
                                     source_with("values.assign(inputs.rows(\"delaunay/sites\"), number());"));
  const auto value = [&] {
    const std::string table = workshop.output_of(
        {"export", kBean, "--with", file, "--structure", "mine", "--table", "sites", "--format", "csv"});
    return table.substr(0, table.find('\n', table.find('\n') + 1));
  };
  CHECK_THAT(value(), Catch::EndsWith(",1"));
  CHECK_THAT(value(), Catch::EndsWith(",1"));
  CHECK(workshop.calls() == 1);
  workshop.write("number.h", "inline double number() { return 2.0; }\n");
  CHECK_THAT(value(), Catch::EndsWith(",2"));
  CHECK(workshop.calls() == 2);
}

TEST_CASE("what cannot be used as an experiment is said in one line") {
  const Workshop workshop;
  const auto refusal = [&](const std::string& file) {
    const RunResult ran = workshop.run({"list", "layers", "--with", file});
    check_one_line(ran, 3);
    CHECK(ran.out.empty());
    return ran.err;
  };
  CHECK_THAT(refusal("nowhere.cpp"), Catch::Contains("nowhere.cpp"));
  CHECK_THAT(refusal(kBean), Catch::Contains("an experiment is"));
  fs::create_directory(workshop / "empty");
  CHECK_THAT(refusal((workshop / "empty").string()), Catch::Contains("no experiment"));
  CHECK_THAT(refusal(workshop.write("garbage.so", "no library\n")), Catch::Contains("garbage.so"));
  CHECK_THAT(refusal(workshop.write("wrong.cpp", "#include <mesecina/experiment.h>\nint main() { return x; }\n")),
             Catch::Contains("wrong.cpp:2:21: ") && Catch::Contains("'x' was not declared"));
  CHECK_THAT(refusal(workshop.write("none.cpp", "int nothing = 0;\n")), Catch::Contains("it has no experiment"));
  CHECK_THAT(refusal(workshop.write("other.cpp", "extern \"C\" void mesecina_experiment_of_abi_99() {}\n")),
             Catch::Contains("it has no experiment for version 1"));
  CHECK_THAT(refusal(workshop.write("absent.cpp", source_with("extern int absent(); values.resize(absent());"))),
             Catch::Contains("absent"));
  CHECK_THAT(refusal(workshop.write("thrower.cpp",
                                    "#include <mesecina/experiment.h>\n#include <stdexcept>\n"
                                    "MESECINA_EXPERIMENT(experiment) { experiment.add_parameter({.id = "
                                    "\"a\"}); throw std::runtime_error(\"not today\"); }\n")),
             Catch::Contains("not today"));
  // Two of one name.
  const std::string copy = workshop.write("copy.cpp", content_of(kGabriel));
  check_one_line(workshop.run({"list", "layers", "--with", kGabriel, "--with", copy}), 3);
  // No compiler.
  check_one_line(run({"list", "layers", "--with", kGabriel},
                     {.environment = {"CXX=nowhere-c++", "XDG_CACHE_HOME=" + (workshop / "another").string()}}),
                 3);
}

TEST_CASE("an experiment that crashes ends a trial, not the program") {
  const Workshop workshop;
  const auto refusal = [&](const std::string& name, const std::string& body) {
    const RunResult ran = workshop.run({"compute", kBean, "--with", workshop.write(name, source_with(body))});
    check_one_line(ran, 3);
    return ran.err;
  };
  CHECK_THAT(refusal("segfault.cpp", "volatile int* p = nullptr; *p = 1;"),
             Catch::Contains("crashes in a trial (computing mine of 0 samples): Segmentation fault"));
  CHECK_THAT(refusal("division.cpp", "volatile int zero = 0; values.resize(inputs.rows(\"delaunay/sites\") / zero);"),
             Catch::Contains("Floating point exception"));
  CHECK_THAT(refusal("abort.cpp", "__builtin_abort();"), Catch::Contains("Aborted"));
  // One that shows on larger documents alone ends the program, with a line.
  const RunResult late = workshop.run(
      {"compute", kBean, "--layers", "mine-layer", "--with",
       workshop.write("late.cpp", source_with("if (inputs.rows(\"delaunay/sites\") > 150) __builtin_trap();\n"
                                              "values.assign(inputs.rows(\"delaunay/sites\"), 0.0);"))});
  INFO(late.err);
  CHECK(late.exit_code < 0);
  CHECK_THAT(late.err, Catch::StartsWith("mesecina: crashed (") && Catch::EndsWith("experiments loaded: late.cpp\n"));
  // Exceptions are for the user to see.
  const RunResult thrown =
      workshop.run({"export", kBean, "--with", workshop.write("thrown.cpp", source_with("throw 7;")), "--structure",
                    "mine", "--table", "sites", "--format", "csv"});
  check_one_line(thrown, 1);
  CHECK_THAT(thrown.err, Catch::Contains("mine") && Catch::Contains("no exception"));
}

TEST_CASE("every beginning of an experiment passes its checks") {
  const Workshop workshop;
  for (const char* const what : {"structure", "layer", "evolution", "shape"}) {
    const std::string name = std::string("own-") + what;
    const std::string file = (workshop / (name + ".cpp")).string();
    const RunResult begun = workshop.run({"new", what, name, "-o", file});
    INFO(begun.err);
    REQUIRE(begun.exit_code == 0);
    CHECK_THAT(content_of(file), Catch::Contains("\"" + name + "\"") && !Catch::Contains("my-"));
    const RunResult again = workshop.run({"new", what, name, "-o", file});
    check_one_line(again, 4);
    CHECK(workshop.run({"new", what, name, "-o", file, "--force"}).exit_code == 0);
    const std::string table = workshop.output_of({"check", file});
    CHECK_THAT(table, Catch::StartsWith(name) && Catch::Contains(" ok, "));
  }
  CHECK(workshop.run({"new", "poem", "mine"}).exit_code == 2);
  CHECK(workshop.run({"new", "layer", "Mine"}).exit_code == 2);
  CHECK(workshop.run({"new", "layer", "delaunay"}).exit_code == 2);
  // Together, too.
  std::string shapes = workshop.output_of({"list", "shapes", "--with", (workshop / "own-shape.cpp").string()});
  CHECK_THAT(shapes, Catch::Contains("own-shape"));
  const std::string made =
      workshop.output_of({"shape", "own-shape", "--with", (workshop / "own-shape.cpp").string()});
  CHECK_THAT(made, Catch::StartsWith("POFF "));
}

TEST_CASE("a check finds what an update leaves out, and what is no number") {
  const Workshop workshop;
  const RunResult forgetful = workshop.run(
      {"check",
       workshop.write("forgetful.cpp",
                      source_with("values.assign(inputs.rows(\"delaunay/sites\"), 0.0);\n"
                                  "for (const Row site : inputs.live_rows(\"delaunay/sites\")) values[site] = "
                                  "inputs.column<Point>(\"delaunay/sites/position\")[site].x;",
                                  "  bool update(const Inputs& inputs) override {\n"
                                  "    values.resize(inputs.rows(\"delaunay/sites\"));\n"
                                  "    return true;\n"
                                  "  }\n"))});
  CHECK(forgetful.exit_code == 1);
  CHECK_THAT(forgetful.out, Catch::Contains("update = rebuild") && Catch::Contains("table sites differs"));
  const RunResult infinite = workshop.run(
      {"check", workshop.write("infinite.cpp",
                               source_with("values.assign(inputs.rows(\"delaunay/sites\"), __builtin_nan(\"\"));"))});
  CHECK(infinite.exit_code == 1);
  CHECK_THAT(infinite.out, Catch::Contains("is not a number"));
}
