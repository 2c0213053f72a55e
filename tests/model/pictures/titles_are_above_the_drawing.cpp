// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/export/figure.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/picture/paper/title_drawing.h"
#include "core/document/commands.h"
#include "tests/model/pictures/letters_of_one_width.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::half_size_a_byte;

namespace {

PictureTitle title(std::string_view words, double width = 800.0, double height = 600.0) {
  return layout_title(words, width, height, half_size_a_byte, Rgb{255, 255, 255});
}

struct Extent {
  double left = 1e9;
  double right = -1e9;
};
Extent extent_of(const PaperDrawing& drawing) {
  Extent out;
  for (const PaperDrawing::Line& line : drawing.lines) {
    out.left = std::min(out.left, line.x);
    out.right = std::max(out.right, line.x + half_size_a_byte(line.text, line.size, line.face));
  }
  return out;
}

Document square_of_samples() {
  Document document;
  const auto all = replace_all(document, {.positions = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  REQUIRE(all.has_value());
  document.apply(*all);
  return document;
}

struct Drawn {
  figure::Figure figure;
  std::vector<std::string> remarks;
};
Drawn figure_drawn(FigureRequest request, PlacedAnnotations annotations = {}) {
  const Document document = square_of_samples();
  const LayerMirror mirror;
  const Box2 bounds = document.bounding_box();
  request.shown.descriptors = layer_descriptors();
  request.shown.layers = {find_layer("indices")};
  for (const LayerDescriptor& layer : layer_descriptors()) request.shown.styles.push_back(layer.style);
  auto out = draw_figure(request, {.mirror = mirror,
                                   .bounds = bounds,
                                   .maps = {},
                                   .traced = nullptr,
                                   .annotations = std::move(annotations),
                                   .document = document});
  REQUIRE(out);
  return {std::move(out->figure), std::move(out->remarks)};
}

/// Where the first and the last sample's numbers begin.
std::pair<Vec2, Vec2> numbers(const figure::Figure& figure) {
  REQUIRE_FALSE(figure.layers.empty());
  REQUIRE(figure.layers[0].texts.size() == 4);
  return {figure.layers[0].texts[0].start, figure.layers[0].texts[2].start};
}

}  // namespace

TEST_CASE("a title is centred at the upper edge, line by line, in a band that holds it") {
  const PictureTitle one = title("Crust of $x_i^2$");
  REQUIRE_FALSE(one.drawing.is_empty());
  const Extent across = extent_of(one.drawing);
  CHECK(0.5 * (across.left + across.right) == Approx(400.0).margin(1.0));
  CHECK(one.drawing.height > 20.0);
  CHECK(one.drawing.height < 60.0);
  for (const PaperDrawing::Line& line : one.drawing.lines) {
    CHECK(line.top >= 0.0);
    CHECK(line.top + line.size <= one.drawing.height);
  }
  // TeX typesets it as one piece.
  CHECK(one.drawing.lines.front().latex == "Crust of $x_{i}^{2}$");
  CHECK(std::ranges::all_of(one.drawing.lines.begin() + 1, one.drawing.lines.end(),
                            [](const PaperDrawing::Line& line) { return line.continues; }));
  const PictureTitle two = title("a\\\\bcdef");
  REQUIRE(two.drawing.lines.size() == 2);
  CHECK(two.drawing.lines[1].top > two.drawing.lines[0].top + two.drawing.lines[0].size);
  CHECK(two.drawing.lines[0].x > two.drawing.lines[1].x);
  CHECK(two.drawing.height > one.drawing.height);
}

TEST_CASE("words that are too wide or too many get smaller letters, and nothing has no band") {
  for (const char* nothing : {"", " ", "\n"}) {
    CHECK(title(nothing).drawing.lines.empty());
    CHECK(title(nothing).drawing.height == 0.0);
  }
  const PictureTitle wide = title(std::string(500, 'm'));
  const Extent across = extent_of(wide.drawing);
  CHECK(across.left > 0.0);
  CHECK(across.right < 800.0);
  std::string many = "0";
  for (int i = 1; i < 100; ++i) many += "\\\\" + std::to_string(i);
  const PictureTitle high = title(many);
  CHECK(high.drawing.height <= 200.001);
  CHECK(high.drawing.lines.size() == 100);
  CHECK(title("$\\unknowncommand$").complaint.find("unknowncommand") != std::string::npos);
}

TEST_CASE("the camera and the page below a band show what they showed, lower") {
  Box2 box;
  box.add(Vec2{0, 0});
  box.add(Vec2{4, 3});
  const render::Camera camera = camera_within({.above = 60}, 400, 360, box, 0.0);
  CHECK(camera.to_screen({0, 3}).y == Approx(60.0));
  CHECK(camera.to_screen({4, 0}).x == Approx(400.0));
  CHECK(camera.to_screen({4, 0}).y == Approx(360.0));
  CHECK(camera_within({.above = 500}, 400, 360, box, 0.0).units_per_pixel() > 0.0);
}

TEST_CASE("what is fitted is kept clear of title and axes at any scale") {
  Box2 box;
  box.add(Vec2{0, 0});
  box.add(Vec2{4, 3});
  for (const double scale : {0.5, 1.0, 3.0}) {
    EdgeRoom edges = room_of_axes(scale);
    CHECK(edges.below >= scale * kAxisRoom);
    CHECK(edges.left >= scale * kAxisRoomBeside);
    edges.above = 60;
    const render::Camera camera = camera_within(edges, 400 + edges.left, 360 + edges.below, box, 0.0);
    CHECK(camera.to_screen({0, 3}).x == Approx(edges.left));
    CHECK(camera.to_screen({0, 3}).y == Approx(60.0));
    CHECK(camera.to_screen({4, 0}).x == Approx(400.0 + edges.left));
    CHECK(camera.to_screen({4, 0}).y == Approx(360.0));
    CHECK(camera_within(edges, 20, 20, box, 0.0).units_per_pixel() > 0.0);
  }
}

TEST_CASE("samples of a figure lie above and beside its axes, and what was asked to be seen is not moved for them") {
  const auto with_axes = [](bool has_axes, const ShownPart& part, std::optional<PageSize> page) {
    return figure_drawn({.shown = {}, .part = part, .page = page, .marks = {.axes = has_axes}}).figure;
  };
  for (const auto& page : {std::optional(PageSize{240.0, std::nullopt}), std::optional(PageSize{240.0, 100.0}),
                           std::optional<PageSize>()}) {
    const figure::Figure figure = with_axes(true, Everything{}, page);
    const auto [first, last] = numbers(figure);
    CHECK(first.x >= figure::kPointsPerPixel * kAxisRoomBeside);
    CHECK(first.y <= figure.height - figure::kPointsPerPixel * kAxisRoom);
    CHECK(last.x <= figure.width);
    CHECK(last.y >= 0.0);
    const Box2 box{{0, 0}, {4, 3}};
    CHECK(numbers(with_axes(true, box, page)) == numbers(with_axes(false, box, page)));
  }
}

TEST_CASE("a figure with a title has it in its legend, as text, above the drawing") {
  const Drawn bare = figure_drawn({.shown = {}, .part = Everything{}, .page = PageSize{240.0, std::nullopt}});
  const Drawn titled =
      figure_drawn({.shown = {}, .part = Everything{}, .page = PageSize{240.0, std::nullopt}, .title = "Four"});
  REQUIRE(titled.figure.legend.texts.size() == 1);
  CHECK(titled.figure.legend.texts[0].text == "Four");
  CHECK(titled.remarks.empty());
  // The page grows where its height follows from the drawing, which moves down.
  const double band = titled.figure.height - bare.figure.height;
  CHECK(band > 15.0);
  CHECK(titled.figure.width == bare.figure.width);
  const auto [from, to] = numbers(bare.figure);
  const auto [low, high] = numbers(titled.figure);
  CHECK(low.y == Approx(from.y + band).margin(0.02));
  CHECK(low.x == Approx(from.x).margin(0.01));
  CHECK(high.y == Approx(to.y + band).margin(0.02));
  CHECK(titled.figure.legend.texts[0].start.y < band);

  // A page of a given size stays, and the drawing gets what is left.
  for (const std::optional<PageSize>& page :
       {std::optional<PageSize>(PageSize{240.0, 180.0}), std::optional<PageSize>()}) {
    const Drawn fixed = figure_drawn({.shown = {}, .part = Everything{}, .page = page, .title = "Four"});
    CHECK(fixed.figure.width == Approx(page ? 240.0 : 1200.0));
    CHECK(fixed.figure.height == Approx(page ? 180.0 : 900.0).margin(1e-6));
    const double upper = numbers(fixed.figure).second.y - fixed.figure.layers[0].texts[0].size;
    const double foot = fixed.figure.legend.texts[0].start.y;
    CHECK(upper > foot);
  }
}

TEST_CASE("a page that is cut to the drawing has its title beside that") {
  const Drawn titled = figure_drawn({.shown = {}, .part = Everything{}, .is_tight = true, .title = "Four"});
  const auto [low, high] = numbers(titled.figure);
  REQUIRE(titled.figure.legend.texts.size() == 1);
  const figure::Text& words = titled.figure.legend.texts[0];
  CHECK(words.start.y < high.y - titled.figure.layers[0].texts[2].size * 0.5);
  CHECK(words.start.x > 0.0);
  CHECK(words.start.x + words.width < titled.figure.width);
  CHECK(low.y <= titled.figure.height);
}

TEST_CASE("a page that is cut to the drawing has annotations and numbers where they belong") {
  PlacedAnnotations annotations;
  annotations.annotations = std::make_shared<const Annotations>(
      Annotations{{.kind = AnnotationKind::text, .text = "here", .anchors = {Anchor{.at = {1.0, 1.0}}}}});
  annotations.places = {{{1.0, 1.0}}};
  annotations.highlighted = {{}};
  for (const bool is_tight : {false, true}) {
    const Drawn out = figure_drawn({.shown = {}, .part = Everything{}, .is_tight = is_tight}, annotations);
    REQUIRE(out.figure.layers.size() == 2);
    REQUIRE(out.figure.layers[1].texts.size() == 1);
    const Vec2 apart = numbers(out.figure).second - out.figure.layers[1].texts[0].start;
    CHECK(apart.x == Approx(2.5 * figure::kPointsPerPixel).margin(0.02));
    CHECK(apart.y == Approx(-2.5 * figure::kPointsPerPixel).margin(0.02));
  }
}
