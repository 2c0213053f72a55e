// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/canvas/tools/measure_tool.h"

namespace mes {

MeasureTool::Place MeasureTool::place_at(const Pointer& pointer) const {
  const Editor& editor = context_.editor;
  const SampleSlot sample = editor.index().nearest(pointer.world, kPickRadiusPx * pointer.units_per_px);
  if (sample == kNoSlot) return {pointer.world, {}};
  return {editor.document().position(sample), editor.document().id(sample)};
}

SampleSlot MeasureTool::sample_of(const Place& place) const {
  return place.sample.is_valid() ? context_.editor.document().slot_of(place.sample) : SampleSlot(kNoSlot);
}

Vec2 MeasureTool::position_of(const Place& place) const {
  const SampleSlot slot = sample_of(place);
  return slot == kNoSlot ? place.at : context_.editor.document().position(slot);
}

void MeasureTool::press(const Pointer& pointer) {
  if (places_.size() == kMostPlaces) places_.clear();
  now_ = place_at(pointer);
  places_.push_back(*now_);
  pressed_px_ = pointer.px;
}

void MeasureTool::drag(const Pointer& pointer) {
  now_ = place_at(pointer);
}

void MeasureTool::release(const Pointer& pointer) {
  if (!is_active()) return;
  now_ = place_at(pointer);
  const bool is_drag = distance(*pressed_px_, pointer.px) > kDragThresholdPx;
  if (is_drag && places_.size() < kMostPlaces) places_.push_back(*now_);
  pressed_px_.reset();
}

void MeasureTool::cancel() {
  if (!is_active()) return;
  places_.clear();
  pressed_px_.reset();
}

bool MeasureTool::clear() {
  const bool had = !places_.empty();
  places_.clear();
  return had;
}

ToolFeedback MeasureTool::feedback() const {
  ToolFeedback out;
  for (const Place& place : places_) out.measured.push_back(position_of(place));
  if (!now_) return out;
  out.hovered = sample_of(*now_);
  // The measurement of two points is shown until the pointer leaves the second one.
  const bool is_still_there = places_.size() > 1 && position_of(*now_) == position_of(places_.back());
  if (!places_.empty() && places_.size() < kMostPlaces && !is_still_there) out.measured.push_back(position_of(*now_));
  return out;
}

std::optional<Annotation> MeasureTool::measurement() const {
  if (places_.size() < 2 || is_active()) return std::nullopt;
  Annotation out{.kind = places_.size() == 2 ? AnnotationKind::distance : AnnotationKind::angle};
  const Document& document = context_.editor.document();
  for (const Place& place : places_) {
    Anchor& anchor = out.anchors.emplace_back(Anchor{.at = position_of(place)});
    if (const SampleSlot slot = sample_of(place); slot != kNoSlot)
      anchor.samples.push_back(document.id(slot).value - document.first_id().value);
  }
  return out;
}

}  // namespace mes
