// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/render/drawing.h"
#include "tests/support/golden_image.h"

using namespace mes;
using namespace mes::test;
using render::Camera;
using render::Image;
using render::LayerView;

namespace {

using enum PrimitiveKind;

LayerStyle style(Rgb color, double opacity = 1.0) {
  LayerStyle out;
  out.color = color;
  out.opacity = opacity;
  return out;
}

}  // namespace

TEST_CASE("every kind of primitive, thin and thick, plain and dashed") {
  Drawing drawing;
  drawing.set(0, point, {20, 130, 35, 130, 50, 130, 20, 115, 35, 115, 50, 115});
  drawing.set(1, disk, {90, 120, 22, 120, 120, 8});
  drawing.set(2, circle, {160, 120, 22, 160, 120, 10, 190, 120, 4});
  drawing.set(3, segment, {10, 10, 60, 60, 60, 60, 60, 90, 60, 90, 20, 80, 10, 90, 10, 90});
  drawing.set(4, ray, {90, 20, 1, 0.3, 90, 20, -1, 8, 90, 20, -0.2, -0.9});
  drawing.set(5, line, {150, 50, 1, -1, 150, 50, 0, 3});
  drawing.set(6, triangle, {100, 60, 140, 60, 120, 90, 140, 60, 120, 90, 165, 88});
  drawing.set(7, circle, {160, 120, 26});
  drawing.set(8, segment, {75, 30, 75, 100, 60, 100, 5, 100});
  std::vector<LayerView> views;
  for (LayerIndex layer = 0; layer < 9; ++layer) views.push_back({layer, {}});
  views[0].style = style(palette::black);
  views[1].style = style(palette::orange, 0.6);
  views[2].style = style(palette::blue);
  views[3].style = style(palette::vermilion);
  views[3].style.line_width_px = 5.0;
  views[4].style = style(palette::green);
  views[4].style.line_width_px = 1.5;
  views[5].style = style(palette::purple, 0.5);
  views[5].style.line_width_px = 7.0;
  views[6].style = style(palette::sky, 0.7);
  views[7].style = style(palette::black);
  views[7].style.dashed = true;
  views[8].style = style(palette::grey);
  views[8].style.line_width_px = 3.0;
  views[8].style.dashed = true;
  CHECK(compare_with_golden(drawing.draw(pixel_camera(200, 150), views), "kinds") == "");
  CHECK(compare_with_golden(drawing.draw(pixel_camera(200, 150), views, {}), "kinds_transparent") == "");

  Camera camera = pixel_camera(400, 300);
  camera.zoom_at({0.0, 300.0}, 2.0);
  CHECK(compare_with_golden(drawing.draw(camera, views, {.background = Rgb{30, 30, 34}, .content_scale = 2.0}),
                            "kinds_at_double_scale") == "");
}

TEST_CASE("arcs short and long, thin, thick and dashed, begin and end round") {
  Drawing drawing;
  std::vector<double> rays;
  std::vector<double> petals;
  const auto add = [](std::vector<double>& out, Vec2 c, double r, double from, double to) {
    out.insert(out.end(), {c.x, c.y, r, c.x + r * std::cos(from), c.y + r * std::sin(from), c.x + r * std::cos(to),
                           c.y + r * std::sin(to)});
  };
  for (int i = 1; i <= 8; ++i) add(rays, {50, 50}, 5.0 * i, 0.3 * i, 0.3 * i + 0.75 * i);
  for (int i = 0; i < 6; ++i) {
    const double turn = std::numbers::pi / 3.0 * i;
    add(petals, {150 + 20.0 * std::cos(turn), 50 + 20.0 * std::sin(turn)}, 20.0, turn - 2.0, turn + 2.0);
  }
  drawing.set(0, arc, rays);
  drawing.set(1, arc, petals);
  drawing.set(2, arc, {150, 50, 46, 196, 50, 104, 50, 50, 50, 45, 50, 95, 50, 95});
  std::vector<LayerView> views{
      {0, style(palette::blue)}, {1, style(palette::orange, 0.5)}, {2, style(palette::black)}};
  views[0].style.line_width_px = 2.0;
  views[1].style.line_width_px = 6.0;
  views[2].style.dashed = true;
  CHECK(compare_with_golden(drawing.draw(pixel_camera(200, 100), views), "arcs") == "");
}

TEST_CASE("disks of a layer darken where they overlap, unless it is flat") {
  Drawing drawing;
  drawing.set(0, disk, {40, 40, 30, 70, 40, 30, 55, 65, 30});
  drawing.set(1, segment, {0, 40, 120, 44});
  std::vector<LayerView> views{{0, style(palette::orange, 0.5)}, {1, style(palette::blue, 0.5)}};
  views[1].style.line_width_px = 8.0;
  CHECK(compare_with_golden(drawing.draw(pixel_camera(110, 100), views), "overlap_blended") == "");
  views[0].style.flat = true;
  CHECK(compare_with_golden(drawing.draw(pixel_camera(110, 100), views), "overlap_flat") == "");
}

TEST_CASE("a fan of triangles has no seams") {
  Drawing drawing;
  std::vector<double> fan;
  constexpr int kPieces = 13;
  for (int i = 0; i < kPieces; ++i) {
    const auto at = [](int k) {
      const double angle = 2.0 * std::numbers::pi * k / kPieces + 0.1;
      return Vec2{60.3 + 50.0 * std::cos(angle), 60.7 + 50.0 * std::sin(angle)};
    };
    fan.insert(fan.end(), {60.3, 60.7, at(i).x, at(i).y, at(i + 1).x, at(i + 1).y});
  }
  drawing.set(0, triangle, fan);
  const Image image = drawing.draw(pixel_camera(120, 120), {{0, style(palette::black, 0.5)}});
  CHECK(compare_with_golden(image, "fan") == "");
  for (int y = 35; y < 85; ++y) {
    for (int x = 35; x < 85; ++x) CHECK(cover(image, x, y) == Approx(0.5).margin(0.03));
  }
}

TEST_CASE("overlays lie above all layers, points of them filled or as rings") {
  Drawing drawing;
  drawing.set(0, disk, {40, 40, 25});
  drawing.set(1, point, {20, 40, 40, 40, 60, 40});
  const std::vector<double> selected{20, 40, 0, 40, 40, 0};
  const std::vector<double> hovered{60, 40, 0, 100, 60, 0};
  const std::vector<double> box{10, 10, 110, 10, 0, 110, 10, 110, 70, 0, 110, 70, 10, 70, 0, 10, 70, 10, 10, 0};
  const std::vector<double> inside{10, 10, 110, 10, 110, 70, 0, 10, 10, 110, 70, 10, 70, 0};
  LayerStyle band = style(palette::blue, 0.12);
  drawing.scene().set_overlay(0, {.kind = triangle, .data = inside, .style = band});
  band.opacity = 1.0;
  band.dashed = true;
  drawing.scene().set_overlay(1, {.kind = segment, .data = box, .style = band});
  LayerStyle mark = style(palette::vermilion);
  mark.point_size_px = 9.0;
  drawing.scene().set_overlay(2, {.kind = point, .data = selected, .style = mark});
  mark.point_size_px = 14.0;
  mark.line_width_px = 2.0;
  drawing.scene().set_overlay(3, {.kind = point, .data = hovered, .style = mark, .ring = true});
  const std::vector<LayerView> views{{0, style(palette::orange, 0.4)}, {1, style(palette::black)}};
  CHECK(compare_with_golden(drawing.draw(pixel_camera(120, 80), views, {.background = kWhite, .overlays = true}),
                            "overlays") == "");
}

TEST_CASE("each n-th disk is drawn where it is, however large n is") {
  Drawing drawing;
  std::vector<double> disks;
  for (int i = 0; i < 2000; ++i) disks.insert(disks.end(), {5.0 + 0.05 * i, 10.0, i % 500 == 0 ? 4.0 : 1.0});
  drawing.set(0, PrimitiveKind::disk, disks);
  // Both ways of skipping: by the stride of a buffer, and one by one beyond the largest stride.
  for (const std::uint32_t every : {20U, 500U}) {
    const render::Image image = drawing.draw(pixel_camera(110, 20), {{0, {}, every}});
    CAPTURE(every);
    for (const int x : {5, 30, 55, 80}) {
      CHECK(cover(image, x, 10) > 0.99);
      CHECK(cover(image, x, 7) > 0.9);
    }
    const double alone = 4 * 3.14159265 * 16.0;
    if (every == 500)
      CHECK(covered_area(image) == Approx(alone).epsilon(0.02));
    else
      CHECK(covered_area(image) > 1.2 * alone);
  }
}
