// SPDX-License-Identifier: GPL-3.0-or-later
// Counting segments and points gives the picture of painting them, whatever was added, moved and removed before.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/base/rng.h"
#include "render/device/recording_device.h"
#include "render/instances/counted_instances.h"
#include "render/instances/stroke_field.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::render;
using namespace mes::test;

namespace {

struct Stroke {
  Vec2 from;
  Vec2 to;
};

/// From dots to longer than the view, in all directions, inside, at its edges and beside it; some of them upright,
/// level, or with ends on the grid of pixels.
std::vector<Stroke> random_strokes(Rng& rng, std::size_t count, int width, int height) {
  std::vector<Stroke> out;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 from{(2.0 * rng.uniform() - 0.5) * width, (2.0 * rng.uniform() - 0.5) * height};
    const double size = std::exp2(-5.0 + 14.0 * rng.uniform());
    const double turn = 6.283185307179586 * rng.uniform();
    out.push_back({from, from + Vec2{size * std::cos(turn), size * std::sin(turn)}});
    if (i % 5 == 0) out.back().to = from;
    if (i % 7 == 0) out.back().to.x = from.x;
    if (i % 11 == 0) out.back().to.y = from.y;
    if (i % 13 == 0) out.back().from = {std::floor(from.x) + 0.5, std::floor(from.y)};
  }
  return out;
}

std::vector<PixelStroke> visible(const std::vector<Stroke>& strokes, int width, int height, double half_width) {
  std::vector<PixelStroke> out;
  for (const Stroke& stroke : strokes)
    if (const auto shown = StrokeField::visible(stroke.from, stroke.to, width, height, half_width))
      out.push_back(*shown);
  return out;
}

/// The same by the formula of the header, stroke by stroke in doubles; caps and ramps as in shaders/stroke.frag.
double opacity_of_strokes_at(const std::vector<Stroke>& strokes, double opacity, double half_width, int x, int y) {
  const Vec2 p{x + 0.5, y + 0.5};
  double passes = 1.0;
  for (const Stroke& stroke : strokes) {
    const Vec2 step = stroke.to - stroke.from;
    const double square = dot(step, step);
    const double t = square > 0.0 ? std::clamp(dot(p - stroke.from, step) / square, 0.0, 1.0) : 0.0;
    const double distance = length(p - (stroke.from + t * step)) - half_width;
    passes *= 1.0 - opacity * std::clamp(0.5 - distance, 0.0, 1.0);
  }
  return 1.0 - passes;
}

double difference_of_strokes(const StrokeField& field, const std::vector<Stroke>& strokes, double opacity,
                             double half_width) {
  double worst = 0.0;
  for (int y = 0; y < field.height(); ++y)
    for (int x = 0; x < field.width(); ++x)
      worst = std::max(worst, std::abs(field.row(y)[static_cast<std::size_t>(x)] / 65535.0 -
                                       opacity_of_strokes_at(strokes, opacity, half_width, x, y)));
  return worst;
}

std::vector<std::uint16_t> opacities_of_strokes(const StrokeField& field) {
  const auto rows = field.rows({0, field.height()});
  return {rows.begin(), rows.end()};
}

std::vector<double> coordinates_of_strokes(const std::vector<Stroke>& strokes, PrimitiveKind kind) {
  std::vector<double> out;
  for (const Stroke& stroke : strokes) {
    out.insert(out.end(), {stroke.from.x, stroke.from.y});
    if (kind == PrimitiveKind::segment) out.insert(out.end(), {stroke.to.x, stroke.to.y});
  }
  return out;
}

constexpr std::array kKinds{PrimitiveKind::segment, PrimitiveKind::point};

}  // namespace

TEST_CASE("a field of strokes has the opacity of painting without rounding") {
  Rng rng(30);
  constexpr int kWidth = 90;
  constexpr int kHeight = 70;
  for (const std::size_t count : {1U, 5U, 40U, 400U}) {
    for (const double opacity : {0.01, 0.5, 1.0}) {
      for (const double half_width : {0.5, 0.8, 4.0}) {
        const auto strokes = random_strokes(rng, count, kWidth, kHeight);
        StrokeField field(kWidth, kHeight, opacity, half_width);
        field.add(visible(strokes, kWidth, kHeight, half_width));
        field.settle();
        INFO(count << " strokes of opacity " << opacity << " and half width " << half_width);
        CHECK(difference_of_strokes(field, strokes, opacity, half_width) < 1e-3);
      }
    }
  }
}

TEST_CASE("strokes that leave the view by far are where they would be") {
  constexpr int kWidth = 60;
  constexpr int kHeight = 40;
  for (const double size : {1e2, 1e4, 1e6, 1e9}) {
    for (const double turn : {0.0, 0.003, 0.4, 1.5707963267948966, 1.6, 2.9, 4.0, 5.5}) {
      const Vec2 along{size * std::cos(turn), size * std::sin(turn)};
      const Vec2 through{31.3, 17.9};
      for (const auto& strokes :
           {std::vector<Stroke>{{through - along, through + along}}, std::vector<Stroke>{{through, through + along}},
            std::vector<Stroke>{{through + 3.0 * along, through + along}}}) {
        StrokeField field(kWidth, kHeight, 0.5, 1.2);
        field.add(visible(strokes, kWidth, kHeight, 1.2));
        field.settle();
        INFO("size " << size << ", direction " << turn);
        CHECK(difference_of_strokes(field, strokes, 0.5, 1.2) < 1e-3);
      }
    }
  }
  CHECK_FALSE(StrokeField::visible({-50.0, 0.0}, {-20.0, 39.0}, kWidth, kHeight, 1.2).has_value());
  CHECK_FALSE(StrokeField::visible({-50.0, 20.0}, {20.0, 90.0}, kWidth, kHeight, 1.2).has_value());
}

TEST_CASE("a field of strokes is a function of their set") {
  Rng rng(31);
  constexpr int kWidth = 120;
  constexpr int kHeight = 95;
  auto strokes = visible(random_strokes(rng, 700, kWidth, kHeight), kWidth, kHeight, 0.7);
  REQUIRE(strokes.size() > 200);
  StrokeField once(kWidth, kHeight, 0.3, 0.7);
  once.add(strokes);
  once.settle();

  // In another order, a few at a time, with others that go again.
  const auto others = visible(random_strokes(rng, 500, kWidth, kHeight), kWidth, kHeight, 0.7);
  StrokeField slowly(kWidth, kHeight, 0.3, 0.7);
  slowly.add(others);
  slowly.settle();
  std::ranges::reverse(strokes);
  for (std::size_t i = 0; i < strokes.size(); i += 3) {
    slowly.add(std::span(strokes).subspan(i, std::min<std::size_t>(3, strokes.size() - i)));
    if (i % 2 == 0) slowly.settle();
  }
  slowly.remove(others);
  slowly.settle();
  CHECK(opacities_of_strokes(slowly) == opacities_of_strokes(once));

  slowly.remove(strokes);
  slowly.settle();
  CHECK(std::ranges::all_of(opacities_of_strokes(slowly),
                            [](std::uint16_t opacity_there) { return opacity_there == 0; }));
}

TEST_CASE("the scene draws the same segments and points by counting and by painting") {
  constexpr int kWidth = 200;
  constexpr int kHeight = 150;
  constexpr std::array kZooms{1.0, 0.03, 4.1, 300.0};
  for (const PrimitiveKind kind : kKinds) {
    for (const bool is_flat : {false, true}) {
      for (const double size : {0.4, 1.0, 5.0}) {
        const LayerView view{.layer = 3,
                             .style = {.color = {40, 120, 200},
                                       .opacity = 0.6,
                                       .point_size_px = size,
                                       .line_width_px = size,
                                       .flat = is_flat}};
        const auto pictures = [&](double instance_cost_ns, std::uint64_t masks) {
          Rng rng(32);
          Drawing drawing({.instance_cost_ns = instance_cost_ns});
          drawing.set(3, kind, coordinates_of_strokes(random_strokes(rng, 60, kWidth, kHeight), kind));
          std::vector<Image> out;
          for (const double zoom : kZooms) {
            Camera camera = pixel_camera(kWidth, kHeight);
            camera.zoom_at({71.0, 40.0}, zoom);
            out.push_back(drawing.draw(camera, {view}));
          }
          CHECK(drawing.device().counters().masks == masks);
          return out;
        };
        const auto painted = pictures(0.0, 0);
        const auto counted = pictures(1e9, kZooms.size());
        for (std::size_t i = 0; i < kZooms.size(); ++i) {
          INFO(name_of(kind) << (is_flat ? ", flat" : ", blended") << ", size " << size << ", zoom " << kZooms[i]);
          // Painting rounds to a grey level after each stroke, and interpolates along it in single precision.
          CHECK(largest_difference(painted[i], counted[i]) <= 6);
        }
        CHECK(covered_area(counted[0]) > 1.0);
      }
    }
  }
}

TEST_CASE("counted strokes follow the edits of their layer") {
  constexpr int kWidth = 160;
  constexpr int kHeight = 100;
  for (const PrimitiveKind kind : kKinds) {
    Rng rng(33);
    Drawing edited({.instance_cost_ns = 1e9});
    const LayerView view{.layer = 0, .style = {.color = {0, 0, 0}, .opacity = 0.2}};
    std::vector<Stroke> strokes = random_strokes(rng, 200, kWidth, kHeight);
    edited.set(0, kind, coordinates_of_strokes(strokes, kind));
    Camera camera = pixel_camera(kWidth, kHeight);
    for (int step = 0; step < 60; ++step) {
      // Some strokes move, the last ones go, or new ones come.
      const auto count = static_cast<std::size_t>(rng.below(3) == 0 ? 120 + rng.below(100) : strokes.size());
      const auto fresh = random_strokes(rng, 240, kWidth, kHeight);
      std::vector<std::uint32_t> index;
      for (std::size_t i = strokes.size(); i < count; ++i) index.push_back(static_cast<std::uint32_t>(i));
      strokes.resize(count);
      const std::uint64_t moved = rng.below(2) == 0 ? rng.below(5) : rng.below(80);
      for (std::uint64_t i = 0; i < moved; ++i) index.push_back(static_cast<std::uint32_t>(rng.below(count)));
      std::vector<Stroke> written;
      for (std::size_t i = 0; i < index.size(); ++i) written.push_back(strokes[index[i]] = fresh[i % fresh.size()]);
      edited.scene().apply(
          changes(0, kind, static_cast<std::uint32_t>(count), index, coordinates_of_strokes(written, kind)));
      if (step % 3 == 1) continue;  // several patches before a picture
      if (step % 10 == 4) camera.pan({3.5, -1.25});
      if (step % 20 == 7) camera.set_viewport(kWidth - step, kHeight + step);

      edited.scene().forget(1);
      edited.set(1, kind, coordinates_of_strokes(strokes, kind));
      LayerView fresh_view = view;
      fresh_view.layer = 1;
      INFO(name_of(kind) << ", step " << step);
      REQUIRE(edited.draw(camera, {view}).rgba == edited.draw(camera, {fresh_view}).rgba);
    }
  }
}

TEST_CASE("a preview of very many strokes is a grey level off in the mean, and follows edits") {
  constexpr int kWidth = 400;
  constexpr int kHeight = 300;
  constexpr std::uint32_t kCount = 120000;
  for (const PrimitiveKind kind : kKinds) {
    Rng rng(34);
    // Along a closed curve of some hundred strokes a pixel, and away from it.
    std::vector<Stroke> strokes;
    const auto at = [](double t) { return Vec2{200.0 + 150.0 * std::cos(t), 150.0 + 90.0 * std::sin(2.0 * t)}; };
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const double t = 6.283185307179586 * i / kCount;
      const Vec2 aside{12.0 * rng.uniform(), 9.0 * rng.uniform()};
      strokes.push_back({at(t), i % 10 == 0 ? at(t) + aside : at(t + 6.283185307179586 / kCount)});
    }
    const LayerView view{.layer = 0, .style = {.color = {0, 0, 0}, .opacity = 0.05, .point_size_px = 2.0}};
    Drawing drawing({.instance_cost_ns = 1e9});
    drawing.set(0, kind, coordinates_of_strokes(strokes, kind));
    const Camera camera = pixel_camera(kWidth, kHeight);
    GlDevice& device = drawing.device();
    const FramebufferId target = device.create_framebuffer({.width = kWidth, .height = kHeight});
    const PixelRect all{0, 0, kWidth, kHeight};
    const auto picture = [&](LayerIndex layer, Preview preview) {
      LayerView shown = view;
      shown.layer = layer;
      device.clear(target, all, {1.0F, 1.0F, 1.0F, 1.0F});
      drawing.scene().draw(camera, std::span(&shown, 1), {.target = target, .preview = preview});
      return read_image(device, target, all);
    };
    const Image exact = picture(0, Preview::none);
    const Image preview = picture(0, Preview::fine);
    CHECK(covered_area(exact) > 400.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < exact.rgba.size(); ++i) sum += std::abs(int{exact.rgba[i]} - int{preview.rgba[i]});
    INFO(name_of(kind));
    CHECK(sum / static_cast<double>(exact.rgba.size()) <= 1.0);
    CHECK(sum > 0.0);
    CHECK_FALSE(drawing.scene().is_coarse());
    const Image coarse = picture(0, Preview::coarse);
    CHECK(drawing.scene().is_coarse());
    CHECK(std::abs(covered_area(coarse) - covered_area(exact)) < 0.02 * covered_area(exact));
    CHECK(picture(0, Preview::fine).rgba == preview.rgba);

    const std::vector<std::uint32_t> moved{7, 70000, kCount - 1};
    std::vector<Stroke> written;
    for (const std::uint32_t i : moved) written.push_back(strokes[i] = {at(0.1 * i) + Vec2{3.0, 3.0}, at(0.1 * i)});
    drawing.scene().apply(changes(0, kind, kCount, moved, coordinates_of_strokes(written, kind)));
    drawing.set(1, kind, coordinates_of_strokes(strokes, kind));
    CHECK(picture(0, Preview::fine).rgba == picture(1, Preview::fine).rgba);
    CHECK(picture(0, Preview::none).rgba == picture(1, Preview::none).rgba);
    device.destroy_framebuffer(target);
  }
}

TEST_CASE("strokes are counted, and kept for that, only where it takes less time") {
  const std::vector<double> short_strokes = [] {
    std::vector<double> out;
    for (int i = 0; i < 40000; ++i) out.insert(out.end(), {0.02 * i, 300.0, 0.02 * i + 1.0, 300.0, 0.0});
    return out;
  }();
  const PixelFrame frame{.center_x = 400.0, .center_y = 300.0, .width = 800, .height = 600};
  RecordingDevice device;
  const auto buffer_of = [&](std::uint32_t count) {
    InstanceBuffer buffer(device, PrimitiveKind::segment);
    buffer.replace(count, short_strokes, {}, false);
    return buffer;
  };
  // A graphics card.
  device.set_instance_cost_ns(10.0);
  CHECK(buffer_of(40000).kept().empty());
  CHECK_FALSE(CountedInstances::is_cheaper(buffer_of(40000), frame, device));
  // A processor that paints.
  device.set_instance_cost_ns(1000.0);
  CHECK(CountedInstances::is_cheaper(buffer_of(40000), frame, device));
  CHECK_FALSE(CountedInstances::is_cheaper(buffer_of(100), frame, device));
  // Tiles of one picture are drawn in the same way.
  const PixelFrame tile{.center_x = 400.0, .center_y = 300.0, .width = 16, .height = 16};
  CHECK_FALSE(CountedInstances::is_cheaper(buffer_of(1000), tile, device));
}

TEST_CASE("dashes and colour maps are painted, however many the strokes are") {
  RecordingDevice device;
  device.set_instance_cost_ns(1e9);
  Scene scene(device);
  const FramebufferId target = device.create_framebuffer({.width = 100, .height = 100});
  std::vector<double> many;
  std::vector<double> scalars;
  for (int i = 0; i < 1000; ++i) {
    many.insert(many.end(), {0.1 * i, 0.0, 0.1 * i, 100.0});
    scalars.push_back(i);
  }
  scene.apply(instances(0, PrimitiveKind::segment, many, {}, scalars));
  const Camera camera = pixel_camera(100, 100);
  const auto masks_of = [&](const LayerStyle& style) {
    const LayerView view{.layer = 0, .style = style};
    const std::uint64_t before = device.counters().masks;
    scene.draw(camera, std::span(&view, 1), {.target = target});
    return device.counters().masks - before;
  };
  CHECK(masks_of({}) == 1);
  CHECK(masks_of({.dashed = true}) == 0);
  CHECK(masks_of({.color_map = "grey"}) == 0);
  CHECK(masks_of({}) == 1);
  device.destroy_framebuffer(target);
}
