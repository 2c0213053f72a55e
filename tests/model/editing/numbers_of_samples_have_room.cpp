// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "app/editing/editor.h"
#include "app/picture/sample_texts.h"
#include "app/store/sample_shapes.h"
#include "core/base/rng.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

constexpr NumberRoom kRoom{.digit = 8.0, .apart = 4.0, .height = 10.0, .shift = {5.0, -5.0}};

void load(Editor& editor, std::vector<Vec2> positions) {
  SampleData data;
  data.positions = std::move(positions);
  REQUIRE(editor.load(data));
}

std::vector<Vec2> random_positions(std::size_t count, double extent) {
  Rng random(7);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back({random.uniform(0.0, extent), random.uniform(0.0, extent)});
  return out;
}

std::set<std::uint32_t> numbers_shown(const Editor& editor, const TextPart& part, bool with_index = true) {
  std::set<std::uint32_t> out;
  for (const SampleSlot sample :
       numbers_with_room({editor.document(), with_index ? &editor.index() : nullptr}, part, kRoom))
    out.insert(number_of(editor.document(), sample));
  return out;
}

double width_of(std::uint32_t number) {
  return kRoom.digit * static_cast<double>(std::to_string(number).size()) + kRoom.apart;
}

/// How many of 1, 5, 10, 50, 100, ... divide it.
int roundness(std::uint32_t number) {
  if (number == 0) return 100;
  int out = 0;
  for (std::uint64_t ten = 1; ten <= number; ten *= 10) {
    if (number % ten == 0) ++out;
    if (number % (5 * ten) == 0) ++out;
  }
  return out;
}

/// The rule, by looking at every pair.
std::set<std::uint32_t> by_definition(const std::vector<Vec2>& at, double units_per_px) {
  std::set<std::uint32_t> out;
  for (std::uint32_t i = 0; i < at.size(); ++i) {
    bool has_room = true;
    for (std::uint32_t k = 0; k < at.size() && has_room; ++k) {
      const bool goes_first = roundness(k) != roundness(i) ? roundness(k) > roundness(i) : k < i;
      const Vec2 apart = (1.0 / units_per_px) * (at[k] - at[i]);
      const bool overlap = std::abs(apart.y) < kRoom.height && apart.x < width_of(i) && -apart.x < width_of(k);
      has_room = k == i || !goes_first || !overlap;
    }
    if (has_room) out.insert(i);
  }
  return out;
}

/// The square from the origin, so many pixels wide, and enough around it for each number.
TextPart part_with_square(double extent, double px) {
  const double margin = 100.0 * extent / px;
  return {{{-margin, -margin}, {extent + margin, extent + margin}}, extent / px};
}

}  // namespace

TEST_CASE("numbers are shown as the rule says, with an index or without") {
  const std::vector<Vec2> at = random_positions(1500, 1.0);
  Editor editor({});
  load(editor, at);
  std::size_t before = 0;
  for (const double px : {1.0, 30.0, 200.0, 800.0, 3000.0, 1e5, 1e9}) {
    const TextPart part = part_with_square(1.0, px);
    const std::set<std::uint32_t> expected = by_definition(at, part.units_per_px);
    CHECK(numbers_shown(editor, part) == expected);
    CHECK(numbers_shown(editor, part, false) == expected);
    CHECK(expected.contains(0));
    // Magnifying only adds.
    CHECK(expected.size() >= before);
    before = expected.size();
  }
  CHECK(before == at.size());
}

TEST_CASE("a number stays while the view is moved, and when it is magnified") {
  Editor editor({});
  load(editor, random_positions(5000, 1.0));
  const double units = 1.0 / 900.0;
  const auto part_at = [&](Vec2 low) { return TextPart{{low, low + Vec2{0.4, 0.4}}, units}; };
  const std::set<std::uint32_t> here = numbers_shown(editor, part_at({0.3, 0.3}));
  const std::set<std::uint32_t> there = numbers_shown(editor, part_at({0.31234, 0.29}));
  REQUIRE(here.size() > 100);
  // Of samples well within both, the same.
  const Box2 both{{0.4, 0.4}, {0.6, 0.6}};
  TextPart larger = part_at({0.3, 0.3});
  larger.units_per_px /= 1.7;
  const std::set<std::uint32_t> magnified = numbers_shown(editor, larger);
  std::size_t compared = 0;
  std::size_t added = 0;
  for (const SampleSlot sample : editor.index().in_box(both)) {
    const std::uint32_t number = number_of(editor.document(), sample);
    CHECK(here.contains(number) == there.contains(number));
    if (here.contains(number)) CHECK(magnified.contains(number));
    added += magnified.contains(number) && !here.contains(number) ? 1U : 0U;
    ++compared;
  }
  CHECK(compared > 100);
  CHECK(added > 10);
}

TEST_CASE("samples along a curve show the multiples of one number") {
  Editor editor({});
  std::vector<Vec2> line;
  for (int i = 0; i < 200; ++i) line.push_back({static_cast<double>(i), 0.0});
  load(editor, line);
  const auto steps = [&](double px) {
    std::set<std::uint32_t> out;
    const std::set<std::uint32_t> all = numbers_shown(editor, {{{-1.0, -50.0}, {250.0, 50.0}}, 1.0 / px});
    // Those of three digits take the same room.
    for (auto it = all.lower_bound(100); std::next(it) != all.end(); ++it) out.insert(*std::next(it) - *it);
    return out;
  };
  CHECK(steps(40.0) == std::set<std::uint32_t>{1});
  CHECK(steps(10.0) == std::set<std::uint32_t>{5});
  CHECK(steps(4.0) == std::set<std::uint32_t>{10});
  CHECK(steps(1.0) == std::set<std::uint32_t>{50});
}

TEST_CASE("very many samples are not all looked at, and none of their numbers overlap") {
  Editor editor({});
  const std::vector<Vec2> at = random_positions(60'000, 1.0);
  load(editor, at);
  const TextPart all = part_with_square(1.0, 1000.0);
  const std::set<std::uint32_t> few = numbers_shown(editor, all);
  CHECK(few == numbers_shown(editor, all, false));
  CHECK(few.contains(0));
  CHECK(few.size() > 500);
  // What is left out is not round; all others are as the rule says.
  CHECK(std::ranges::all_of(few, [](std::uint32_t number) { return number % 5 == 0; }));
  for (const std::uint32_t i : few)
    for (const std::uint32_t k : few) {
      const Vec2 apart = (1.0 / all.units_per_px) * (at[k] - at[i]);
      if (i < k && std::abs(apart.y) < kRoom.height) REQUIRE((apart.x >= width_of(i) || -apart.x >= width_of(k)));
    }
  // Near enough, every number is seen.
  const TextPart near{{{0.5, 0.5}, {0.51, 0.51}}, 1e-7};
  CHECK(numbers_shown(editor, near).size() == editor.index().in_box(near.box).size());
  CHECK_FALSE(numbers_shown(editor, near).empty());
}

TEST_CASE("numbers count from the data that are open, and follow edits") {
  Editor editor({});
  load(editor, random_positions(20, 1.0));
  load(editor, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}});
  const TextPart part = part_with_square(1.0, 500.0);
  // Of two samples in one place the lower number.
  CHECK(numbers_shown(editor, part) == std::set<std::uint32_t>{0, 1});
  std::vector<SampleId> ids;
  for (const SampleSlot sample : editor.document().slots_in_input_order())
    ids.push_back(editor.document().id(sample));
  REQUIRE(editor.remove(ids, "Delete"));
  CHECK(numbers_shown(editor, part).empty());
  editor.undo();
  CHECK(numbers_shown(editor, part) == std::set<std::uint32_t>{0, 1});
}

TEST_CASE("extreme views have numbers or none") {
  Editor editor({});
  load(editor, {{0.0, 0.0}, {1e-10, 0.0}, {1e10, 1e10}});
  CHECK(numbers_shown(editor, {{{-1e-13, -1e-13}, {1e-13, 1e-13}}, 1e-16}) == std::set<std::uint32_t>{0});
  CHECK(numbers_shown(editor, {{{-1e12, -1e12}, {1e12, 1e12}}, 1e10}) == std::set<std::uint32_t>{0});
  CHECK(numbers_shown(editor, {{{-1e200, -1e200}, {1e200, 1e200}}, 1e190}) == std::set<std::uint32_t>{0});
  CHECK(numbers_shown(editor, {{}, 1.0}).empty());
  CHECK(numbers_shown(editor, {{{0.0, 0.0}, {1.0, 1.0}}, 0.0}).empty());
  CHECK(numbers_shown(editor, {{{0.0, 0.0}, {1.0, 1.0}}, std::nan("")}).empty());
  Editor empty({});
  CHECK(numbers_shown(empty, part_with_square(1.0, 100.0)).empty());
}

TEST_CASE("a view of the layer has its numbers, clear of the dots that are shown") {
  Editor editor({});
  load(editor, {{0.0, 0.0}, {1.0, 0.0}});
  const auto font = render::Font::read(find_assets({}) / "fonts" / "Inter-Regular.otf");
  REQUIRE(font);
  const LayerIndex indices = find_layer("indices");
  const LayerIndex points = find_layer("points");
  REQUIRE(indices != kNoLayer);
  LayerStyle letters = layer_descriptors()[indices].style;
  const auto texts_of = [&](const std::vector<LayerIndex>& layers, double dot, const render::Font* with) {
    std::vector<render::LayerView> views;
    for (const LayerIndex layer : layers)
      views.push_back({layer, layer == points ? LayerStyle{.point_size_px = dot} : letters});
    add_texts(layer_descriptors(), views, {editor.document(), &editor.index()}, part_with_square(1.0, 300.0), with);
    for (const render::LayerView& view : views) CHECK((view.texts != nullptr) == (view.layer == indices));
    return views.back().texts;
  };
  const auto alone = texts_of({indices}, 0.0, &*font);
  REQUIRE(alone->texts.size() == 2);
  CHECK(alone->texts[1].text == "1");
  CHECK(alone->texts[1].at == Vec2{1.0, 0.0});
  CHECK(alone->size == letters.point_size_px);
  CHECK(alone->shift.x > 0.0);
  CHECK(alone->shift.y < 0.0);
  const auto beside = texts_of({points, indices}, 20.0, &*font);
  CHECK(length(beside->shift) > 10.0);
  CHECK(texts_of({indices}, 0.0, nullptr)->texts.empty());
}
