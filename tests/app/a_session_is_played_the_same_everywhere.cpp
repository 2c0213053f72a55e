// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using nlohmann::json;

namespace {

constexpr const char* kSession = "tests/data/edited_bean.json";

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> out;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) out.push_back(json::parse(line));
  return out;
}

}  // namespace

TEST_CASE("a session is played from standard input") {
  const RunResult result = run({"play", "-"}, {.input = contents_of(kSession)});
  CHECK(result.exit_code == 0);
  CHECK(result.out == contents_of("tests/data/edited_bean.digests"));
  CHECK(run({"play", "-"}, {.input = "{"}).exit_code == 3);
}

TEST_CASE("each step of a session has the same digests in every run and build") {
  const RunResult result = run({"play", kSession});
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out == contents_of("tests/data/edited_bean.digests"));
  const auto lines = lines_of(result.out);
  REQUIRE(lines.size() == 12);
  CHECK(lines[0]["what"] == "open");
  // The undo leads back to the document before the drag.
  CHECK(lines[9]["what"] == "undo");
  CHECK(lines[9]["document"] == lines[2]["document"]);
  // Looking elsewhere computes nothing anew.
  CHECK(lines[11]["what"] == "view");
  CHECK(lines[11]["layers"] == lines[10]["layers"]);
}

TEST_CASE("what cannot be played is bad input, said in one line") {
  const TemporaryFolder folder;
  for (const std::string text :
       {"POFF 1 0 0\n1 2\n", "{\"mesecina\":\"session\",\"schema\":99}", "{\"mesecina\":\"session\"",
        R"({"mesecina":"session","schema":1,"timeline":[{"undo":true}]})"}) {
    const RunResult result = run({"play", folder.write("s.json", text).string()});
    CHECK(result.exit_code == 3);
    CHECK(result.out.empty());
    CHECK(std::ranges::count(result.err, '\n') == 1);
  }
  CHECK(run({"play", (folder / "none.json").string()}).exit_code == 3);
  CHECK(run({"play"}).exit_code == 2);
  const RunResult empty = run({"play", folder.write("s.json", R"({"mesecina":"session","schema":1})").string()});
  CHECK(empty.exit_code == 0);
  CHECK(lines_of(empty.out).size() == 1);
}
