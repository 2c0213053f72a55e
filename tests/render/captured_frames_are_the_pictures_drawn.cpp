// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "render/frame_capture.h"
#include "tests/render/drawing.h"
#include "tests/support/golden_image.h"

using namespace mes;
using namespace mes::test;

namespace {

LayerStyle thick_style(Rgb color, double width = 3.0) {
  LayerStyle out;
  out.color = color;
  out.line_width_px = width;
  out.point_size_px = 9.0;
  out.opacity = 0.7;
  return out;
}

void fill_both_layers(Drawing& drawing) {
  drawing.set(0, PrimitiveKind::disk, {60, 50, 30, 90, 60, 25});
  drawing.set(1, PrimitiveKind::segment, {3, 4, 140, 92, 10, 90, 150, 10});
}

std::vector<render::LayerView> views() {
  return {{0, thick_style({0xD5, 0x5E, 0x00})}, {1, thick_style({0x00, 0x72, 0xB2})}};
}

int most_different(const render::Image& first, const render::Image& second) {
  REQUIRE(first.width == second.width);
  REQUIRE(first.height == second.height);
  const render::Image a = premultiplied(first);
  const render::Image b = premultiplied(second);
  int out = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) out = std::max(out, std::abs(a.rgba[i] - b.rgba[i]));
  return out;
}

// Means of squares of `factor` pixels, by hand.
render::Image averaged(const render::Image& large, int factor) {
  render::Image out{large.width / factor, large.height / factor, {}};
  out.rgba.resize(large.rgba.size() / static_cast<std::size_t>(factor * factor));
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      for (std::size_t channel = 0; channel < 4; ++channel) {
        int sum = 0;
        for (int v = 0; v < factor; ++v)
          for (int u = 0; u < factor; ++u) sum += large.rgba[large.offset(factor * x + u, factor * y + v) + channel];
        out.rgba[out.offset(x, y) + channel] =
            static_cast<std::uint8_t>((sum + factor * factor / 2) / (factor * factor));
      }
    }
  }
  return out;
}

// The device of a drawing, whose memory is used up at one call to draw.
class ShortOfMemory final : public render::Device {
 public:
  explicit ShortOfMemory(render::Device& device) : device_(device) {}
  /// So many calls to draw succeed, then one fails.
  void fail_after(int calls) { left_ = calls; }

  render::BufferId create_buffer(std::size_t bytes) override { return device_.create_buffer(bytes); }
  void destroy_buffer(render::BufferId buffer) override { device_.destroy_buffer(buffer); }
  void resize_buffer(render::BufferId buffer, std::size_t bytes, std::size_t keep_bytes) override {
    device_.resize_buffer(buffer, bytes, keep_bytes);
  }
  void update_buffer(render::BufferId buffer, std::span<const render::ByteRange> ranges,
                     std::span<const std::byte> data) override {
    device_.update_buffer(buffer, ranges, data);
  }
  render::FramebufferId create_framebuffer(const render::FramebufferSpec& spec) override {
    return device_.create_framebuffer(spec);
  }
  void destroy_framebuffer(render::FramebufferId framebuffer) override { device_.destroy_framebuffer(framebuffer); }
  void clear(render::FramebufferId target, const render::PixelRect& area,
             const render::PremultipliedColor& color) override {
    device_.clear(target, area, color);
  }
  void read_pixels(render::FramebufferId source, const render::PixelRect& area,
                   std::span<std::uint8_t> rgba) override {
    device_.read_pixels(source, area, rgba);
  }
  render::TextureId create_texture(int width, int height, std::span<const std::uint8_t> rgba, bool smooth) override {
    return device_.create_texture(width, height, rgba, smooth);
  }
  render::TextureId create_mask(int width, int height) override { return device_.create_mask(width, height); }
  void update_mask(render::TextureId mask, int first_row, std::span<const std::uint16_t> rows) override {
    device_.update_mask(mask, first_row, rows);
  }
  void destroy_texture(render::TextureId texture) override { device_.destroy_texture(texture); }
  void draw(const render::DrawCall& call) override {
    if (left_-- == 0) throw std::bad_alloc();
    device_.draw(call);
  }
  void draw_picture(const render::PictureCall& call) override { device_.draw_picture(call); }
  void composite(render::FramebufferId target, const render::PixelRect& area, render::FramebufferId group,
                 const render::PremultipliedColor& color) override {
    device_.composite(target, area, group, color);
  }
  void paint_mask(render::FramebufferId target, const render::PixelRect& area, render::TextureId mask,
                  std::span<const render::PixelRect> parts, const render::PremultipliedColor& color) override {
    device_.paint_mask(target, area, mask, parts, color);
  }
  void finish() override { device_.finish(); }
  double pixel_cost_ns() const override { return 0.0; }
  double instance_cost_ns() const override { return 0.0; }
  int max_framebuffer_size() const override { return device_.max_framebuffer_size(); }
  const render::DeviceCounters& counters() const override { return device_.counters(); }

 private:
  render::Device& device_;
  int left_ = -1;
};

}  // namespace

TEST_CASE("a captured frame is the picture that is drawn, in tiles or not, on a colour or on nothing") {
  Drawing drawing;
  fill_both_layers(drawing);
  const render::Camera camera = pixel_camera(161, 103);
  render::FrameCapture capture(drawing.device());
  for (const std::optional<Rgb> background : {std::optional<Rgb>(kWhite), std::optional<Rgb>()}) {
    const render::Image expected = drawing.draw(camera, views(), {.background = background});
    for (const int tile : {16, 50, 2048}) {
      REQUIRE(capture.draw(drawing.scene(), camera, views(), {.background = background, .tile_px = tile}));
      const auto raw = capture.wait();
      REQUIRE(raw);
      CHECK(most_different(render::to_image(*raw), expected) <= 1);
    }
  }
  CHECK_FALSE(capture.wait());
}

TEST_CASE("supersampling gives the means of a larger picture") {
  Drawing drawing;
  fill_both_layers(drawing);
  const render::Camera camera = pixel_camera(160, 100);
  render::FrameCapture capture(drawing.device());
  for (const int factor : {2, 4}) {
    render::Camera large = camera;
    large.set_viewport(factor * 160, factor * 100);
    large.look_at(camera.center(), 1.0 / factor);
    const render::Image expected = averaged(
        drawing.draw(large, views(), {.background = kWhite, .content_scale = static_cast<double>(factor)}), factor);
    for (const int tile : {64, 2048}) {
      REQUIRE(capture.draw(drawing.scene(), camera, views(),
                           {.background = kWhite, .supersampling = factor, .tile_px = tile}));
      CHECK(most_different(render::to_image(*capture.wait()), expected) <= factor);
    }
  }
}

TEST_CASE("frames come in order, each as it was when asked for, however many are under way") {
  Drawing drawing;
  const render::Camera camera = pixel_camera(40, 40);
  render::FrameCapture capture(drawing.device());
  constexpr int kFrames = 10;
  for (int i = 0; i < kFrames; ++i) {
    drawing.set(0, PrimitiveKind::disk, {2.0 + 4 * i, 20, 1.9});
    REQUIRE(capture.draw(drawing.scene(), camera, views(), {.background = kWhite}));
  }
  CHECK(capture.pending() == kFrames);
  for (int i = 0; i < kFrames; ++i) {
    const auto raw = capture.wait();
    REQUIRE(raw);
    CHECK(covered_center(render::to_image(*raw)).x == Approx(2.0 + 4 * i).margin(0.1));
  }
  CHECK(capture.pending() == 0);
}

TEST_CASE("a frame comes without being waited for") {
  Drawing drawing;
  fill_both_layers(drawing);
  render::FrameCapture capture(drawing.device());
  CHECK_FALSE(capture.poll());
  REQUIRE(capture.draw(drawing.scene(), pixel_camera(50, 50), views(), {}));
  drawing.device().finish();
  CHECK(capture.poll());
}

TEST_CASE("a frame that was given up for lack of memory is not handed out, and those around it are whole") {
  Drawing drawing;
  ShortOfMemory device(drawing.device());
  render::Scene scene(device);
  FramePatch patch;
  patch.layers.resize(1);
  patch.layer_count = 1;
  KindPatch& disks = patch.layers[0][PrimitiveKind::disk];
  disks = {.reset = true, .count = 1, .index = {}, .data = {40, 40, 30, 0}};
  scene.apply(patch);
  const render::Camera camera = pixel_camera(80, 80);
  const std::vector<render::LayerView> shown{{0, thick_style({0, 0, 0})}};
  render::FrameCapture capture(drawing.device());
  const auto capture_on = [&](Rgb background) {
    return capture.draw(scene, camera, shown, {.background = background, .tile_px = 40}).has_value();
  };
  const auto corner_of = [](const std::optional<render::RawImage>& raw) {
    REQUIRE(raw);
    const render::Image image = render::to_image(*raw);
    REQUIRE(image.width == 80);
    for (const auto& [x, y] : {std::pair{79, 0}, std::pair{0, 79}, std::pair{79, 79}})
      for (std::size_t channel = 0; channel < 3; ++channel)
        REQUIRE(image.rgba[image.offset(x, y) + channel] == image.rgba[image.offset(0, 0) + channel]);
    const std::size_t at = image.offset(0, 0);
    return Rgb{image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
  };
  constexpr Rgb kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255};
  // None, one, two or three of its four tiles had been drawn.
  for (int tiles = 0; tiles < 4; ++tiles) {
    INFO(tiles);
    REQUIRE(capture_on(kRed));
    device.fail_after(tiles);
    REQUIRE_FALSE(capture_on(kGreen));
    REQUIRE(capture_on(kBlue));
    CHECK(corner_of(capture.wait()) == kRed);
    CHECK(corner_of(capture.wait()) == kBlue);
    CHECK_FALSE(capture.wait());
    CHECK(capture.pending() == 0);
  }
}
