// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers_of_a_test.h"

#include <array>

namespace mes::test {
namespace {

const std::array<LayerDescriptor, 3>& descriptors() {
  static const std::array<LayerDescriptor, 3> kLayers{
      LayerDescriptor{.id = "plain", .name = "Plain & <simple>"},
      LayerDescriptor{.id = "scalars", .name = "Scalars", .scalar = "s"},
      LayerDescriptor{.id = "third", .name = "Third"}};
  return kLayers;
}

}  // namespace

void Layers::add(LayerIndex layer, PrimitiveKind kind, std::vector<double> instances) {
  FramePatch patch;
  LayerPatch& changes = patch.layers.emplace_back();
  changes.layer = layer;
  changes.has_scalars = !descriptors()[layer].scalar.empty();
  for (const PrimitiveKind other : kAllPrimitiveKinds) changes[other].count = mirror_.count(layer, other);
  KindPatch& of_kind = changes[kind];
  of_kind.reset = true;
  of_kind.count = static_cast<std::uint32_t>(instances.size() / stride_of(kind));
  of_kind.data = std::move(instances);
  patch.layer_count = 1;
  mirror_.apply(patch);
}

LayerStyle& Layers::show(LayerIndex layer) {
  return views_.emplace_back(render::LayerView{.layer = layer, .style = {}}).style;
}

figure::Figure Layers::figure(double width, double height) const {
  return figure::figure_of(
      {.mirror = mirror_, .layers = descriptors(), .views = views_, .maps = maps, .scale = scale},
      page_of_points(width, height));
}

figure::Page page_of_points(double width, double height) {
  return {.center = {0.5 * width, 0.5 * height}, .units_per_point = 1.0, .width = width, .height = height};
}

std::vector<figure::Shape> shapes_of(const figure::FigureLayer& layer) {
  std::vector<figure::Shape> out;
  for (const figure::Group& group : layer.groups)
    for (const figure::Run& run : group.runs) out.insert(out.end(), run.shapes.begin(), run.shapes.end());
  return out;
}

std::vector<std::string> values_of(const std::string& xml, const std::string& attribute) {
  const std::string begin = ' ' + attribute + "=\"";
  std::vector<std::string> out;
  for (std::size_t at = xml.find(begin); at != std::string::npos; at = xml.find(begin, at)) {
    at += begin.size();
    out.push_back(xml.substr(at, xml.find('"', at) - at));
  }
  return out;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++out;
  return out;
}

}  // namespace mes::test
