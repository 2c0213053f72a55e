// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/run_binary.h"

using mes::test::run;
using mes::test::RunResult;
using Json = nlohmann::json;

TEST_CASE("what is listed has a name of its own, as a table and as JSON") {
  for (const char* what : {"layers", "structures", "evolutions", "formats", "parameters", "precisions", "actions",
                           "bundles", "shapes"}) {
    INFO(what);
    const RunResult table = run({"list", what});
    CHECK(table.exit_code == 0);
    CHECK(table.err.empty());
    const RunResult json = run({"list", what, "--json"});
    CHECK(json.exit_code == 0);
    const Json entries = Json::parse(json.out);
    REQUIRE(entries.is_array());
    CHECK(static_cast<std::size_t>(std::ranges::count(table.out, '\n')) == entries.size());
    std::set<std::string> ids;
    for (const Json& entry : entries) {
      CHECK(ids.insert(entry["id"].get<std::string>()).second);
      CHECK_THAT(table.out, Catch::Contains(entry["id"].get<std::string>()));
    }
    CHECK(ids.size() >= 3);
  }
}

TEST_CASE("every layer that is listed can be computed") {
  const Json layers = Json::parse(run({"list", "layers", "--json"}).out);
  std::string ids;
  for (const Json& layer : layers) ids += (ids.empty() ? "" : ",") + layer["id"].get<std::string>();
  const RunResult result = run({"compute", "tests/data/ne_hawaii.poff", "--layers", ids});
  CHECK(result.exit_code == 0);
  const Json computed = Json::parse(result.out)["layers"];
  CHECK(computed.size() == layers.size());
  const std::set<std::string> counts{"points", "segments", "rays", "lines", "circles", "disks", "triangles", "arcs"};
  for (const Json& layer : layers)
    for (const Json& kind : layer["kinds"])
      CHECK(computed[layer["id"].get<std::string>()].contains(kind.get<std::string>() + "s"));
}

TEST_CASE("formats say what they can do") {
  const Json formats = Json::parse(run({"list", "formats", "--json"}).out);
  const auto poff = std::ranges::find(formats, "poff", [](const Json& format) { return format["id"]; });
  REQUIRE(poff != formats.end());
  CHECK((*poff)["read"] == true);
  CHECK((*poff)["write"] == true);
  CHECK((*poff)["extensions"] == Json{".poff"});
}
