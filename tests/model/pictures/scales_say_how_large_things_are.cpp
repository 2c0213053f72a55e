// SPDX-License-Identifier: GPL-3.0-or-later
// Scale bars and axes: their numbers are where they say, in pictures of any scale and place.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/picture/paper/scale_drawing.h"
#include "app/picture/picture_overlay.h"
#include "app/store/sample_shapes.h"
#include "core/base/rng.h"
#include "tests/io/document_of.h"
#include "tests/model/pictures/letters_of_one_width.h"

using namespace mes;
using mes::test::six_px_a_byte;

namespace {

PaperDrawing laid_out(const ScaleMarks& marks, const SeenPlane& plane) {
  return layout_scale_marks(marks, plane, six_px_a_byte, Rgb{255, 255, 255});
}

// The bar itself: the longest of its boxes that is as thin as a line.
double length_of_bar(const PaperDrawing& drawing) {
  double out = 0.0;
  for (const PaperDrawing::Box& box : drawing.boxes)
    if (box.height <= 2.0) out = std::max(out, box.width);
  return out;
}

bool is_number_of_a_row(const PaperDrawing::Line& line, const SeenPlane& plane) {
  return line.top > plane.height - plane.covered - kAxisRoom;
}

}  // namespace

TEST_CASE("a scale bar is as long as it says, round, and at most a quarter of the picture") {
  Rng rng(1);
  for (int i = 0; i < 500; ++i) {
    const SeenPlane plane{.center = {rng.uniform(-1e6, 1e6), rng.uniform(-1e6, 1e6)},
                          .units_per_pixel = std::pow(10.0, rng.uniform(-12.0, 12.0)),
                          .width = rng.uniform(100.0, 4000.0),
                          .height = 600.0};
    const PaperDrawing drawing = laid_out({.bar = true}, plane);
    REQUIRE(drawing.lines.size() == 1);
    const double said = std::atof(drawing.lines.front().text.c_str());
    CAPTURE(plane.units_per_pixel, plane.width, drawing.lines.front().text);
    const double length = length_of_bar(drawing);
    CHECK(length * plane.units_per_pixel == Approx(said).epsilon(1e-9));
    CHECK(length <= 0.2500001 * plane.width);
    CHECK(length >= 0.0999 * plane.width);
    const double mantissa = said / std::pow(10.0, std::floor(std::log10(said) + 1e-9));
    CHECK((std::abs(mantissa - 1.0) < 1e-6 || std::abs(mantissa - 2.0) < 1e-6 || std::abs(mantissa - 5.0) < 1e-6));
  }
}

TEST_CASE("the bar of a map has the unit of its plane") {
  SeenPlane plane{.units_per_pixel = 2.0, .width = 800.0, .height = 600.0};
  CHECK(laid_out({.bar = true}, plane).lines.at(0).text == "200");
  SampleData data{.positions = {{0, 0}}};
  const auto unit_on = [&](const std::optional<MapPlane>& map) {
    data.map = map;
    plane.unit = unit_of_lengths(test::document_of(data));
    return laid_out({.bar = true}, plane).lines.at(0).text;
  };
  CHECK(unit_on(std::nullopt) == "200");
  CHECK(unit_on(MapPlane{MapProjection::azimuthal, 9, 52}) == "200 m");
  CHECK(unit_on(MapPlane{MapProjection::equirectangular, 9, 52}) == "200 km");
  CHECK(unit_on(MapPlane{.system = "EPSG:2263", .unit = "US survey foot"}) == "200 US survey foot");
}

TEST_CASE("numbers along the axes are where they say, apart from each other, and within the picture") {
  Rng rng(2);
  for (int i = 0; i < 500; ++i) {
    const SeenPlane plane{.center = {rng.uniform(-1e3, 1e3), rng.uniform(-1e3, 1e3)},
                          .units_per_pixel = std::pow(10.0, rng.uniform(-6.0, 6.0)),
                          .width = rng.uniform(300.0, 4000.0),
                          .height = rng.uniform(200.0, 3000.0),
                          .covered = rng.below(2) == 0 ? 0.0 : 40.0};
    const PaperDrawing drawing = laid_out({.axes = true}, plane);
    double end_of_last = 0.0;
    int of_rows = 0;
    int of_columns = 0;
    for (const PaperDrawing::Line& line : drawing.lines) {
      const double said = std::atof(line.text.c_str());
      const double width = six_px_a_byte(line.text, 0.0, Face::plain);
      CAPTURE(plane.units_per_pixel, plane.center.x, plane.center.y, line.text);
      if (is_number_of_a_row(line, plane)) {
        const double at = (said - plane.center.x) / plane.units_per_pixel + 0.5 * plane.width;
        CHECK(std::abs(line.x + 0.5 * width - at) < 0.01);
        CHECK(line.x > end_of_last);
        CHECK(line.x + width < plane.width);
        end_of_last = line.x + width;
        ++of_rows;
      } else {
        // The middle of a line of text is half a line below its top, of 17 less one pixel of padding.
        const double at = 0.5 * plane.height - (said - plane.center.y) / plane.units_per_pixel;
        CHECK(std::abs(line.top + 7.5 - at) < 0.01);
        CHECK(line.top >= 0.0);
        ++of_columns;
      }
    }
    CHECK(of_rows >= 1);
    CHECK(of_columns >= (plane.height > 400.0 ? 1 : 0));
  }
}

TEST_CASE("the grid has a line at each number of the axes") {
  Rng rng(5);
  for (int i = 0; i < 200; ++i) {
    const SeenPlane plane{.center = {rng.uniform(-1e3, 1e3), rng.uniform(-1e3, 1e3)},
                          .units_per_pixel = std::pow(10.0, rng.uniform(-6.0, 6.0)),
                          .width = rng.uniform(300.0, 4000.0),
                          .height = rng.uniform(200.0, 3000.0),
                          .covered = rng.below(2) == 0 ? 0.0 : 40.0};
    const PaperDrawing grid = laid_out({.grid = true}, plane);
    CHECK(grid.lines.empty());
    const auto has_line = [&](bool is_column, double at) {
      return std::ranges::any_of(grid.boxes, [&](const PaperDrawing::Box& box) {
        return is_column ? box.width == 1.0 && box.height > 100.0 && std::abs(box.left + 0.5 - at) < 0.01
                         : box.height == 1.0 && box.width == plane.width && std::abs(box.top + 0.5 - at) < 0.01;
      });
    };
    for (const PaperDrawing::Line& line : laid_out({.axes = true}, plane).lines) {
      const double said = std::atof(line.text.c_str());
      CAPTURE(plane.units_per_pixel, plane.center.x, plane.center.y, line.text);
      if (is_number_of_a_row(line, plane))
        CHECK(has_line(true, (said - plane.center.x) / plane.units_per_pixel + 0.5 * plane.width));
      else
        CHECK(has_line(false, 0.5 * plane.height - (said - plane.center.y) / plane.units_per_pixel));
    }
  }
}

TEST_CASE("where doubles do not tell neighbouring numbers apart there are none") {
  const SeenPlane deep{.center = {1e9, 1.0}, .units_per_pixel = 1e-10, .width = 800.0, .height = 600.0};
  const PaperDrawing drawing = laid_out({.axes = true}, deep);
  // Along the left edge they do.
  CHECK(std::ranges::none_of(drawing.lines, [&](const auto& line) { return is_number_of_a_row(line, deep); }));
  CHECK(std::ranges::any_of(drawing.lines, [&](const auto& line) { return !is_number_of_a_row(line, deep); }));
}

TEST_CASE("a picture of no size, and scales at the ends of the doubles, break nothing") {
  for (const double units : {1e-300, 5e-324, 1e300, 1.7e308, 0.0})
    for (const double size : {0.0, 1.0, 800.0}) {
      const SeenPlane plane{.center = {0.0, 0.0}, .units_per_pixel = units, .width = size, .height = size};
      const PaperDrawing drawing = laid_out({.bar = true, .axes = true, .grid = true}, plane);
      CAPTURE(units, size);
      CHECK(std::ranges::all_of(drawing.boxes, [](const auto& box) {
        return std::isfinite(box.left) && std::isfinite(box.top) && std::isfinite(box.width) &&
               std::isfinite(box.height);
      }));
      CHECK(drawing.lines.size() < 100);
    }
  CHECK(laid_out({}, {.center = {}, .units_per_pixel = 1.0, .width = 800.0, .height = 600.0}).boxes.empty());
}

TEST_CASE("above a caption and beside a legend each has its place") {
  auto read = PaperFonts::read(find_assets({}));
  REQUIRE(read);
  const auto fonts = std::make_shared<const PaperFonts>(std::move(*read));
  render::Camera camera;
  camera.set_viewport(800, 600);
  camera.look_at({0.0, 0.0}, 0.01);
  const render::ColorMap map{"ends", {{1, 0, 0}, {0, 0, 1}}, false};
  const std::vector<LegendEntry> entries{{"Axis", "radius", &map, {0.0, 1.0}}};
  // Rows from the top that are not white any more.
  const auto inked = [&](const OverlayContent& content, int left, int right) {
    render::Image image{800, 600, std::vector<std::uint8_t>(800UL * 600UL * 4UL, 255)};
    picture_overlay_of(content, fonts, {camera, 1.0, Rgb{255, 255, 255}}).paint(image);
    int lowest = -1;
    for (int y = 0; y < 600; ++y)
      for (int x = left; x < right; ++x)
        if (image.rgba[image.offset(x, y)] != 255) lowest = y;
    return lowest;
  };
  // The bar is in the lower left corner, on top of the axis where there is one, and of the caption.
  const int bar = inked({.legend = {}, .caption = "", .marks = {.bar = true}}, 100, 101);
  CHECK(bar > 580);
  CHECK(inked({.legend = {}, .caption = "", .marks = {.bar = true, .axes = true}}, 100, 101) == 599);
  // The legend gives way to the axis by its height.
  const int legend = inked({.legend = entries, .caption = "", .marks = {.bar = true}}, 700, 701);
  render::Image image{800, 600, std::vector<std::uint8_t>(800UL * 600UL * 4UL, 255)};
  picture_overlay_of({.legend = entries, .caption = "", .marks = {.axes = true}}, fonts,
                     {camera, 1.0, Rgb{255, 255, 255}})
      .paint(image);
  const auto frame = image.rgba[image.offset(700, legend - static_cast<int>(kAxisRoom))];
  CHECK(frame == 0xd0);
  // The caption covers the lower end of the plane and moves nothing that stays in sight: the tick of 0 is in the middle.
  for (const std::string& caption : {std::string(), std::string("A caption")}) {
    render::Image with{800, 600, std::vector<std::uint8_t>(800UL * 600UL * 4UL, 255)};
    picture_overlay_of({.legend = {}, .caption = caption, .marks = {.axes = true}}, fonts,
                       {camera, 1.0, Rgb{255, 255, 255}})
        .paint(with);
    const auto is_inked = [&](int y) { return with.rgba[with.offset(3, y)] != 255; };
    CHECK((is_inked(299) || is_inked(300)));
    CHECK_FALSE(is_inked(305));
  }
}
