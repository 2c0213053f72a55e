// SPDX-License-Identifier: GPL-3.0-or-later
// Where a sample or a ball is taken, other things may be drawn over it, or beside it.
#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "app/layers/clicked_layers.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

/// Bottom first; everything else is hidden.
LayerStack stack_of(const std::vector<std::string>& ids) {
  LayerStack out(layer_descriptors());
  LayerConfiguration shown;
  for (const std::string& id : ids) shown.layers.push_back({id, true, out.style(out.find(id))});
  out.set_configuration(shown);
  return out;
}

std::vector<std::string> asked(const std::vector<std::string>& ids, const Clicked& clicked) {
  const LayerStack layers = stack_of(ids);
  std::vector<std::string> out;
  for (const LayerIndex layer : layers_of_click(layers, clicked)) out.emplace_back(layers.descriptor(layer).id);
  return out;
}

using Ids = std::vector<std::string>;
constexpr Clicked kOnSample{.is_ball = false, .is_on_mark = true};
constexpr Clicked kBesideSample{.is_ball = false, .is_on_mark = false};
constexpr Clicked kOnBall{.is_ball = true, .is_on_mark = true};

}  // namespace

TEST_CASE("v-points over the samples, below them or without them are what a click is about") {
  CHECK(asked({"a-inner-disks", "points", "a-v-points"}, kOnSample) == Ids{"a-v-points"});
  CHECK(asked({"a-inner-disks", "a-v-points", "points"}, kOnSample) == Ids{"a-v-points"});
  CHECK(asked({"a-inner-disks", "a-v-points"}, kOnSample) == Ids{"a-v-points", "a-inner-disks"});
}

TEST_CASE("a click on a sample alone is about nothing else") {
  CHECK(asked({"points"}, kOnSample).empty());
  CHECK(asked({"delaunay", "curve", "medial-axis", "points"}, kOnSample).empty());
  CHECK(asked({"interior-voronoi-disks", "points"}, kBesideSample).empty());
}

TEST_CASE("a line beside a sample is what a click on it is about, and so is all that is drawn over samples") {
  CHECK(asked({"interior-voronoi-disks", "curve", "medial-axis", "points"}, kBesideSample) ==
        Ids{"medial-axis", "curve"});
  CHECK(asked({"curve", "points", "interior-voronoi-disks"}, kOnSample) == Ids{"interior-voronoi-disks"});
}

TEST_CASE("a ball is drawn by its disk, circle or centre") {
  CHECK(asked({"b-inner-disks", "b-inner-circles", "b-inner-centers"}, kOnBall).empty());
  CHECK(asked({"b-inner-disks", "b-inner-circles", "b-v-points", "b-inner-centers"}, kOnBall) == Ids{"b-v-points"});
  CHECK(asked({"b-inner-circles", "b-ball-medial-axis"}, kOnBall) == Ids{"b-ball-medial-axis"});
  // Samples are shown by another layer.
  CHECK(asked({"points", "b-inner-circles"}, kOnBall) == Ids{"points"});
}
