// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/cli/run_binary.h"
#include "tests/io/temporary_folder.h"

using mes::test::contents_of;
using mes::test::run;
using mes::test::RunResult;
using mes::test::TemporaryFolder;
using Json = nlohmann::json;

TEST_CASE("docs/manual.md is what the program says of itself") {
  const RunResult result = run({"manual"});
  REQUIRE(result.exit_code == 0);
  INFO(
      "docs/manual.md is out of date; renew it from the root of the project with\n"
      "  build/release/mesecina manual -o docs/manual.md");
  // Not compared within CHECK, which would print both.
  const bool is_up_to_date = contents_of("docs/manual.md") == result.out;
  CHECK(is_up_to_date);
}

TEST_CASE("everything that is listed is in the manual, whatever the user has of their own") {
  const TemporaryFolder folder;
  const std::string manual = run({"manual"}).out;
  const std::vector<std::string> elsewhere{"XDG_DATA_HOME=" + folder.path().string()};
  CHECK(run({"manual"}, {.environment = elsewhere}).out == manual);
  for (const char* what :
       {"layers", "structures", "evolutions", "formats", "parameters", "precisions", "actions", "color-maps"})
    for (const Json& entry : Json::parse(run({"list", what, "--json"}).out)) {
      INFO(what << ": " << entry["id"]);
      CHECK_THAT(manual, Catch::Contains('`' + entry["id"].get<std::string>() + '`'));
    }
  for (const Json& bundle : Json::parse(run({"list", "bundles", "--json"}, {.environment = elsewhere}).out))
    CHECK_THAT(manual, Catch::Contains("\n| " + bundle["id"].get<std::string>() + " | "));
}

TEST_CASE("each line of the contents leads to one heading") {
  std::istringstream lines(run({"manual"}).out);
  const std::regex link(R"( *\* \[(.*)\]\(#(.*)\))");
  std::set<std::string> places;
  std::vector<std::string> announced;
  std::vector<std::string> headings;
  bool is_code = false;
  for (std::string line; std::getline(lines, line);) {
    std::smatch parts;
    if (line.starts_with("```")) is_code = !is_code;
    if (std::regex_match(line, parts, link)) {
      announced.push_back(parts[1]);
      CHECK(places.insert(parts[2]).second);
    } else if (!is_code && line.starts_with("##")) {
      headings.push_back(line.substr(line.find(' ') + 1));
    }
  }
  CHECK(headings.size() > 20);
  CHECK(announced == headings);
}

TEST_CASE("the manual goes to a file, or one line says why not") {
  const TemporaryFolder folder;
  const auto file = folder / "manual.md";
  const RunResult written = run({"manual", "-o", file.string()});
  CHECK(written.exit_code == 0);
  CHECK(written.out.empty());
  CHECK_THAT(contents_of(file), Catch::StartsWith("# "));
  CHECK(run({"manual", "-o", (folder / "no" / "manual.md").string()}).exit_code == 4);
  CHECK(run({"manual", "all"}).exit_code == 2);
  // A folder of assets that has lost its bundles.
  std::filesystem::create_directories(folder / "assets" / "shapes");
  const RunResult bare = run({"manual"}, {.environment = {"MESECINA_ASSETS=" + (folder / "assets").string()}});
  CHECK(bare.exit_code == 3);
  CHECK(bare.err == "mesecina: the bundles that come with the program are missing\n");
}
