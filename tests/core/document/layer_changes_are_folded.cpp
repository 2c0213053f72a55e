// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "core/document/timeline/layer_fold.h"

using namespace mes;

namespace {

using Entry = LayerConfiguration::Entry;

// What a change means, in plain loops.
void apply_slowly(const LayersChanged& change, LayerConfiguration& configuration) {
  auto& layers = configuration.layers;
  for (const Entry& entry : change.changed) {
    const auto old = std::ranges::find(layers, entry.layer, &Entry::layer);
    if (old == layers.end())
      layers.push_back(entry);
    else
      *old = entry;
  }
  if (!change.order.empty()) {
    std::vector<Entry> ordered;
    for (std::size_t i = 0; i < change.order.size(); ++i) {
      if (std::ranges::find(change.order, change.order[i]) - change.order.begin() < static_cast<std::ptrdiff_t>(i))
        continue;
      for (const Entry& entry : layers)
        if (entry.layer == change.order[i]) ordered.push_back(entry);
    }
    layers = ordered;
  }
  if (change.image) configuration.image = *change.image;
}

std::string some_layer(Rng& random) {
  return "layer-" + std::to_string(random.below(12));
}

LayersChanged some_change(Rng& random) {
  LayersChanged out;
  for (std::uint64_t n = random.below(4); n > 0; --n) {
    LayerStyle style;
    style.opacity = 0.01 * static_cast<double>(random.below(100));
    out.changed.push_back({some_layer(random), random.below(2) == 0, style});
  }
  if (random.below(4) == 0)
    for (std::uint64_t n = random.below(16); n > 0; --n) out.order.push_back(some_layer(random));
  if (random.below(5) == 0) out.image = BackgroundImage{"a.png", {1, static_cast<double>(random.below(9))}, 2};
  return out;
}

}  // namespace

TEST_CASE("changes of layers folded are the changes one after the other") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Rng random(seed);
    LayerConfiguration expected{{{"layer-3", true, {}}, {"layer-1", false, {}}, {"layer-3", false, {}}}, {}};
    LayerConfiguration one_by_one = expected;
    LayerFold fold(expected);
    for (int i = 0; i < 60; ++i) {
      const LayersChanged change = some_change(random);
      apply_slowly(change, expected);
      apply(change, one_by_one);
      fold.apply(change);
      REQUIRE(fold.configuration() == expected);
      REQUIRE(one_by_one == expected);
    }
  }
}

TEST_CASE("layers that are not kept leave no trace in a fold") {
  LayerFold fold({{{"points", true, {}}, {"of the future", true, {}}}, {}},
                 [](std::string_view layer) { return layer == "points" || layer == "curve"; });
  CHECK(fold.configuration().layers == std::vector<Entry>{{"points", true, {}}});
  fold.apply({{{"x", true, {}}, {"curve", true, {}}}, {"x", "curve", "points"}, {}});
  CHECK(fold.configuration().layers == std::vector<Entry>{{"curve", true, {}}, {"points", true, {}}});
  fold.apply({{}, {"x"}, {}});
  CHECK(fold.configuration().layers.empty());
}

TEST_CASE("a change costs no more after a million layers than at first") {
  // Quadratic, this would take hours.
  LayerFold fold;
  for (int i = 0; i < 1'000'000; ++i) fold.apply({{{"layer " + std::to_string(i), true, {}}}, {}, {}});
  CHECK(fold.configuration().layers.size() == 1'000'000);
}
