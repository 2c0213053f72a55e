// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/moved_points.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace mes {
namespace {

constexpr std::uint32_t kNotDrawn = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kStride = stride_of(PrimitiveKind::point);

}  // namespace

void MovedPoints::take(const FramePatch& patch) {
  for (const LayerPatch& layer : std::span(patch.layers).first(patch.layer_count)) {
    if (layer.layer != layer_) continue;
    const KindPatch& points = layer[PrimitiveKind::point];
    if (points.is_empty()) continue;
    has_scalars_ = layer.has_scalars;
    has_other_ids_ = has_other_ids_ || points.reset || points.count != ids_.size();
    ids_.resize(points.count, 0.0);
    const auto set = [this](std::size_t instance, double id) {
      if (instance >= ids_.size()) return;
      has_other_ids_ = has_other_ids_ || ids_[instance] != id;
      ids_[instance] = id;
    };
    if (points.reset)
      for (std::size_t i = 0; i < ids_.size(); ++i) set(i, points.data[kStride * (i + 1) - 1]);
    for (std::size_t k = 0; k < points.index.size(); ++k) set(points.index[k], points.data[kStride * (k + 1) - 1]);
  }
}

void MovedPoints::find_instances(std::vector<SampleId> samples) {
  if (!has_other_ids_ && samples == searched_) return;
  searched_ = std::move(samples);
  has_other_ids_ = false;
  instance_of_searched_.assign(searched_.size(), kNotDrawn);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const SampleId id{static_cast<std::uint32_t>(ids_[i])};
    const auto found = std::ranges::lower_bound(searched_, id);
    if (found != searched_.end() && *found == id)
      instance_of_searched_[static_cast<std::size_t>(found - searched_.begin())] = static_cast<std::uint32_t>(i);
  }
}

const FramePatch* MovedPoints::catch_up(const Document& document, std::span<const SampleSlot> samples,
                                        const DrawingFrame& frame) {
  std::vector<SampleId> ids;
  ids.reserve(samples.size());
  for (const SampleSlot slot : samples) ids.push_back(document.id(slot));
  std::ranges::sort(ids);
  find_instances(std::move(ids));
  patch_.layers.resize(1);
  patch_.layer_count = 1;
  patch_.frame = frame;
  LayerPatch& layer = patch_.layers.front();
  layer.layer = layer_;
  layer.has_scalars = has_scalars_;
  layer.scalars_are_names = true;
  KindPatch& points = layer[PrimitiveKind::point];
  points.clear();
  points.count = static_cast<std::uint32_t>(ids_.size());
  for (std::size_t k = 0; k < searched_.size(); ++k) {
    const std::uint32_t instance = instance_of_searched_[k];
    if (instance == kNotDrawn) continue;
    const Vec2 p = document.position(document.slot_of(searched_[k]));
    points.index.push_back(instance);
    points.data.insert(points.data.end(), {p.x, p.y, ids_[instance]});
  }
  return points.index.empty() ? nullptr : &patch_;
}

}  // namespace mes
