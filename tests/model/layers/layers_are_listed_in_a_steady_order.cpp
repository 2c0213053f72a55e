// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <set>

#include "app/layers/layer_counts.h"
#include "app/layers/layer_list.h"
#include "app/layers/layer_topics.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

using LayerRows = std::vector<LayerIndex>;

std::map<std::string, LayerRows> rows_of(const LayerStack& layers, const LayerListOptions& options) {
  std::map<std::string, LayerRows> out;
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

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
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
  REQUIRE(listing.sections.size() > 2);
  const LayerSection& shown = listing.sections.front();
  CHECK(shown.title == "Shown");
  CHECK(shown.kind == LayerSectionKind::shown);
  CHECK(shown.rows == LayerRows{layers.find("points"), layers.find("curve"), layers.find("delaunay")});
  CHECK(listing.sections[1].title == "Delaunay & Voronoi");
  CHECK(listing.sections[1].rows.front() == layers.find("delaunay"));
  CHECK(listing.left_out == 0);
}

TEST_CASE("every layer is listed once in its subject, those of a union once for all families") {
  const LayerStack layers = showing({});
  for (const FamilyKind family : kBallFamilies) {
    std::set<LayerIndex> listed;
    std::size_t own = 0;
    for (const LayerSection& section : list_layers(layers, {.family = family}).sections)
      for (const LayerIndex layer : section.rows) {
        CHECK(listed.insert(layer).second);
        const auto of = family_of(layers.descriptor(layer));
        CHECK(of.has_value() == section.is_of_union);
        CHECK(of.value_or(family) == family);
        own += of ? 1U : 0U;
      }
    CHECK(own >= 38);
    std::size_t expected = own;
    for (const LayerDescriptor& descriptor : layers.descriptors()) expected += family_of(descriptor) ? 0U : 1U;
    CHECK(listed.size() == expected);
  }
}

TEST_CASE("subjects name every layer of the program, and no other") {
  std::set<std::string> unions;
  std::set<std::string> others;
  for (const LayerDescriptor& descriptor : layer_descriptors())
    if (family_of(descriptor))
      unions.insert(descriptor.of_any_family);
    else
      others.insert(descriptor.id);
  for (const LayerTopic& topic : layer_topics())
    for (const std::string_view name : words_of(topic.names)) {
      INFO(topic.title << ": " << name);
      CHECK((topic.is_of_union ? unions : others).erase(std::string(name)) == 1);
    }
  CHECK(unions.empty());
  CHECK(others.empty());
}

TEST_CASE("a layer that no subject names is listed in that of its group") {
  LayerDescriptor descriptor;
  descriptor.id = "new";
  const auto title = [&](LayerGroup group) {
    descriptor.group = group;
    return layer_topics()[topic_place_of(descriptor).topic].title;
  };
  CHECK(title(LayerGroup::experiments) == "Experiments");
  CHECK(title(LayerGroup::crust_axis) == "Medial axis");
  CHECK(title(LayerGroup::delaunay_voronoi) == "Delaunay & Voronoi");
  CHECK(title(LayerGroup::union_p) == "Union: balls & boundary");
  for (const LayerGroup group : kLayerGroups) CHECK_FALSE(title(group).empty());
}

TEST_CASE("what is shown of another family is among what is shown, and nowhere else") {
  const LayerStack layers = showing({"p-v-points", "points"});
  std::size_t times = 0;
  for (const LayerSection& section : list_layers(layers, {.family = FamilyKind::own}).sections)
    for (const LayerIndex layer : section.rows)
      if (layer == layers.find("p-v-points")) {
        ++times;
        CHECK(section.kind == LayerSectionKind::shown);
      }
  CHECK(times == 1);
}

TEST_CASE("a search keeps headings, and says how much it leaves out") {
  const LayerStack layers = showing({"points"});
  const LayerListing listing = list_layers(layers, {.search = "medial disks"});
  std::size_t rows = 0;
  for (const LayerSection& section : listing.sections) {
    CHECK(section.kind == LayerSectionKind::topic);
    for (const LayerIndex layer : section.rows) CHECK(matches_search(layers.descriptor(layer), "medial disks"));
    rows += section.rows.size();
  }
  CHECK(listing.sections.size() >= 2);
  CHECK(listing.listed == rows);
  CHECK(listing.listed + listing.left_out == layers.size());
  CHECK(list_layers(layers, {.search = "no such layer"}).left_out == layers.size());
}

TEST_CASE("a search finds a layer of a union once, of the family in use if that matches") {
  const LayerStack layers = showing({"points"});
  const auto found = [&](const std::string& search, FamilyKind family) {
    LayerRows out;
    for (const auto& [title, rows] : rows_of(layers, {.search = search, .family = family}))
      out.insert(out.end(), rows.begin(), rows.end());
    return out;
  };
  CHECK(found("dual faces degenerate", FamilyKind::polar) == LayerRows{layers.find("p-degenerate-dual-faces")});
  CHECK(found("p-v-points", FamilyKind::inner) == LayerRows{layers.find("p-v-points")});
  CHECK(found("a-v-points", FamilyKind::polar) == LayerRows{layers.find("a-v-points")});
}

TEST_CASE("favourites stand first, in the family in use, and are taken back in any family") {
  const LayerStack layers = showing({"points"});
  std::vector<std::string> favorites;
  toggle_favorite(layers, favorites, layers.find("p-v-points"));
  toggle_favorite(layers, favorites, layers.find("voronoi"));
  const auto first = [&](FamilyKind family) {
    return list_layers(layers, {.family = family, .favorites = favorites}).sections.front();
  };
  CHECK(first(FamilyKind::inner).title == "Favourites");
  CHECK(first(FamilyKind::inner).rows == LayerRows{layers.find("a-v-points"), layers.find("voronoi")});
  CHECK(first(FamilyKind::own).rows == LayerRows{layers.find("b-v-points"), layers.find("voronoi")});
  CHECK(is_favorite(layers, favorites, layers.find("b-v-points")));
  CHECK_FALSE(is_favorite(layers, favorites, layers.find("delaunay")));
  // The scale axis of the samples is another layer than that of a union.
  toggle_favorite(layers, favorites, layers.find("scale-axis"));
  CHECK_FALSE(is_favorite(layers, favorites, layers.find("a-scale-axis")));
  toggle_favorite(layers, favorites, layers.find("a-v-points"));
  toggle_favorite(layers, favorites, layers.find("scale-axis"));
  CHECK(favorites == std::vector<std::string>{"voronoi"});
  // A favourite that an experiment brought is kept while the experiment is away.
  favorites.emplace_back("of-an-experiment");
  CHECK(first(FamilyKind::inner).rows == LayerRows{layers.find("voronoi")});
  // A search has subjects alone.
  CHECK(list_layers(layers, {.search = "voronoi", .favorites = favorites}).sections.front().kind ==
        LayerSectionKind::topic);
}

TEST_CASE("only what is shown, and everything by order") {
  const LayerStack layers = showing({"points", "p-v-points", "a-v-points"});
  const LayerListing shown = list_layers(layers, {.only_shown = true});
  CHECK(shown.listed == 3);
  CHECK(shown.left_out == layers.size() - 3);
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

TEST_CASE("the count of a layer holds for one document, its settings and one registry") {
  auto registry = std::make_shared<const Registry>();
  ComputationSettings settings;
  LayerCounts counts;
  counts.follow(7, settings, registry);
  CHECK_FALSE(counts.of(3));
  counts.note(3, 12);
  counts.note(4, 0);
  counts.follow(7, settings, registry);
  CHECK(counts.of(3) == std::size_t{12});
  CHECK(counts.of(4) == std::size_t{0});
  const auto is_forgotten = [&](auto change) {
    counts.note(3, 12);
    change();
    counts.follow(7, settings, registry);
    const bool out = !counts.of(3);
    counts.follow(7, settings, registry);
    return out;
  };
  CHECK(is_forgotten([&] { counts.follow(8, settings, registry); }));
  CHECK(is_forgotten([&] { settings.precision = Precision::exact; }));
  CHECK(is_forgotten([&] { registry = std::make_shared<const Registry>(); }));
}
