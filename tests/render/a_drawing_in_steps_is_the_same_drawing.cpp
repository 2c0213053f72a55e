// SPDX-License-Identifier: GPL-3.0-or-later
// A window draws in several turns, and shows its last complete drawing meanwhile.
#include <catch2/catch.hpp>
#include <vector>

#include "core/base/rng.h"
#include "render/kept_frame.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::render;
using namespace mes::test;

namespace {

constexpr int kStepsWidth = 160;
constexpr int kStepsHeight = 120;
constexpr PixelRect kStepsArea{0, 0, kStepsWidth, kStepsHeight};
constexpr PremultipliedColor kStepsPaper{1.0F, 1.0F, 1.0F, 1.0F};

std::vector<double> random_coordinates(Rng& rng, std::size_t count, std::size_t stride) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count * stride; ++i)
    out.push_back(i % stride == 2 && stride == 3 ? 1.0 + 20.0 * rng.uniform() : kStepsWidth * rng.uniform());
  return out;
}

/// Layers of every way to draw: painted, as a group, coloured by scalars, thinned, counted.
std::vector<LayerView> fill_steps(Drawing& drawing) {
  Rng rng(50);
  std::vector<double> scalars;
  for (int i = 0; i < 500; ++i) scalars.push_back(i);
  drawing.set(0, PrimitiveKind::disk, random_coordinates(rng, 500, 3));
  drawing.set(1, PrimitiveKind::segment, random_coordinates(rng, 500, 4));
  drawing.set(2, PrimitiveKind::circle, random_coordinates(rng, 500, 3));
  drawing.set(3, PrimitiveKind::triangle, random_coordinates(rng, 500, 6));
  drawing.set(4, PrimitiveKind::disk, random_coordinates(rng, 500, 3), {}, scalars);
  drawing.set(5, PrimitiveKind::disk, random_coordinates(rng, 500, 3), {}, scalars);
  const auto style = [](double opacity, bool flat) {
    return LayerStyle{.color = {200, 60, 30}, .opacity = opacity, .flat = flat};
  };
  std::vector<LayerView> views;
  for (LayerIndex layer = 0; layer < 6; ++layer)
    views.push_back({.layer = layer, .style = style(0.1 + 0.1 * layer, layer % 2 == 1)});
  for (const std::size_t mapped : {4U, 5U}) views[mapped].style.color_map = "grey";
  views[4].every = 8;
  return views;
}

}  // namespace

TEST_CASE("a drawing in the smallest steps has the pixels of one that is made at once") {
  for (const double cost : {0.0, 1e9}) {
    Drawing drawing({.pixel_cost_ns = cost, .instance_cost_ns = cost});
    const std::vector<LayerView> views = fill_steps(drawing);
    GlDevice& device = drawing.device();
    const FramebufferId target = device.create_framebuffer({.width = kStepsWidth, .height = kStepsHeight});
    const DrawOptions options{.target = target, .preview = Preview::fine};
    const Camera camera = pixel_camera(kStepsWidth, kStepsHeight);
    device.clear(target, kStepsArea, kStepsPaper);
    drawing.scene().draw(camera, views, options);
    const Image at_once = read_image(device, target, kStepsArea);
    const std::uint32_t calls = drawing.scene().draw_calls();
    CHECK(covered_area(at_once) > 0.1 * kStepsWidth * kStepsHeight);

    device.clear(target, kStepsArea, kStepsPaper);
    Scene::Drawing steps = drawing.scene().begin(camera, views, options);
    CHECK(covered_area(read_image(device, target, kStepsArea)) == 0.0);
    int turns = 1;
    while (!steps.go_on(0.0)) ++turns;
    INFO("cost " << cost);
    CHECK(turns > static_cast<int>(views.size()));
    CHECK(drawing.scene().draw_calls() >= calls);
    CHECK(read_image(device, target, kStepsArea).rgba == at_once.rgba);
    CHECK(steps.go_on(0.0));
    device.destroy_framebuffer(target);
  }
}

TEST_CASE("a kept drawing is shown as it was, and moved to where another camera sees it") {
  Drawing drawing;
  GlDevice& device = drawing.device();
  drawing.set(0, PrimitiveKind::disk, {50.0, 70.0, 20.0});
  const LayerView view{.layer = 0, .style = {.color = {0, 0, 0}}};
  const FramebufferId screen = device.create_framebuffer({.width = kStepsWidth, .height = kStepsHeight});
  {
    KeptFrame kept(device);
    const auto draw = [&](const Camera& camera) {
      const FramebufferId target = kept.begin(kStepsWidth, kStepsHeight);
      device.clear(target, kStepsArea, kStepsPaper);
      drawing.scene().draw(camera, std::span(&view, 1), {.target = target});
    };
    const auto on_screen = [&] { return read_image(device, screen, kStepsArea); };
    const Camera was = pixel_camera(kStepsWidth, kStepsHeight);
    CHECK_FALSE(kept.has(kStepsWidth, kStepsHeight));
    draw(was);
    CHECK_FALSE(kept.has(kStepsWidth, kStepsHeight));
    kept.show_begun(screen);
    const Image drawn = on_screen();
    kept.keep();
    CHECK(kept.has(kStepsWidth, kStepsHeight));
    CHECK_FALSE(kept.has(kStepsWidth + 1, kStepsHeight));
    device.clear(screen, kStepsArea, kStepsPaper);
    kept.show(screen);
    CHECK(on_screen().rgba == drawn.rgba);

    // A drawing under way changes nothing of what is kept.
    device.clear(kept.begin(kStepsWidth, kStepsHeight), kStepsArea, {0.0F, 0.0F, 0.0F, 1.0F});
    kept.show(screen);
    CHECK(on_screen().rgba == drawn.rgba);

    // Whole pixels aside, it is the drawing for that camera.
    Camera now = was;
    now.pan({31.0, -12.0});
    kept.show_moved(kStepsArea, was, now, kStepsPaper, screen);
    const Image moved = on_screen();
    device.clear(screen, kStepsArea, kStepsPaper);
    drawing.scene().draw(now, std::span(&view, 1), {.target = screen});
    CHECK(largest_difference(moved, on_screen()) <= 2);

    for (const double factor : {0.3, 0.9, 1.7, 6.0}) {
      now = was;
      now.zoom_at({40.0, 60.0}, factor);
      kept.show_moved(kStepsArea, was, now, kStepsPaper, screen);
      const Image scaled = on_screen();
      device.clear(screen, kStepsArea, kStepsPaper);
      drawing.scene().draw(now, std::span(&view, 1), {.target = screen});
      const Image exact = on_screen();
      INFO("zoom " << factor);
      CHECK(covered_area(scaled) == Approx(covered_area(exact)).epsilon(0.08));
      if (factor < 1.0) {
        CHECK(covered_center(scaled).x == Approx(covered_center(exact).x).margin(1.0));
        CHECK(covered_center(scaled).y == Approx(covered_center(exact).y).margin(1.0));
      }
    }
    // Out of view, or far too small: paper alone.
    now = was;
    now.pan({1e9, 0.0});
    kept.show_moved(kStepsArea, was, now, kStepsPaper, screen);
    CHECK(covered_area(on_screen()) == 0.0);
    now = was;
    now.zoom_at({40.0, 60.0}, 1e-7);
    kept.show_moved(kStepsArea, was, now, kStepsPaper, screen);
    CHECK(covered_area(on_screen()) == 0.0);

    // A pane: nothing outside of it changes.
    const PixelRect pane{20, 10, 60, 50};
    now = was;
    now.zoom_at({10.0, 10.0}, 9.0);
    device.clear(screen, kStepsArea, kStepsPaper);
    kept.show_moved(pane, was.part(20, 60, 60, 50), now.part(20, 60, 60, 50), {0.0F, 0.0F, 0.0F, 1.0F}, screen);
    CHECK(covered_area(on_screen()) <= 60.0 * 50.0);
  }
  device.destroy_framebuffer(screen);
}
