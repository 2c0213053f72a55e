// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/layers/layer_stack.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

std::vector<LayerDescriptor> five_layers() {
  std::vector<LayerDescriptor> out;
  for (const std::string_view id : {"a", "b", "c", "d", "e"}) {
    LayerDescriptor descriptor;
    descriptor.id = id;
    descriptor.name = id;
    descriptor.visible_at_start = id < "c";
    out.push_back(descriptor);
  }
  return out;
}

std::vector<LayerIndex> order_of(const LayerStack& stack) {
  return {stack.order().begin(), stack.order().end()};
}

}  // namespace

TEST_CASE("a stack starts from the descriptors") {
  const auto layers = five_layers();
  const LayerStack stack(layers);
  CHECK(order_of(stack) == std::vector<LayerIndex>{0, 1, 2, 3, 4});
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{0, 1});
}

TEST_CASE("moving puts a layer just above or below another") {
  const auto layers = five_layers();
  LayerStack stack(layers);
  stack.move(0, 3, true);
  CHECK(order_of(stack) == std::vector<LayerIndex>{1, 2, 3, 0, 4});
  stack.move(4, 1, false);
  CHECK(order_of(stack) == std::vector<LayerIndex>{4, 1, 2, 3, 0});
  stack.move(2, 2, true);
  CHECK(order_of(stack) == std::vector<LayerIndex>{4, 1, 2, 3, 0});
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{1, 0});
}

TEST_CASE("after any moves every layer is there once") {
  const auto layers = five_layers();
  LayerStack stack(layers);
  Rng random(7);
  for (int i = 0; i < 1000; ++i) {
    const auto layer = static_cast<LayerIndex>(random.below(5));
    const auto target = static_cast<LayerIndex>(random.below(5));
    const bool above = random.below(2) == 0;
    stack.move(layer, target, above);
    auto order = order_of(stack);
    if (layer != target) {
      const auto at = std::ranges::find(order, layer) - order.begin();
      const auto at_target = std::ranges::find(order, target) - order.begin();
      REQUIRE(at == at_target + (above ? 1 : -1));
    }
    std::ranges::sort(order);
    REQUIRE(order == std::vector<LayerIndex>{0, 1, 2, 3, 4});
  }
}

TEST_CASE("only visibility changes what is asked of the engine") {
  const auto layers = five_layers();
  LayerStack stack(layers);
  const auto before = stack.demand_revision();
  LayerStyle style = stack.style(0);
  style.opacity = 0.25;
  stack.set_style(0, style);
  stack.move(0, 4, true);
  stack.set_visible(0, true);
  CHECK(stack.demand_revision() == before);
  CHECK_FALSE(stack.has_default_style(0));
  stack.reset_style(0);
  CHECK(stack.has_default_style(0));
  stack.set_visible(4, true);
  CHECK(stack.demand_revision() != before);
}

TEST_CASE("solo shows one layer and gives the others back") {
  const auto layers = five_layers();
  LayerStack stack(layers);
  stack.solo(3);
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{3});
  stack.end_solo();
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{0, 1});
  stack.solo(3);
  stack.set_visible(2, true);
  CHECK(stack.soloed() == kNoLayer);
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{0, 1, 2});
}

TEST_CASE("the search box takes words in any case and order") {
  LayerDescriptor layer;
  layer.id = "interior-voronoi-disks";
  layer.name = "Interior Voronoi disks";
  CHECK(matches_search(layer, ""));
  CHECK(matches_search(layer, "DISK int"));
  CHECK(matches_search(layer, "  voronoi-d "));
  CHECK_FALSE(matches_search(layer, "disk exterior"));
  layer.tooltip = "Empty circles, filled";
  CHECK(matches_search(layer, "Inscribed balls"));  // synonyms
  CHECK(matches_search(layer, "disk empty"));
  CHECK_FALSE(matches_search(layer, "fi"));     // too short for a tooltip
  CHECK_FALSE(matches_search(layer, "illed"));  // no beginning
}

TEST_CASE("a configuration brings everything back, whatever the order and names in it") {
  const auto layers = five_layers();
  LayerStack stack(layers);
  stack.move(0, 4, true);
  stack.set_visible(3, true);
  LayerStyle style;
  style.color_map = "viridis";
  style.range_locked = true;
  style.range_high = 7.5;
  stack.set_style(2, style);
  stack.set_image({"map.png", {1, 2}, 3});
  const LayerConfiguration kept = stack.configuration();

  stack.reset();
  CHECK(stack.image().file.empty());
  stack.solo(1);
  stack.set_configuration(kept);
  CHECK(stack.soloed() == kNoLayer);
  CHECK(stack.configuration() == kept);

  const std::uint64_t demand = stack.demand_revision();
  stack.set_configuration(kept);
  CHECK(stack.demand_revision() == demand);

  // Named twice, unknown, not named at all.
  stack.set_configuration(
      {{{"d", true, {}}, {"of-the-future", true, {}}, {"b", false, style}, {"d", false, {}}}, {}});
  CHECK(order_of(stack) == std::vector<LayerIndex>{2, 4, 0, 3, 1});
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{3});
  CHECK(stack.style(1) == style);
  CHECK(stack.style(2) == style);
}

TEST_CASE("a style is given to another layer without what only the first one means by it") {
  LayerDescriptor radius;
  radius.scalar = "radius";
  LayerDescriptor lambda;
  lambda.scalar = "lambda";
  LayerDescriptor nothing;
  const LayerStyle style{.opacity = 0.4,
                         .line_width_px = 3.0,
                         .color_map = "viridis",
                         .range_locked = true,
                         .range_low = 2.0,
                         .range_high = 7.0};
  CHECK(style_for(radius, radius, style) == style);
  const LayerStyle other = style_for(lambda, radius, style);
  CHECK(other.color_map == "viridis");
  CHECK_FALSE(other.range_locked);
  CHECK(other.range_low == LayerStyle().range_low);
  CHECK(other.range_high == LayerStyle().range_high);
  CHECK(other.opacity == 0.4);
  CHECK(other.line_width_px == 3.0);
  CHECK(style_for(nothing, radius, style).color_map.empty());
  CHECK_FALSE(style_for(nothing, radius, style).range_locked);
}

TEST_CASE("layers that are missing keep their places and styles") {
  const auto layers = five_layers();
  LayerStack stack(layers);
  const LayerConfiguration before = stack.configuration();
  LayerConfiguration foreign = before;
  LayerStyle style;
  style.opacity = 0.25;
  foreign.layers.insert(foreign.layers.begin(), {"y", false, {}});
  foreign.layers.insert(foreign.layers.begin() + 3, {"z", true, style});
  foreign.layers.insert(foreign.layers.begin() + 4, {"x", true, {}});
  stack.set_configuration(foreign);
  CHECK(stack.configuration() == foreign);
  CHECK(stack.missing_count() == 3);
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{0, 1});
  // They go along with the layer below them.
  stack.move(1, 4, true);
  CHECK(stack.configuration().layers[6].layer == "z");
  stack.move(1, 0, true);
  CHECK(stack.configuration() == foreign);
  // A difference leads there and back.
  LayerStack other(layers);
  other.apply(difference(before, foreign));
  CHECK(other.configuration() == foreign);
  other.apply(difference(foreign, before));
  CHECK(other.configuration() == before);
  CHECK(other.missing_count() == 0);
  LayerConfiguration restyled = foreign;
  restyled.layers[3].visible = false;
  stack.apply(difference(foreign, restyled));
  CHECK(stack.configuration() == restyled);
  // A bundle that does not name them hides them, and undo shows them again.
  const LayerConfiguration shown = stack.configuration();
  stack.set_configuration(before);
  CHECK(stack.missing_count() == 3);
  const LayerConfiguration hidden = stack.configuration();
  REQUIRE(hidden.layers.size() == 8);
  for (std::size_t i = 0; i < 3; ++i) CHECK_FALSE(hidden.layers[i].visible);
  CHECK(
      std::ranges::equal(hidden.layers.begin() + 3, hidden.layers.end(), before.layers.begin(), before.layers.end()));
  stack.apply(difference(hidden, shown));
  CHECK(stack.configuration() == shown);
  stack.forget_missing();
  CHECK(stack.configuration() == before);
}

TEST_CASE("layers come and go, and those that stay look as before") {
  const auto five = five_layers();
  LayerStack stack(five);
  stack.move(0, 3, true);
  stack.set_visible(3, true);
  LayerStyle wide = stack.style(2);
  wide.line_width_px = 7.0;
  stack.set_style(2, wide);

  // "c" and "e" are gone; "f", which is shown at start, and "g" are new.
  auto other = five;
  other[2].is_removed = other[4].is_removed = true;
  for (const std::string_view id : {"f", "g"}) {
    other.push_back(five[1]);
    other.back().id = id;
    other.back().visible_at_start = id == "f";
  }
  const std::uint64_t demand = stack.demand_revision();
  stack.set_descriptors(other);
  CHECK(order_of(stack) == std::vector<LayerIndex>{1, 3, 5, 6, 0});
  CHECK(stack.visible_layers() == std::vector<LayerIndex>{1, 3, 5, 0});
  CHECK(stack.demand_revision() > demand);
  CHECK(stack.find("c") == kNoLayer);
  CHECK(stack.missing_count() == 2);

  // They come back, and look as they did.
  auto again = other;
  again[2].is_removed = false;
  again[5].is_removed = true;
  stack.set_visible(6, true);
  stack.set_descriptors(again);
  CHECK(order_of(stack) == std::vector<LayerIndex>{1, 2, 3, 6, 0});
  CHECK(stack.style(2) == wide);
  CHECK_FALSE(stack.is_visible(2));
  CHECK(stack.is_visible(6));
  CHECK(stack.missing_count() == 2);
  stack.reset();
  CHECK(order_of(stack) == std::vector<LayerIndex>{0, 1, 2, 3, 6});
}
