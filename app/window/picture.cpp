// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture.h"

#include <algorithm>
#include <array>

namespace mes {
namespace {

constexpr std::uint32_t kSelectionMark = 0;
constexpr std::uint32_t kHoverMark = 1;
constexpr double kFailedOpacity = 0.35;

// The last good picture of a failed layer stays, drained of its colour.
LayerStyle greyed(LayerStyle style) {
  const auto luma = static_cast<std::uint8_t>((2 * style.color.r + 3 * style.color.g + style.color.b) / 6);
  const auto pale = static_cast<std::uint8_t>((luma + 2 * 0x99) / 3);
  style.color = {pale, pale, pale};
  style.opacity *= kFailedOpacity;
  return style;
}

}  // namespace

Picture::Picture() : scene_(device_) {}

bool Picture::take_from(Engine& engine) {
  bool took = false;
  while (auto patch = engine.poll()) {
    scene_.apply(*patch);
    document_revision_ = patch->document_revision;
    reports_.swap(patch->reports);
    nodes_.swap(patch->nodes);
    engine.recycle(std::move(patch));
    took = true;
  }
  return took;
}

void Picture::forget_hidden(const LayerStack& layers) {
  for (const LayerIndex layer : layers.order())
    if (!layers.is_visible(layer)) scene_.forget(layer);
}

const LayerReport* Picture::report(LayerIndex layer) const {
  const auto found = std::ranges::find(reports_, layer, &LayerReport::layer);
  return found == reports_.end() ? nullptr : &*found;
}

NodeState Picture::state(LayerIndex layer) const {
  const LayerReport* found = report(layer);
  return found == nullptr ? NodeState::inactive : found->state;
}

void Picture::mark_selection(const Editor& editor) {
  const MarkedState now{editor.document().revision(), editor.selection().revision(), scene_.frame()};
  if (now == marked_) return;
  const bool was_empty = mark_data_.empty();
  marked_ = now;
  mark_data_.clear();
  for (const Slot slot : editor.selection().slots()) {
    const Vec2 p = editor.document().position(slot);
    mark_data_.insert(mark_data_.end(), {p.x, p.y, 0.0});
  }
  if (mark_data_.empty()) {
    if (!was_empty) scene_.clear_overlay(kSelectionMark);
    return;
  }
  LayerStyle style;
  style.color = palette::blue;
  style.point_size_px = 9.0;
  scene_.set_overlay(kSelectionMark, {PrimitiveKind::point, mark_data_, style, false});
}

void Picture::mark_hovered(const Editor& editor, Slot hovered) {
  if (hovered == kNoSlot || !editor.document().is_alive(hovered)) {
    scene_.clear_overlay(kHoverMark);
    return;
  }
  const Vec2 p = editor.document().position(hovered);
  const std::array<double, 3> point{p.x, p.y, 0.0};
  LayerStyle style;
  style.color = palette::blue;
  style.point_size_px = 15.0;
  style.line_width_px = 2.0;
  scene_.set_overlay(kHoverMark, {PrimitiveKind::point, point, style, true});
}

void Picture::draw(const render::Camera& camera, const LayerStack& layers, const Editor& editor, Slot hovered,
                   double content_scale) {
  mark_selection(editor);
  mark_hovered(editor, hovered);
  std::vector<render::LayerView> views;
  for (const LayerIndex layer : layers.visible_layers()) {
    const NodeState now = state(layer);
    const bool failed = now == NodeState::failed || now == NodeState::blocked;
    views.push_back({layer, failed ? greyed(layers.style(layer)) : layers.style(layer)});
  }
  device_.clear({}, {0, 0, camera.width(), camera.height()}, {1.0F, 1.0F, 1.0F, 1.0F});
  scene_.draw(camera, views, {.content_scale = content_scale});
}

}  // namespace mes
