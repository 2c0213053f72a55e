// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/picture/ink_map.h"
#include "app/picture/paper/canvas_look.h"
#include "app/picture/picture_overlay.h"
#include "app/store/sample_shapes.h"

using namespace mes;

namespace {

constexpr int kWidth = 101;
constexpr int kHeight = 67;

/// A picture of one colour; the first row of the pixels is the lowest.
struct Paper {
  explicit Paper(Rgb color) {
    raw.width = kWidth;
    raw.height = kHeight;
    raw.rgba.resize(std::size_t{4} * kWidth * kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) dot(x, y, color);
    camera.set_viewport(kWidth, kHeight);
    camera.look_at({3.0, -2.0}, 0.25);
  }
  void dot(int x, int y, Rgb color) {
    std::uint8_t* const pixel =
        raw.rgba.data() + 4 * (static_cast<std::size_t>(kHeight - 1 - y) * kWidth + static_cast<std::size_t>(x));
    pixel[0] = color.r;
    pixel[1] = color.g;
    pixel[2] = color.b;
    pixel[3] = 255;
  }
  render::RawImage raw;
  render::Camera camera;
};

}  // namespace

TEST_CASE("each pixel of another colour is found by boxes on it, and by none that is a cell away") {
  for (const int x : {0, 3, 50, 99, 100})
    for (const int y : {0, 5, 33, 66}) {
      Paper paper({255, 255, 255});
      paper.dot(x, y, {255, 235, 205});
      const InkMap ink(paper.raw, paper.camera, kWhiteCanvas);
      INFO(x << " " << y);
      const Vec2 at{x + 0.0, y + 0.0};
      CHECK(ink.parts_below({at, at + Vec2{1, 1}}, paper.camera) > 0);
      CHECK(ink.parts_below({{0, 0}, {kWidth, kHeight}}, paper.camera) > 0);
      for (const Vec2 away : {Vec2{8, 0}, Vec2{-8, 0}, Vec2{0, 8}, Vec2{0, -8}})
        CHECK(ink.parts_below({at + away, at + away + Vec2{1, 1}}, paper.camera) == 0);
    }
}

TEST_CASE("paper hides nothing, and neither does what is beside the picture") {
  const Paper paper({30, 32, 36});
  const Box2 all{{-500, -500}, {500, 500}};
  CHECK(InkMap(paper.raw, paper.camera, Rgb{30, 32, 36}).parts_below(all, paper.camera) == 0);
  CHECK(InkMap().parts_below(all, paper.camera) == 0);
  // The whole picture is drawn on, and the box is beside it.
  const InkMap full(paper.raw, paper.camera, kWhiteCanvas);
  CHECK(full.parts_below({{200, 0}, {300, 50}}, paper.camera) == 0);
  CHECK(full.parts_below({{0, 0}, {kWidth, kHeight}}, paper.camera) >= 56);
}

TEST_CASE("on a transparent canvas black counts, and what has no alpha does not") {
  Paper paper({0, 0, 0});
  const Box2 all{{0, 0}, {kWidth, kHeight}};
  CHECK(InkMap(paper.raw, paper.camera, std::nullopt).parts_below(all, paper.camera) >= 56);
  std::ranges::fill(paper.raw.rgba, std::uint8_t{0});
  CHECK(InkMap(paper.raw, paper.camera, std::nullopt).parts_below(all, paper.camera) == 0);
}

TEST_CASE("legend and scale bar of a picture stand in the corners that its pixels leave free") {
  auto read = PaperFonts::read(find_assets({}));
  REQUIRE(read);
  const auto fonts = std::make_shared<const PaperFonts>(std::move(*read));
  constexpr std::size_t kSide = 600;
  render::Camera camera;
  camera.set_viewport(kSide, kSide);
  camera.look_at({0.0, 0.0}, 0.01);
  const auto quarter_of = [](std::size_t x, std::size_t y) {
    return (y < kSide / 2 ? 0U : 2U) + (x < kSide / 2 ? 0U : 1U);
  };
  const OverlayContent content{
      .legend = {{"Crust", {}, nullptr, {}, {PrimitiveKind::segment, {}}}}, .caption = "", .marks = {.bar = true}};
  for (unsigned free = 0; free < 16; ++free) {
    if (std::popcount(free) != 2) continue;
    for (const std::optional<Rgb>& canvas : {std::optional(kWhiteCanvas), std::optional<Rgb>()}) {
      INFO("free quarters " << free << (canvas ? "" : ", transparent"));
      const std::uint8_t blank = canvas ? 255 : 0;
      render::RawImage raw{kSide, kSide, std::vector<std::uint8_t>(4 * kSide * kSide, blank)};
      for (std::size_t y = 0; y < kSide; ++y)
        for (std::size_t x = 0; x < kSide; ++x) {
          std::uint8_t* const pixel = &raw.rgba[4 * ((kSide - 1 - y) * kSide + x)];
          if ((free >> quarter_of(x, y) & 1U) == 0) pixel[0] = pixel[1] = pixel[2] = 0, pixel[3] = 255;
        }
      const InkMap ink(raw, camera, canvas);
      render::Image sheet{kSide, kSide, std::vector<std::uint8_t>(4 * kSide * kSide, blank)};
      picture_overlay_of(content, fonts, {camera, 1.0, canvas}, &ink).paint(sheet);
      unsigned used = 0;
      for (std::size_t y = 0; y < kSide; ++y)
        for (std::size_t x = 0; x < kSide; ++x) {
          const std::uint8_t* const pixel = &sheet.rgba[4 * (y * kSide + x)];
          if (!std::ranges::all_of(std::span(pixel, 4), [&](std::uint8_t c) { return c == blank; }))
            used |= 1U << quarter_of(x, y);
        }
      CHECK((used & ~free) == 0);
      CHECK(used != 0);
    }
  }
}

TEST_CASE("a view that has moved since moves what is drawn with it") {
  Paper paper({255, 255, 255});
  paper.dot(20, 30, {0, 0, 0});
  const InkMap ink(paper.raw, paper.camera, kWhiteCanvas);
  render::Camera moved = paper.camera;
  moved.pan({40, 10});
  CHECK(ink.parts_below({{60, 40}, {61, 41}}, moved) > 0);
  CHECK(ink.parts_below({{20, 30}, {21, 31}}, moved) == 0);
}
