// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/layer_mirror.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"

namespace mes {
namespace {

void check_instance(PrimitiveKind kind, std::span<const double> values) {
  for (const double value : values) MES_ASSERT(std::isfinite(value));
  switch (kind) {
    case PrimitiveKind::disk:
    case PrimitiveKind::circle:
    case PrimitiveKind::arc: MES_ASSERT(values[2] >= 0.0); break;
    case PrimitiveKind::ray:
    case PrimitiveKind::line: MES_ASSERT(values[2] != 0.0 || values[3] != 0.0); break;
    case PrimitiveKind::point:
    case PrimitiveKind::segment:
    case PrimitiveKind::triangle:
    case PrimitiveKind::parabola: break;
  }
}

}  // namespace

void LayerMirror::apply(const FramePatch& patch) {
  MES_ASSERT(patch.layer_count <= patch.layers.size());
  MES_ASSERT(patch.complete || (patch.layer_count == 0 && patch.frame == frame_));
  if (patch.frame != frame_) leave_frame(patch);
  for (const LayerPatch& layer : std::span(patch.layers).first(patch.layer_count)) {
    auto& kinds = layers_[layer.layer];
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      Instances& instances = kinds[static_cast<std::size_t>(kind)];
      if (layer[kind].is_empty()) {
        MES_ASSERT(layer[kind].count == instances.values.size() / stride_of(kind));
      } else {
        apply(layer[kind], kind, !layer.scalars_are_names, instances);
      }
    }
  }
  frame_ = patch.frame;
  document_revision_ = patch.document_revision;
}

// Instances in the old frame are sent again, or belong to a layer that is no longer demanded, whose instances are never
// read again.
void LayerMirror::leave_frame(const FramePatch& patch) {
  const auto sent = std::span(patch.layers).first(patch.layer_count);
  layers_.for_each([&](VariantLayer layer, auto& kinds) {
    const auto found = std::ranges::find(sent, layer, &LayerPatch::layer);
    const auto report = std::ranges::find(patch.reports, layer, &LayerReport::layer);
    const bool is_demanded = report != patch.reports.end() && report->state != NodeState::inactive;
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      Instances& instances = kinds[static_cast<std::size_t>(kind)];
      if (instances.values.empty()) continue;
      const bool is_reset = found != sent.end() && (*found)[kind].reset;
      MES_ASSERT(is_reset || !is_demanded);
      if (!is_reset) instances = {};
    }
  });
}

void LayerMirror::apply(const KindPatch& patch, PrimitiveKind kind, bool with_scalars, Instances& instances) {
  const auto digest = [&](std::span<const double> values) { return digest_of(kind, values, with_scalars); };
  const std::size_t stride = stride_of(kind);
  const std::size_t size = patch.count * stride;
  const std::span<const double> data = patch.data;
  if (patch.reset) {
    MES_ASSERT(patch.index.empty());
    MES_ASSERT(data.size() == size);
    for (std::size_t at = 0; at < size; at += stride) check_instance(kind, data.subspan(at, stride));
    instances.values = patch.data;
    instances.digest = digest(instances.values);
    return;
  }
  MES_ASSERT(data.size() == patch.index.size() * stride);
  std::vector<double>& values = instances.values;
  const std::size_t known = values.size() / stride;
  std::size_t missing = patch.count > known ? patch.count - known : 0;
  written_.assign(missing, false);
  if (size < values.size()) instances.digest -= digest(std::span(std::as_const(values)).subspan(size));
  values.resize(size);
  for (std::size_t i = 0; i < patch.index.size(); ++i) {
    const std::size_t instance = patch.index[i];
    check_instance(kind, data.subspan(i * stride, stride));
    if (instance >= patch.count) continue;  // written and dropped again within one run
    const std::span<double> place = std::span(values).subspan(instance * stride, stride);
    const bool is_new = instance >= known && !written_[instance - known];
    if (!is_new) instances.digest -= digest(place);
    std::ranges::copy(data.subspan(i * stride, stride), place.begin());
    instances.digest += digest(place);
    if (!is_new) continue;
    written_[instance - known] = true;
    --missing;
  }
  MES_ASSERT(missing == 0);
}

std::uint32_t LayerMirror::count(VariantLayer layer, PrimitiveKind kind) const {
  return static_cast<std::uint32_t>(instances(layer, kind).size() / stride_of(kind));
}

std::span<const double> LayerMirror::instances(VariantLayer layer, PrimitiveKind kind) const {
  const auto* const kinds = layers_.find(layer);
  return kinds == nullptr ? std::span<const double>() : (*kinds)[static_cast<std::size_t>(kind)].values;
}

LayerDigest LayerMirror::digest(VariantLayer layer) const {
  LayerDigest out;
  if (const auto* const kinds = layers_.find(layer))
    for (const Instances& instances : *kinds) out += instances.digest;
  return out;
}

}  // namespace mes
