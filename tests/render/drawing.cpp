// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/drawing.h"

#include <stdexcept>

namespace mes::test {
namespace {

std::vector<double> with_scalars(PrimitiveKind kind, const std::vector<double>& coordinates,
                                 const std::vector<double>& scalars) {
  const std::size_t step = doubles_per(kind);
  std::vector<double> out;
  for (std::size_t i = 0; i < coordinates.size(); i += step) {
    out.insert(out.end(), coordinates.begin() + static_cast<std::ptrdiff_t>(i),
               coordinates.begin() + static_cast<std::ptrdiff_t>(i + step));
    out.push_back(scalars.empty() ? 0.0 : scalars.at(i / step));
  }
  return out;
}

render::EglContext context_or_throw() {
  auto context = render::EglContext::create();
  if (!context) throw std::runtime_error(context.error().text);
  return std::move(*context);
}

}  // namespace

FramePatch instances(LayerIndex layer, PrimitiveKind kind, const std::vector<double>& coordinates,
                     const DrawingFrame& frame, const std::vector<double>& scalars) {
  FramePatch patch;
  patch.frame = frame;
  patch.layer_count = 1;
  LayerPatch& out = patch.layers.emplace_back();
  out.layer = layer;
  out.has_scalars = !scalars.empty();
  out[kind].reset = true;
  out[kind].count = static_cast<std::uint32_t>(coordinates.size() / doubles_per(kind));
  out[kind].data = with_scalars(kind, coordinates, scalars);
  return patch;
}

FramePatch changes(LayerIndex layer, PrimitiveKind kind, std::uint32_t count, const std::vector<std::uint32_t>& index,
                   const std::vector<double>& coordinates, const DrawingFrame& frame,
                   const std::vector<double>& scalars) {
  FramePatch patch = instances(layer, kind, coordinates, frame, scalars);
  KindPatch& out = patch.layers.front()[kind];
  out.reset = false;
  out.count_changed = true;
  out.count = count;
  out.index = index;
  return patch;
}

render::Camera pixel_camera(int width, int height) {
  render::Camera camera;
  camera.set_viewport(width, height);
  camera.look_at({0.5 * width, 0.5 * height}, 1.0);
  return camera;
}

Drawing::Drawing(const render::GlDeviceOptions& options)
    : context_(context_or_throw()),
      device_(std::make_unique<render::GlDevice>(options)),
      scene_(std::make_unique<render::Scene>(*device_)) {}

void Drawing::set(LayerIndex layer, PrimitiveKind kind, const std::vector<double>& coordinates,
                  const DrawingFrame& frame, const std::vector<double>& scalars) {
  scene_->apply(instances(layer, kind, coordinates, frame, scalars));
}

render::Image Drawing::draw(const render::Camera& camera, const std::vector<render::LayerView>& views,
                            const render::ImageOptions& options) {
  auto image = render::draw_image(*device_, *scene_, camera, views, options);
  if (!image) throw std::runtime_error(image.error().text);
  return std::move(*image);
}

double cover(const render::Image& image, int x, int y) {
  return (255.0 - image.rgba[image.offset(x, y)]) / 255.0;
}

double covered_area(const render::Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) sum += cover(image, x, y);
  }
  return sum;
}

Vec2 covered_center(const render::Image& image) {
  double sum = 0.0;
  Vec2 moment;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double c = cover(image, x, y);
      sum += c;
      moment = moment + c * Vec2{x + 0.5, y + 0.5};
    }
  }
  return (1.0 / sum) * moment;
}

}  // namespace mes::test
