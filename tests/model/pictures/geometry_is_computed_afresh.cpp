// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <stop_token>

#include "app/export/geometry_export.h"
#include "core/builtins/builtins.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

const SampleData kHouse{.positions = {{0, 0}, {4, 0}, {4, 3}, {2, 5}, {0, 3}}};

Expected<LayerText> text_of_house(std::string_view format, std::vector<VariantLayer> layers,
                                  std::stop_token stop = {}) {
  return compute_layer_text(builtins(), kHouse, *find_layer_text_format(format),
                            {.layers = std::move(layers), .settings = {}, .on_patch = {}, .stop = std::move(stop)});
}

}  // namespace

TEST_CASE("the text of a layer is of the samples, with what else its format needs") {
  const auto points = text_of_house("csv", {find_layer("points")});
  REQUIRE(points);
  CHECK(std::ranges::count(points->text, '\n') == 6);
  CHECK(points->text.find("2,5") != std::string::npos);
  // The normals of the curve are a layer of their own.
  const auto normals = text_of_house("npoff", {find_layer("curve")});
  REQUIRE(normals);
  CHECK(std::ranges::count(normals->text, '\n') == 5);
  CHECK(normals->text.find("2 5  0 1") != std::string::npos);
}

TEST_CASE("what a format cannot hold is refused before anything is computed, and what it leaves out is said") {
  const auto refused = text_of_house("wpoff", {find_layer("points")});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == ErrorCode::usage);
  const LayerTextFormat& wkt = *find_layer_text_format("wkt");
  const auto rays = text_of_house("wkt", {find_layer("voronoi")});
  REQUIRE(rays);
  CHECK(rays->left_out == 5);
  CHECK(remark_about(*rays, wkt) == "5 rays and lines are left out: wkt holds finite shapes only");
  const auto all = text_of_house("wkt", {find_layer("points")});
  REQUIRE(all);
  CHECK(remark_about(*all, wkt).empty());
}

TEST_CASE("a computation that is asked to stop ends with that") {
  std::stop_source source;
  source.request_stop();
  const auto stopped = text_of_house("csv", {find_layer("delaunay")}, source.get_token());
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::cancelled);
}
