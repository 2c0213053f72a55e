// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/legend_place.h"
#include "app/picture/picture_overlay.h"
#include "app/store/sample_shapes.h"
#include "core/base/rng.h"
#include "tests/model/pictures/letters_of_one_width.h"

using namespace mes;
using render::ColorMap;
using render::Image;
using render::ScalarRange;

namespace {

std::vector<std::string> labels_of(const ScalarRange& range) {
  std::vector<std::string> out;
  for (const LegendTick& tick : legend_ticks(range)) out.push_back(tick.label);
  return out;
}

Image white(int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255)};
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("ticks are the ends and round numbers between") {
  CHECK(labels_of({0.0, 10.0}) == Words{"0", "2", "4", "6", "8", "10"});
  CHECK(labels_of({1.53, 33.48}) == Words{"1.5", "10", "20", "30", "33.5"});
  CHECK(labels_of({-1.0, 1.0}) == Words{"-1", "-0.5", "0", "0.5", "1"});
  CHECK(labels_of({0.0, 1e-9}) == Words{"0", "2e-10", "4e-10", "6e-10", "8e-10", "1e-09"});
  CHECK(labels_of({1e6, 1e6 + 1.0}).front() == "1000000");
  CHECK(labels_of({1e6, 1e6 + 1.0}).back() == "1000001");
  CHECK(labels_of({7.25, 7.25}) == Words{"7.25"});
  CHECK(labels_of({}).empty());
  const double huge = std::numeric_limits<double>::max();
  CHECK(labels_of({-huge, huge}).size() == 2);
  CHECK(labels_of({0.0, huge}).size() >= 2);
  CHECK(labels_of({0.0, std::numeric_limits<double>::denorm_min()}).size() >= 2);
}

TEST_CASE("ticks of any range are few, in order, and say where they are") {
  Rng random(5);
  for (int round = 0; round < 5000; ++round) {
    const double size = std::pow(10.0, random.uniform(-200.0, 200.0));
    const double low = random.uniform(-1.0, 1.0) * size;
    const ScalarRange range{low, low + std::pow(10.0, random.uniform(-6.0, 3.0)) * size};
    const std::vector<LegendTick> ticks = legend_ticks(range);
    REQUIRE(ticks.size() >= 2);
    CHECK(ticks.size() <= 12);
    CHECK(ticks.front().at == 0.0);
    CHECK(ticks.back().at == 1.0);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      CHECK(ticks[i - 1].at < ticks[i].at);
      CHECK(ticks[i].label != ticks[i - 1].label);
    }
    for (const LegendTick& tick : ticks) {
      const double said = (std::strtod(tick.label.c_str(), nullptr) - range.low) / (range.high - range.low);
      CHECK(said == Approx(tick.at).margin(0.03));
    }
  }
}

TEST_CASE("entries that do not fit are counted, and everything lies inside") {
  const ColorMap grey = render::grey_map();
  const ColorMap categories = render::categorical_map();
  std::vector<LegendEntry> entries;
  CHECK(layout_legend(entries, test::half_size_a_byte, 1000.0, kWhiteCanvas).boxes.empty());
  for (int i = 0; i < 20; ++i)
    entries.push_back({"Layer",
                       "1: only in the one-step axis, 2: only in that of the union",
                       i % 2 == 0 ? &grey : &categories,
                       {0.0, i == 3   ? 1e300
                             : i == 4 ? -1.0
                                      : 30.0}});
  const PaperDrawing legend = layout_legend(entries, test::half_size_a_byte, 400.0, kWhiteCanvas);
  CHECK(legend.height <= 400.0);
  CHECK(legend.lines.back().text.starts_with("and "));
  for (const PaperDrawing::Box& box : legend.boxes) {
    CHECK(box.left >= 0.0);
    CHECK(box.top >= 0.0);
    CHECK(box.left + box.width <= legend.width + 1e-9);
    CHECK(box.top + box.height <= legend.height + 1e-9);
  }
  for (const PaperDrawing::Line& line : legend.lines) {
    CHECK(line.x >= 0.0);
    CHECK(line.x + test::half_size_a_byte(line.text, line.size, line.face) <= legend.width);
    CHECK(line.top + line.size <= legend.height);
  }
  // However little room there is, the first is shown.
  CHECK(layout_legend(entries, test::half_size_a_byte, 10.0, kWhiteCanvas).lines.size() > 3);
}

TEST_CASE("a legend on a picture shows the map's colours, and one of any size does no harm") {
  const auto fonts = PaperFonts::read(find_assets({}));
  REQUIRE(fonts);
  const ColorMap map{"ends", {{1, 0, 0}, {0, 0, 1}}, false};
  const std::vector<LegendEntry> entries{{"Axis", "radius", &map, {0.0, 1.0}}};
  Image image = white(400, 300);
  const auto draw = [&](Image& on, double scale) {
    const Box2 room{{0.0, 0.0}, (1.0 / scale) * Vec2{1.0 * on.width, 1.0 * on.height}};
    paint(on, *fonts, place_legend(entries, *fonts, scale, {.room = room}, kWhiteCanvas), scale);
  };
  draw(image, 1.0);
  std::size_t red = 0;
  std::size_t blue = 0;
  std::size_t ink = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    red += image.rgba[i] > 240 && image.rgba[i + 2] < 15 ? 1U : 0U;
    blue += image.rgba[i] < 15 && image.rgba[i + 2] > 240 ? 1U : 0U;
    ink += image.rgba[i] < 128 && image.rgba[i + 1] < 128 && image.rgba[i + 2] < 128 ? 1U : 0U;
  }
  CHECK(red > 20);
  CHECK(blue > 20);
  CHECK(ink > 15);
  Image again = white(400, 300);
  draw(again, 1.0);
  CHECK(again == image);
  for (const int size : {1, 7, 100}) {
    Image small = white(size, size);
    draw(small, 3.0);
  }
}

TEST_CASE("the frame of a legend is closed at every scale") {
  const auto fonts = PaperFonts::read(find_assets({}));
  REQUIRE(fonts);
  const ColorMap map{"ends", {{1, 0, 0}, {0, 0, 1}}, false};
  const std::vector<LegendEntry> entries{{"Axis", "radius", &map, {0.0, 1.0}}};
  const PaperColors colors = paper_colors(kWhiteCanvas);
  for (int hundredths = 60; hundredths <= 220; ++hundredths) {
    const double scale = 0.01 * hundredths;
    INFO("scale " << scale);
    const PaperDrawing legend = layout_legend(entries, measure_with(*fonts, scale), 1000.0, kWhiteCanvas);
    Image image = white(600, 300);
    paint(image, *fonts, legend, {10.0, 10.0}, scale);
    const int right = 10 + static_cast<int>(std::lround(scale * legend.width)) - 1;
    const int bottom = 10 + static_cast<int>(std::lround(scale * legend.height)) - 1;
    const auto is_frame = [&](int x, int y) {
      const std::size_t at = 4 * (static_cast<std::size_t>(y) * 600 + static_cast<std::size_t>(x));
      return Rgb{image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]} == colors.frame;
    };
    for (int x = 10; x <= right; ++x) REQUIRE((is_frame(x, 10) && is_frame(x, bottom)));
    for (int y = 10; y <= bottom; ++y) REQUIRE((is_frame(10, y) && is_frame(right, y)));
    CHECK_FALSE(is_frame(10 + right / 2, bottom + 1));
  }
}

TEST_CASE("the legend of a film stays in its corner, above the caption") {
  const auto read = [] { return PaperFonts::read(find_assets({})); };
  REQUIRE(read());
  const auto fonts = std::make_shared<const PaperFonts>(std::move(*read()));
  const ColorMap map{"ends", {{1, 0, 0}, {0, 0, 1}}, false};
  const std::vector<LegendEntry> entries{{"Axis", "radius", &map, {0.0, 1.0}}};
  const auto camera_of = [](int width, int height) {
    render::Camera camera;
    camera.set_viewport(width, height);
    return camera;
  };
  const auto painted = [&](const std::vector<LegendEntry>& legend, const std::string& caption) {
    Image image = white(800, 600);
    // What is in its place does not drive it away.
    for (int x = 700; x < 790; ++x) image.rgba[image.offset(x, 560)] = 0;
    const Image before = image;
    picture_overlay_of({legend, caption}, fonts, {camera_of(800, 600), 1.0, kWhiteCanvas}).paint(image);
    int top = 600;
    int bottom = 0;
    int left = 800;
    for (int y = 0; y < 600; ++y) {
      for (int x = 0; x < 800; ++x) {
        if (std::equal(&image.rgba[image.offset(x, y)], &image.rgba[image.offset(x, y)] + 4,
                       &before.rgba[before.offset(x, y)]))
          continue;
        top = std::min(top, y);
        bottom = std::max(bottom, y);
        left = std::min(left, x);
      }
    }
    return std::array{left, top, bottom};
  };
  const auto legend = painted(entries, "");
  const auto caption = painted({}, "What of it the union covers");
  const auto both = painted(entries, "What of it the union covers");
  CHECK(legend[0] > 500);
  CHECK(legend[1] > 400);
  CHECK(caption[1] > 540);
  CHECK(caption[0] > 100);
  // Moved up by the band of the caption: its letters are in the middle of it.
  CHECK(both[1] < legend[1] - 2 * (600 - caption[2]));
  CHECK(both[2] == caption[2]);
  CHECK(painted({}, "") == std::array{800, 600, 0});
  Image image = white(80, 60);
  picture_overlay_of({entries, "caption"}, nullptr, {camera_of(80, 60), 1.0, kWhiteCanvas}).paint(image);
  CHECK(image == white(80, 60));
}

TEST_CASE("a key has a sample and a name for each layer, and fits what it says") {
  const MeasureText measure = [](const std::string& text, double, Face) {
    return 6.0 * static_cast<double>(text.size());
  };
  const auto entry = [](const std::string& title, PrimitiveKind kind, LayerStyle style) {
    return LegendEntry{title, {}, nullptr, {}, {kind, style}};
  };
  LayerStyle red;
  red.color = {0xff, 0, 0};
  red.opacity = 0.5;
  LayerStyle dashed = red;
  dashed.dashed = true;
  dashed.line_width_px = 3.0;
  const std::vector<LegendEntry> entries{
      entry("Dots", PrimitiveKind::point, red), entry("Circles", PrimitiveKind::circle, red),
      entry("Edges", PrimitiveKind::segment, dashed), entry("Faces", PrimitiveKind::triangle, red)};
  const PaperDrawing key = layout_legend(entries, measure, 1000.0, Rgb{0xff, 0xff, 0xff});
  REQUIRE(key.lines.size() == 4);
  // Opacity is that on paper, so that no format has to blend.
  const Rgb pink{0xff, 0x80, 0x80};
  REQUIRE(key.dots.size() == 3);
  CHECK(key.dots[0].color == pink);
  CHECK(key.dots[1].color == pink);
  // A circle is a disk with a hole.
  CHECK(key.dots[2].color == Rgb{0xff, 0xff, 0xff});
  CHECK(key.dots[2].radius < key.dots[1].radius);
  std::vector<PaperDrawing::Box> samples;
  for (const PaperDrawing::Box& box : key.boxes)
    if (box.color == pink) samples.push_back(box);
  REQUIRE(samples.size() == 4);
  for (int i = 0; i < 3; ++i) CHECK(samples[static_cast<std::size_t>(i)].height == 3.0);
  CHECK(samples[3].width == samples[3].height);
  for (std::size_t i = 0; i < 4; ++i) {
    const PaperDrawing::Line& line = key.lines[i];
    CHECK(line.text == entries[i].title);
    CHECK(line.x + measure(line.text, line.size, Face::plain) < key.width);
    CHECK(line.top + line.size < key.height);
    if (i > 0) CHECK(line.top > key.lines[i - 1].top + line.size);
  }
  // What does not fit is counted.
  const PaperDrawing low = layout_legend(entries, measure, 60.0, Rgb{0xff, 0xff, 0xff});
  CHECK(low.lines.back().text == "and 3 more");
}

TEST_CASE("text is as wide as measured, whatever its bytes are") {
  const auto fonts = PaperFonts::read(find_assets({}));
  REQUIRE(fonts);
  const double width = render::text_width(fonts->plain, 20.0, "medial axis");
  CHECK(width > 60.0);
  CHECK(width < 200.0);
  CHECK(render::text_width(fonts->plain, 40.0, "medial axis") == Approx(2.0 * width).epsilon(1e-6));
  Image image = white(300, 40);
  draw_text(image, fonts->plain, 20.0, 10.0, 30.0, palette::black, "medial axis");
  int last = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.rgba[image.offset(x, y)] < 128) last = std::max(last, x);
  CHECK(last == Approx(10.0 + width).margin(3.0));

  // On nothing, text keeps its colour.
  Image clear{60, 40, std::vector<std::uint8_t>(std::size_t{4} * 60 * 40, 0)};
  draw_text(clear, fonts->bold, 20.0, 5.0, 30.0, palette::vermilion, "ab");
  for (std::size_t i = 0; i < clear.rgba.size(); i += 4)
    if (clear.rgba[i + 3] > 0) CHECK(Rgb{clear.rgba[i], clear.rgba[i + 1], clear.rgba[i + 2]} == palette::vermilion);

  Rng random(2);
  for (int round = 0; round < 200; ++round) {
    std::string bytes;
    for (std::uint64_t i = random.below(20); i > 0; --i) bytes += static_cast<char>(random.below(256));
    draw_text(image, fonts->plain, random.uniform(1.0, 60.0), random.uniform(-100.0, 400.0),
              random.uniform(-50.0, 90.0), palette::blue, bytes);
    CHECK(std::isfinite(render::text_width(fonts->plain, 12.0, bytes)));
  }
  CHECK_FALSE(render::Font::read("/nowhere.otf"));
}
