// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/actions/actions.h"
#include "app/actions/fuzzy_match.h"
#include "app/actions/palette.h"
#include "core/base/lower_case.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

std::vector<PaletteEntry> entries_of(const std::vector<std::string>& names) {
  std::vector<PaletteEntry> out;
  for (const std::string& name : names) out.push_back({.kind = "Thing", .name = name});
  return out;
}

std::vector<std::string> found(const std::vector<PaletteEntry>& entries, std::string_view query,
                               const std::vector<std::string>& recent = {}) {
  std::vector<std::string> out;
  for (const PaletteHit& hit : find_entries(entries, query, recent)) out.push_back(entries[hit.entry].name);
  return out;
}

}  // namespace

TEST_CASE("letters are found in their order, in any case, and words in any order") {
  CHECK(fuzzy_match("", "Curve"));
  CHECK(fuzzy_match("  ", "Curve"));
  CHECK(fuzzy_match("CRV", "Curve")->letters == std::vector<std::size_t>{0, 2, 3});
  CHECK(fuzzy_match("axis medial", "Medial axis"));
  CHECK_FALSE(fuzzy_match("vcr", "Curve"));
  CHECK_FALSE(fuzzy_match("curves", "Curve"));
  CHECK_FALSE(fuzzy_match("c", ""));
  // At the beginnings of words rather than inside of them.
  CHECK(fuzzy_match("ma", "Normal medial axis")->letters == std::vector<std::size_t>{7, 14});
  // Side by side rather than scattered.
  CHECK(fuzzy_match("al", "x a l al")->letters == std::vector<std::size_t>{6, 7});
}

TEST_CASE("what matches best comes first: whole names, beginnings of words, letters side by side, short names") {
  CHECK(found(entries_of({"Inner Voronoi disks", "Voronoi", "Voronoi and Delaunay"}), "voronoi").front() ==
        "Voronoi");
  CHECK(found(entries_of({"Select all", "Samples", "Save as..."}), "sa") ==
        std::vector<std::string>{"Samples", "Save as...", "Select all"});
  CHECK(found(entries_of({"Zoom out", "Undo"}), "undo") == std::vector<std::string>{"Undo"});
  CHECK(found(entries_of({"One-step axis", "Medial axis", "Axis nodes"}), "max").front() == "Medial axis");
}

TEST_CASE("names with scattered letters are listed only if nothing has the letters together") {
  CHECK(fuzzy_match("CRV", "Curve")->scattered == 1);
  CHECK(fuzzy_match("ma", "Normal medial axis")->scattered == 0);
  CHECK(fuzzy_match("ial", "Medial axis")->scattered == 0);
  const auto entries = entries_of({"Select all", "Snap to all", "Sample", "Save as..."});
  CHECK(found(entries, "sap").size() == 2);
  CHECK(found(entries, "sam") == std::vector<std::string>{"Sample"});
}

TEST_CASE("other words than the name count less, and are not emphasised") {
  std::vector<PaletteEntry> entries = entries_of({"Normals of the layer", "Curve"});
  entries[1].kind = "Layer";
  entries[1].more = "curve-id";
  CHECK(found(entries, "layer") == std::vector<std::string>{"Normals of the layer", "Curve"});
  const auto hits = find_entries(entries, "layer curve", {});
  REQUIRE(hits.size() == 1);
  CHECK(hits.front().letters == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(found(entries, "curve-id") == std::vector<std::string>{"Curve"});
}

TEST_CASE("an entry with a handicap comes after others of its name, and is found nevertheless") {
  std::vector<PaletteEntry> entries = entries_of({"Shapes", "Make a shape..."});
  CHECK(found(entries, "shape").front() == "Shapes");
  entries[0].handicap = -10.0;
  CHECK(found(entries, "shape") == std::vector<std::string>{"Make a shape...", "Shapes"});
  CHECK(found(entries, "") == std::vector<std::string>{"Shapes", "Make a shape..."});
}

TEST_CASE("without a query all are listed in their order, what was done last at the top") {
  const auto entries = entries_of({"a", "bb", "ccc", "d"});
  CHECK(found(entries, "") == std::vector<std::string>{"a", "bb", "ccc", "d"});
  CHECK(found(entries, " ", {"Thing: ccc", "Thing: bb"}) == std::vector<std::string>{"ccc", "bb", "a", "d"});
  // Of equal matches what was done last, then what can be done.
  auto twins = entries_of({"Undo", "Undo", "Undo"});
  twins[0].is_enabled = false;
  twins[2].kind = "Other";
  const auto order = [&](const std::vector<std::string>& recent) {
    std::vector<std::size_t> out;
    for (const PaletteHit& hit : find_entries(twins, "un", recent)) out.push_back(hit.entry);
    return out;
  };
  CHECK(order({}) == std::vector<std::size_t>{1, 2, 0});
  CHECK(order({"Other: Undo"}) == std::vector<std::size_t>{2, 1, 0});
}

TEST_CASE("the mark goes round by single steps, stops at the ends by pages, and Enter takes what it marks") {
  PaletteList list;
  list.move(1);
  CHECK_FALSE(list.take(0));
  auto entries = entries_of({"one", "two", "three"});
  int done = 0;
  entries[2].run = [&] { done = 3; };
  entries[1].is_enabled = false;
  entries[1].run = [&] { done = 2; };
  list.set_entries(entries);
  list.move(-1);
  CHECK(list.marked() == 2);
  list.move(1);
  CHECK(list.marked() == 0);
  list.move(10);
  CHECK(list.marked() == 2);
  list.move(-10);
  CHECK(list.marked() == 0);
  CHECK_FALSE(list.take(1));
  const auto run = list.take(2);
  REQUIRE(run);
  run();
  CHECK(done == 3);
  list.set_entries(entries);
  CHECK(list.entries()[list.hits().front().entry].name == "three");
  list.set_query("tw");
  CHECK(list.hits().size() == 1);
  CHECK(list.marked() == 0);
}

TEST_CASE("every action and every layer is first when its whole name is typed, but for those of the same name") {
  std::vector<PaletteEntry> entries;
  for (const ActionDescriptor& action : action_descriptors())
    entries.push_back({.kind = "Action", .name = action.name, .more = action.public_id});
  for (const LayerDescriptor& layer : layer_descriptors())
    entries.push_back({.kind = "Layer", .name = std::string(layer.name), .more = std::string(layer.id)});
  for (const PaletteEntry& entry : entries) {
    INFO(entry.name);
    const auto hits = find_entries(entries, lower_case(entry.name), {});
    REQUIRE_FALSE(hits.empty());
    CHECK(entries[hits.front().entry].name == entry.name);
    for (const PaletteHit& hit : hits) {
      CHECK(std::ranges::is_sorted(hit.letters));
      for (const std::size_t at : hit.letters) CHECK(at < entries[hit.entry].name.size());
    }
  }
}
