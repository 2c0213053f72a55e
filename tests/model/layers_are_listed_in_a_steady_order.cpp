// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "app/layers/layer_list.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

std::map<std::string, std::vector<LayerIndex>> rows_of(const LayerStack& layers, const LayerListOptions& options) {
  std::map<std::string, std::vector<LayerIndex>> out;
  for (const LayerSection& section : list_layers(layers, options).sections) out[section.title] = section.rows;
  return out;
}

LayerStack showing(const std::vector<std::string>& ids) {
  LayerStack out(layer_descriptors());
  LayerConfiguration layers;
  for (const std::string& id : ids) layers.layers.push_back({id, true, {}});
  out.set_configuration(layers);
  return out;
}

}  // namespace

TEST_CASE("by subject, groups keep their rows whatever is shown in whatever order") {
  auto before = rows_of(showing({"points", "curve", "delaunay"}), {});
  auto after = rows_of(showing({"delaunay", "voronoi", "medial-axis", "points"}), {});
  CHECK(before["Shown"].size() == 3);
  CHECK(after["Shown"].size() == 4);
  before.erase("Shown");
  after.erase("Shown");
  CHECK(before == after);
}

TEST_CASE("what is shown comes first, as it lies on each other") {
  const LayerStack layers = showing({"delaunay", "curve", "points"});
  const LayerListing listing = list_layers(layers, {});
  REQUIRE_FALSE(listing.sections.empty());
  const LayerSection& shown = listing.sections.front();
  CHECK(shown.title == "Shown");
  CHECK_FALSE(shown.group);
  CHECK(shown.rows == std::vector<LayerIndex>{layers.find("points"), layers.find("curve"), layers.find("delaunay")});
}

TEST_CASE("groups count what is shown of all their layers") {
  const LayerListing listing = list_layers(showing({"a-v-points", "a-dual-faces", "points"}), {});
  const auto inner = std::ranges::find(listing.sections, std::optional(LayerGroup::union_a), &LayerSection::group);
  REQUIRE(inner != listing.sections.end());
  CHECK(inner->shown == 2);
  CHECK(inner->size == inner->rows.size());
  CHECK(inner->size > 20);
  CHECK(listing.left_out == 0);
}

TEST_CASE("one family of balls is listed, and of the others what is shown") {
  const LayerStack layers = showing({"p-v-points", "points"});
  auto rows = rows_of(layers, {.family = FamilyKind::own});
  CHECK(rows["Own balls"].size() > 20);
  CHECK(rows["Polar balls"] == std::vector<LayerIndex>{layers.find("p-v-points")});
  CHECK(rows.count("Inner balls") == 0);
}

TEST_CASE("a search keeps headings, finds every family and says how much it leaves out") {
  const LayerStack layers = showing({"points"});
  const LayerListing listing = list_layers(layers, {.search = "dual faces"});
  std::size_t rows = 0;
  for (const LayerSection& section : listing.sections) {
    CHECK_FALSE(section.title.empty());
    for (const LayerIndex layer : section.rows) CHECK(matches_search(layers.descriptor(layer), "dual faces"));
    rows += section.rows.size();
  }
  CHECK(listing.sections.size() >= 3);
  CHECK(listing.listed == rows);
  CHECK(listing.listed + listing.left_out == layers.size());
  CHECK(list_layers(layers, {.search = "no such layer"}).left_out == layers.size());
}

TEST_CASE("only what is shown, and everything by order") {
  const LayerStack layers = showing({"points", "p-v-points"});
  const LayerListing shown = list_layers(layers, {.only_shown = true});
  CHECK(shown.listed == 2);
  CHECK(shown.left_out == layers.size() - 2);
  const LayerListing order = list_layers(layers, {.by_order = true});
  REQUIRE(order.sections.size() == 1);
  CHECK(order.sections.front().rows.size() == layers.size());
  CHECK(std::ranges::equal(std::vector(order.sections.front().rows.rbegin(), order.sections.front().rows.rend()),
                           layers.order()));
}

TEST_CASE("under its heading a layer does not repeat it") {
  const auto name = [](std::string_view id) { return short_name(layer_descriptors()[find_layer(id)]); };
  CHECK(name("a-union-boundary") == "Boundary");
  CHECK(name("b-inner-disks") == "Disks");
  CHECK(name("medial-axis") == layer_descriptors()[find_layer("medial-axis")].name);
}
