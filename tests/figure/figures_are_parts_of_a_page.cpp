// SPDX-License-Identifier: GPL-3.0-or-later
// Figures placed side by side on one page: where they are, and that none is seen beyond its own edge.
#include <catch2/catch.hpp>
#include <string>

#include "render/figure/raster.h"
#include "render/figure/writers.h"

using namespace mes;
using namespace mes::figure;

namespace {

/// A red disk that is three quarters outside of the page, a text, and a box of a legend.
Figure part() {
  Figure out{.width = 40.0, .height = 30.0};
  out.decimals = 2;
  FigureLayer& layer = out.layers.emplace_back();
  layer.id = "disks";
  layer.title = "Disks";
  Run& run = layer.groups.emplace_back().runs.emplace_back();
  run.color = {255, 0, 0};
  run.shapes.push_back({.kind = ShapeKind::disk, .p = {Vec2{40.0, 30.0}}, .radius = 20.0});
  layer.texts.push_back({.start = {5.0, 10.0}, .size = 8.0, .width = 10.0, .text = "a"});
  out.legend.boxes.push_back({.corner = {1.0, 2.0}, .width = 3.0, .height = 4.0, .color = {0, 0, 255}});
  return out;
}

Figure page() {
  Figure out{.width = 100.0, .height = 80.0, .background = Rgb{255, 255, 255}};
  place(out, part(), {0.0, 0.0}, "left-", "(a) ");
  place(out, part(), {50.003, 40.0}, "right-", "(b) ");
  return out;
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t out = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++out;
  return out;
}

}  // namespace

TEST_CASE("a part has its layers, its texts and its legend where it is placed") {
  const Figure out = page();
  REQUIRE(out.layers.size() == 2);
  CHECK(out.layers[0].id == "left-disks");
  CHECK(out.layers[1].id == "right-disks");
  CHECK(out.layers[1].title == "(b) Disks");
  // The corner is rounded to the page's coordinates: 3 decimals.
  CHECK(out.layers[1].groups[0].runs[0].shapes[0].p[0].x == Approx(90.003).margin(1e-12));
  CHECK(out.layers[1].groups[0].runs[0].shapes[0].p[0].y == 70.0);
  CHECK(out.layers[1].texts[0].start.y == 50.0);
  REQUIRE(out.layers[1].clip);
  CHECK(out.layers[1].clip->corner.y == 40.0);
  CHECK(out.layers[1].clip->width == 40.0);
  REQUIRE(out.legend.boxes.size() == 2);
  CHECK(out.legend.boxes[1].corner.y == 42.0);
}

TEST_CASE("every format cuts parts at their own edges") {
  const Figure out = page();
  const auto text = [&](const char* extension) {
    auto bytes = format_for(extension)->write(out);
    REQUIRE(bytes);
    return *bytes;
  };
  const std::string svg = text(".svg");
  CHECK(occurrences(svg, "<clipPath id=\"part-") == 2);
  CHECK(occurrences(svg, "clip-path=\"url(#part-right-disks)\"") == 1);
  CHECK(svg.find("<clipPath id=\"part-right-disks\"><rect x=\"50.003\" y=\"40\" width=\"40\" height=\"30\"/>") !=
        std::string::npos);
  CHECK(occurrences(text(".tex"), "\\clip (50.003,40) rectangle (90.003,10);") == 1);
  CHECK(occurrences(text(".ipe"), "clip=\"50.003 40 m 90.003 40 l 90.003 10 l 50.003 10 l h \"") == 1);
}

TEST_CASE("a part is not seen outside of it, as picture and as picture of a layer") {
  Figure out = page();
  const auto check = [&] {
    const auto picture = picture_of(out, 1.0);
    REQUIRE(picture);
    const auto red_at = [&](int x, int y) {
      const std::uint8_t* const pixel = picture->rgba.data() + picture->offset(x, y);
      return pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 0;
    };
    CHECK(red_at(36, 26));
    CHECK_FALSE(red_at(44, 26));
    CHECK_FALSE(red_at(36, 34));
    CHECK(red_at(86, 66));
    CHECK_FALSE(red_at(94, 66));
    CHECK_FALSE(red_at(86, 74));
  };
  check();
  REQUIRE(rasterize_layers(out, std::vector<std::string>{"left-disks", "right-disks"}, 72.0));
  check();
}
