// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "run_binary.h"
#include "tests/io/temporary_folder.h"

using namespace mes::test;
using nlohmann::json;

namespace {

std::vector<json> json_lines_of(const std::string& text) {
  std::vector<json> out;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) out.push_back(json::parse(line));
  return out;
}

}  // namespace

TEST_CASE("a session is played from standard input") {
  const RunResult result = run({"play", "-"}, {.input = contents_of(kEditedBean)});
  CHECK(result.exit_code == 0);
  CHECK(result.out == contents_of("tests/data/edited_bean.digests"));
  CHECK(run({"play", "-"}, {.input = "{"}).exit_code == 3);
}

TEST_CASE("each step of a session has the same digests in every run and build") {
  const RunResult result = run({"play", kEditedBean});
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out == contents_of("tests/data/edited_bean.digests"));
  const auto lines = json_lines_of(result.out);
  REQUIRE(lines.size() == 12);
  CHECK(lines[0]["what"] == "open");
  // The undo leads back to the document before the drag.
  CHECK(lines[9]["what"] == "undo");
  CHECK(lines[9]["document"] == lines[2]["document"]);
  // Looking elsewhere computes nothing anew.
  CHECK(lines[11]["what"] == "view");
  CHECK(lines[11]["layers"] == lines[10]["layers"]);
}

TEST_CASE("what is played has the digests that the same document has when it is computed afresh") {
  const std::vector<json> whole = json_lines_of(run({"play", kEditedBean}).out);
  json session = json::parse(contents_of(kEditedBean));
  const json timeline = session["timeline"];
  const TemporaryFolder folder;
  // With the session cut off after each of its entries in turn.
  std::size_t compared = 0;
  for (std::size_t length = 4; length <= timeline.size(); ++length) {
    session["timeline"] = json(timeline.begin(), timeline.begin() + static_cast<std::ptrdiff_t>(length));
    const std::string file = folder.write("cut.json", session.dump()).string();
    const std::vector<json> played = json_lines_of(run({"play", file}).out);
    REQUIRE(!played.empty());
    const json& last = played.back();
    REQUIRE(played.size() <= whole.size());
    CHECK(last["layers"] == whole[played.size() - 1]["layers"]);
    std::string layers;
    for (const auto& [layer, digest] : last["digests"].items()) layers += (layers.empty() ? "" : ",") + layer;
    const RunResult computed = run({"compute", file, "--layers", layers, "--digest"});
    REQUIRE(computed.exit_code == 0);
    const json afresh = json::parse(computed.out)["layers"];
    for (const auto& [layer, digest] : last["digests"].items()) {
      INFO("after " << length << " entries: " << layer);
      CHECK(afresh[layer]["digest"] == digest);
      ++compared;
    }
  }
  CHECK(compared > 50);
  // Undo leads back to the same drawing.
  CHECK(whole[9]["digests"] == whole[2]["digests"]);
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
  CHECK(json_lines_of(empty.out).size() == 1);
}
