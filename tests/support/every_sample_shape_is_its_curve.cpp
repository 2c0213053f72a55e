// SPDX-License-Identifier: GPL-3.0-or-later
// The first picture of a new user must be right: each built-in shape reads without a warning, and its one-step crust is
// the curve in its file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "core/io/format.h"
#include "core/structures/axis/medial_axis.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

const std::filesystem::path kShapes = "assets/shapes";

nlohmann::json read_index() {
  std::ifstream stream(kShapes / "index.json");
  return nlohmann::json::parse(stream);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // indices in the file, equal to the rows of a new document

struct ExpectedEdges {
  std::set<Edge> curve;
  std::set<Edge>
      bridges;  ///< between the ends of open contours: the crust may close them, as it knows nothing of openness
};

ExpectedEdges expected_edges(const SampleData& data) {
  ExpectedEdges edges;
  for (const SampleData::Contour& contour : data.contours) {
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i + 1 < n; ++i) edges.curve.insert(std::minmax(contour.points[i], contour.points[i + 1]));
    const Edge last = std::minmax(contour.points.front(), contour.points.back());
    (contour.closed ? edges.curve : edges.bridges).insert(last);
  }
  return edges;
}

}  // namespace

TEST_CASE("the crust of every sample shape is its curve, but for gaps that it bridges") {
  const nlohmann::json index = read_index();
  REQUIRE(index.size() >= 12);
  for (const auto& entry : index) {
    const std::string file = entry.at("file");
    INFO(file);
    const Expected<LoadedFile> loaded = read_sample_file(kShapes / file);
    REQUIRE(loaded);
    CHECK(loaded->format == "poff");
    CHECK(loaded->warnings.empty());
    CHECK_FALSE(loaded->data.contours.empty());

    Document document;
    const auto delta = replace_all(document, loaded->data);
    REQUIRE(delta);
    Graph graph{builtins()};
    const LayerIndex wanted[] = {find_layer("medial-axis"), find_layer("curve")};
    graph.set_demand(wanted);
    graph.post(std::make_shared<const DocumentDelta>(*delta));
    FramePatch patch;
    JobControl job;
    REQUIRE(graph.run(patch, job));

    const auto& delaunay = graph.structures().get<Delaunay>();
    const auto& crust = graph.structures().get<OneStepCrust>();
    std::set<Edge> found;
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      const EdgeRow& row = delaunay.edge(edge);
      if (!row.is_alive() || !crust.is_crust(edge)) continue;
      found.insert(std::minmax(delaunay.site_sample(row.v[0]).index(), delaunay.site_sample(row.v[1]).index()));
    }
    const ExpectedEdges expected = expected_edges(loaded->data);
    std::size_t bridged = 0;
    for (const Edge& bridge : expected.bridges) bridged += found.erase(bridge);
    CHECK(found == expected.curve);
    CHECK(crust.odd_count() == 2 * (expected.bridges.size() - bridged));
  }
}

TEST_CASE("every sample shape is listed, with a licence, and every listed file exists") {
  std::set<std::string> listed;
  for (const auto& entry : read_index()) {
    listed.insert(entry.at("file").get<std::string>());
    CHECK_FALSE(entry.at("name").get<std::string>().empty());
    CHECK(entry.at("description").get<std::string>().size() < 100);
    CHECK_FALSE(entry.at("licence").get<std::string>().empty());
  }
  std::set<std::string> present;
  for (const auto& item : std::filesystem::directory_iterator(kShapes))
    if (item.path().extension() == ".poff") present.insert(item.path().filename().string());
  CHECK(listed == present);
}
