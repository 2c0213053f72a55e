// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/layers/words/statistics_text.h"

using namespace mes;

TEST_CASE("statistics are copied as lines with tabs and as JSON, with every digit") {
  std::vector<NodeReport> nodes(2);
  nodes[0].structure = "delaunay";
  nodes[0].state = NodeState::up_to_date;
  nodes[0].update_ms = 0.5;
  nodes[0].touched = 3;
  nodes[0].kernel = "EPICK";
  nodes[0].stats = {{"length", 1.0 / 3.0},
                    {"none", std::numeric_limits<double>::infinity()},
                    {"degree", std::vector<std::int64_t>{0, 2, 5}},
                    {"rung", std::string("shortcut")}};
  nodes[1].structure = "never-asked";
  CHECK(statistics_as_tsv(nodes) ==
        "delaunay\tms\t0.5\ndelaunay\ttouched\t3\ndelaunay\tlength\t0.3333333333333333\ndelaunay\tnone\tnull\n"
        "delaunay\tdegree\t[0,2,5]\ndelaunay\trung\tshortcut\n");
  const auto json = nlohmann::json::parse(statistics_as_json(nodes));
  CHECK(json.size() == 1);
  CHECK(json["delaunay"]["length"] == 1.0 / 3.0);
  CHECK(json["delaunay"]["none"].is_null());
  CHECK(json["delaunay"]["kernel"] == "EPICK");
  CHECK(to_text(nodes[0].stats[0].value) == "0.333333");
  CHECK(to_text(nodes[0].stats[1].value) == "-");
  CHECK(to_text(nodes[0].stats[2].value) == "0, 2, 5");
}
