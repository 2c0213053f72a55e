// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>
#include <utility>
#include <vector>

#include "app/picture/leaving_layers.h"

using namespace mes;

namespace {

ShownPanes asking_for(std::vector<VariantLayer> layers) {
  ShownPanes out;
  out.demand = std::move(layers);
  return out;
}

ShownPanes::Layers in_view(std::vector<VariantLayer> layers) {
  ShownPanes::Layers out;
  for (const VariantLayer layer : layers) out.emplace_back(layer, LayerStyle{});
  return out;
}

/// Layers in one pane, and those that have a picture.
struct OnePane {
  LeavingLayers leaving;
  std::set<VariantLayer> pictures;

  LeavingLayers::HasPicture has_picture() const {
    return [this](VariantLayer layer) { return pictures.contains(layer); };
  }
  ShownPanes::Layers show(const std::vector<VariantLayer>& layers) {
    leaving.follow(asking_for(layers), has_picture());
    return leaving.draw(0, in_view(layers));
  }
  ShownPanes::Layers bring(const std::vector<VariantLayer>& layers) {
    pictures.insert(layers.begin(), layers.end());
    leaving.end_if_complete(has_picture());
    return leaving.draw(0, in_view(layers));
  }
};

}  // namespace

TEST_CASE("layers that others replace stay where they were until the others have pictures") {
  OnePane pane;
  pane.show({1, 2, 3});
  pane.bring({1, 2, 3});
  CHECK(pane.show({2, 4, 5}) == in_view({1, 2, 3, 4, 5}));
  CHECK(pane.leaving.needs(1));
  pane.pictures.insert(4);
  pane.leaving.end_if_complete(pane.has_picture());
  CHECK(pane.leaving.draw(0, in_view({2, 4, 5})) == in_view({1, 2, 3, 4, 5}));
  CHECK(pane.bring({2, 4, 5}) == in_view({2, 4, 5}));
  CHECK_FALSE(pane.leaving.needs(1));
}

TEST_CASE("a third choice in the middle of the way leaves the first picture in view") {
  OnePane pane;
  pane.show({1});
  pane.bring({1});
  pane.show({2});
  CHECK(pane.show({3}) == in_view({1, 2, 3}));
  CHECK(pane.bring({3}) == in_view({3}));
}

TEST_CASE("a layer that is hidden alone leaves at once") {
  OnePane pane;
  pane.show({1, 2});
  pane.bring({1, 2});
  CHECK(pane.show({2}) == in_view({2}));
  // Its picture is still there.
  CHECK(pane.show({1, 2}) == in_view({1, 2}));
  CHECK(pane.show({2}) == in_view({2}));
  // Another one is being computed, and replaces nothing.
  CHECK(pane.show({2, 3}) == in_view({2, 3}));
  CHECK(pane.show({3}) == in_view({3}));
}

TEST_CASE("when the layer that is waited for is hidden, nothing is waited for") {
  OnePane pane;
  pane.show({1});
  pane.bring({1});
  CHECK(pane.show({2}) == in_view({1, 2}));
  CHECK(pane.show({}).empty());
}

TEST_CASE("a layer that stays has its new style, one that leaves the style it had") {
  OnePane pane;
  pane.show({1, 2});
  pane.bring({1, 2});
  ShownPanes::Layers wanted = in_view({2, 3});
  wanted[0].second.opacity = 0.25;
  pane.leaving.follow(asking_for({2, 3}), pane.has_picture());
  const ShownPanes::Layers drawn = pane.leaving.draw(0, wanted);
  REQUIRE(drawn.size() == 3);
  CHECK(drawn[0] == in_view({1})[0]);
  CHECK(drawn[1] == wanted[0]);
}

TEST_CASE("layers of variants leave when the variants change") {
  LeavingLayers leaving;
  std::set<VariantLayer> pictures{1, {1, 1}};
  const auto has_picture = [&](VariantLayer layer) { return pictures.contains(layer); };
  ShownPanes shown = asking_for({1, {1, 1}});
  shown.variants.resize(1);
  shown.versions.resize(1);
  leaving.follow(shown, has_picture);
  leaving.draw(1, in_view({{1, 1}}));
  shown.demand = {2, {1, 2}};
  leaving.follow(shown, has_picture);
  CHECK(leaving.needs(VariantLayer{1, 1}));
  CHECK(leaving.draw(1, in_view({{1, 2}})) == in_view({{1, 1}, {1, 2}}));
  shown.variants.front().has_document = true;
  leaving.follow(shown, has_picture);
  CHECK(leaving.needs(1));
  CHECK_FALSE(leaving.needs(VariantLayer{1, 1}));
}
