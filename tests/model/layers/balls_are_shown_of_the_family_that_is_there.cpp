// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/editing/editor.h"
#include "app/layers/ball_families.h"
#include "app/layers/empty_view.h"
#include "app/playing/evolution_layers.h"
#include "core/builtins/builtins.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

using Entry = LayerConfiguration::Entry;

/// Ids of the visible layers, bottom first.
std::vector<std::string> visible(const LayerConfiguration& layers) {
  std::vector<std::string> out;
  for (const Entry& entry : layers.layers)
    if (entry.visible) out.push_back(entry.layer);
  return out;
}

LayerConfiguration of(std::vector<std::string> ids) {
  LayerConfiguration out;
  for (std::string& id : ids) out.layers.push_back({std::move(id), true, {.opacity = 0.3}});
  return out;
}

LayerStack stack_showing(const std::vector<std::string>& ids) {
  LayerStack out(layer_descriptors());
  out.set_configuration(of(ids));
  return out;
}

/// A document with some samples and balls.
struct Plane {
  Editor editor{[](const auto&) {}};
  Plane(std::size_t samples, std::size_t balls) {
    SampleData data;
    for (std::size_t i = 0; i < samples; ++i) data.positions.push_back({static_cast<double>(i), 0.0});
    for (std::size_t i = 0; i < balls; ++i) data.balls.push_back({{static_cast<double>(i), 0.0}, 1.0});
    REQUIRE(editor.load(data));
  }
  const Document& document() const { return editor.document(); }
};

const std::vector<std::string> kUnion{"a-inner-disks", "a-dual-faces", "a-union-boundary", "a-v-points"};

}  // namespace

TEST_CASE("every layer of a family has its counterpart in each other one") {
  for (const LayerDescriptor& layer : layer_descriptors()) {
    const auto family = family_of(layer);
    if (!family) continue;
    LayerConfiguration only = of({std::string(layer.id), "b-union-boundary"});
    for (const FamilyKind to : kBallFamilies) {
      const auto ids = visible(in_family(layer_descriptors(), only, to));
      INFO(layer.id);
      REQUIRE_FALSE(ids.empty());
      for (const std::string& id : ids) CHECK(family_of(layer_descriptors()[find_layer(id)]) == to);
    }
  }
}

TEST_CASE("a bundle of the union is that of the chosen family, in its order and with its styles") {
  const LayerConfiguration own = in_family(layer_descriptors(), of(kUnion), FamilyKind::own);
  CHECK(visible(own) == std::vector<std::string>{"b-inner-disks", "b-dual-faces", "b-union-boundary", "b-v-points"});
  for (const Entry& entry : own.layers) CHECK(entry.style.opacity == 0.3);
  CHECK(family_of(layer_descriptors(), own) == FamilyKind::own);
  CHECK(in_family(layer_descriptors(), own, FamilyKind::inner) == of(kUnion));
}

TEST_CASE("a layer whose counterpart was removed stays") {
  std::vector<LayerDescriptor> layers(layer_descriptors().begin(), layer_descriptors().end());
  layers[find_layer("b-v-points")].is_removed = true;
  CHECK(visible(in_family(layers, of(kUnion), FamilyKind::own)) ==
        std::vector<std::string>{"b-inner-disks", "b-dual-faces", "b-union-boundary", "a-v-points"});
}

TEST_CASE("another family takes the places of the one before, and each layer keeps its own style") {
  LayerStack layers = stack_showing({"points", "a-dual-faces", "a-v-points"});
  LayerStyle style = layers.style(layers.find("p-v-points"));
  style.point_size_px = 17.0;
  layers.set_style(layers.find("p-v-points"), style);
  const LayerConfiguration before = layers.configuration();
  layers.set_configuration(in_family(layer_descriptors(), before, FamilyKind::polar));
  CHECK(visible(layers.configuration()) == std::vector<std::string>{"points", "p-dual-faces", "p-v-points"});
  CHECK(layers.style(layers.find("p-v-points")).point_size_px == 17.0);
  CHECK(layers.style(layers.find("a-v-points")).opacity == 0.3);
  CHECK(in_family(layer_descriptors(), layers.configuration(), FamilyKind::inner) == before);
}

TEST_CASE("own balls that are drawn without their union stay beside the union of others") {
  const LayerConfiguration layers = of({"b-inner-disks", "b-inner-centers", "a-union-boundary"});
  CHECK(family_of(layer_descriptors(), layers) == FamilyKind::inner);
  CHECK(visible(in_family(layer_descriptors(), layers, FamilyKind::polar)) ==
        std::vector<std::string>{"b-inner-disks", "b-inner-centers", "p-union-boundary"});
  CHECK(visible(in_family(layer_descriptors(), layers, FamilyKind::own)) ==
        std::vector<std::string>{"b-inner-disks", "b-inner-centers", "b-union-boundary"});
}

TEST_CASE("the family is one that the document has, and changes only when it has lost its own") {
  FamilyChoice choice;
  CHECK_FALSE(choice.follow(Plane(0, 0).document()));
  CHECK(choice.follow(Plane(0, 5).document()));
  CHECK(choice.family() == FamilyKind::own);
  CHECK_FALSE(choice.follow(Plane(9, 5).document()));
  CHECK(choice.family() == FamilyKind::own);
  CHECK(choice.follow(Plane(9, 0).document()));
  CHECK(choice.family() == FamilyKind::inner);
  choice.choose(FamilyKind::own);
  CHECK_FALSE(choice.follow(Plane(9, 0).document()));
  CHECK(choice.family() == FamilyKind::own);
  choice.begin();
  CHECK(choice.family() == FamilyKind::inner);
}

TEST_CASE("bundles of inner balls stand for all, those of others for what the document has") {
  const LayerConfiguration inner = of(kUnion);
  const LayerConfiguration polar = in_family(layer_descriptors(), inner, FamilyKind::polar);
  CHECK(adapted(layer_descriptors(), inner, FamilyKind::own, Plane(9, 5).document()) ==
        in_family(layer_descriptors(), inner, FamilyKind::own));
  CHECK(adapted(layer_descriptors(), polar, FamilyKind::inner, Plane(9, 0).document()) == polar);
  CHECK(adapted(layer_descriptors(), polar, FamilyKind::own, Plane(0, 5).document()) ==
        in_family(layer_descriptors(), inner, FamilyKind::own));
  const LayerConfiguration both = of({"a-dual-faces", "p-dual-faces"});
  CHECK(adapted(layer_descriptors(), both, FamilyKind::own, Plane(0, 5).document()) == both);
  CHECK(adapted(layer_descriptors(), of({"points"}), FamilyKind::own, Plane(0, 5).document()) == of({"points"}));
}

TEST_CASE("where nothing is seen the reason is given, and what is offered is of what there is") {
  const auto nothing = [](LayerIndex) { return false; };
  const auto offer = [&](const Plane& plane, const std::vector<std::string>& ids) {
    const auto empty = empty_view(plane.document(), stack_showing(ids), nothing);
    REQUIRE(empty);
    CHECK_FALSE(empty->text.empty());
    return empty->offer;
  };
  CHECK_FALSE(empty_view(Plane(0, 0).document(), stack_showing(kUnion), nothing));
  CHECK_FALSE(empty_view(Plane(0, 5).document(), stack_showing(kUnion), [](LayerIndex) { return true; }));
  CHECK(offer(Plane(0, 5), kUnion) == ShowInstead::own_family);
  CHECK(offer(Plane(0, 5), {"curve", "medial-axis"}) == ShowInstead::own_balls);
  CHECK(offer(Plane(9, 0), {"b-dual-faces"}) == ShowInstead::inner_family);
  CHECK(offer(Plane(9, 0), {"label-conflicts"}) == ShowInstead::samples);
  CHECK(offer(Plane(9, 0), {}) == ShowInstead::samples);
  CHECK(offer(Plane(0, 5), {}) == ShowInstead::own_balls);
  // A picture to trace is not made of the document.
  CHECK(offer(Plane(9, 0), {"image"}) == ShowInstead::samples);
}

TEST_CASE("what is offered shows layers of what there is") {
  LayerStack layers = stack_showing(kUnion);
  show_instead(ShowInstead::own_family, layers);
  CHECK(visible(layers.configuration()) == visible(in_family(layer_descriptors(), of(kUnion), FamilyKind::own)));
  show_instead(ShowInstead::samples, layers);
  CHECK(layers.is_visible(layers.find("points")));
}

TEST_CASE("an evolution that no visible layer follows names layers that do") {
  for (const auto& evolution : builtins().evolutions().all()) {
    LayerStack layers = stack_showing({});
    const std::vector<LayerIndex> wanted = layers_to_show(*evolution, layers, {});
    INFO(evolution->descriptor.id);
    REQUIRE_FALSE(wanted.empty());
    for (const LayerIndex layer : wanted) layers.set_visible(layer, true);
    CHECK(layers_to_show(*evolution, layers, {}).empty());
  }
  CHECK_FALSE(layers_to_show(*find_evolution("b-growing"), stack_showing(kUnion), {}).empty());
  CHECK(layers_to_show(*find_evolution("a-growing"), stack_showing(kUnion), {}).empty());
  CHECK_FALSE(layers_to_show(*find_evolution("smooth"), stack_showing({"b-inner-disks"}), {}).empty());

  Document balls;
  balls.apply(*insert_balls(balls, std::vector{Disk{{1.0, 2.0}, 3.0}}));
  const LayerStack hidden = stack_showing({});
  const std::vector<LayerIndex> wanted = layers_to_show(*find_evolution("alpha-growing"), hidden, balls);
  REQUIRE_FALSE(wanted.empty());
  for (const LayerIndex layer : wanted) CHECK(hidden.descriptor(layer).id.starts_with("b-alpha-"));
  const auto shown_by = [](std::string_view evolution, const LayerStack& layers, const Document& document) {
    std::vector<std::string> ids;
    for (const LayerIndex layer : layers_to_show(*find_evolution(evolution), layers, document))
      ids.emplace_back(layers.descriptor(layer).id);
    return ids;
  };
  using Ids = std::vector<std::string>;
  CHECK(shown_by("scale-axis-shrinking", hidden, {}) ==
        Ids{"scale-axis-grown-disks", "scale-axis-boundary", "scale-axis"});
  CHECK(shown_by("scale-axis-shrinking", stack_showing({"p-v-points"}), {}) ==
        Ids{"p-scale-axis-grown-disks", "p-scale-axis-boundary", "p-scale-axis"});
  CHECK(shown_by("scale-skeleton", hidden, {}) == Ids{"a-scale-skeleton"});
  CHECK(shown_by("scale-skeleton", hidden, balls) == Ids{"b-scale-skeleton"});
}
