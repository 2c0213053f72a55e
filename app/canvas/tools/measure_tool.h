// SPDX-License-Identifier: GPL-3.0-or-later
// Click two points, or drag from one to the other, to measure their distance; a third one adds angle and circle.
#pragma once

#include <vector>

#include "app/canvas/tools/tool.h"

namespace mes {

/// Guarantees: the document does not change. A point on a sample follows the sample, also when another tool, undo or
/// an evolution moves it; once the sample is deleted, the point returns to where it was clicked. A fourth click
/// starts a new measurement.
class MeasureTool final : public Tool {
 public:
  using Tool::Tool;
  void press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool is_active() const override { return pressed_px_.has_value(); }
  void hover(const Pointer& pointer) override { now_ = place_at(pointer); }
  void leave() override { now_.reset(); }
  bool clear() override;
  ToolFeedback feedback() const override;
  std::optional<Annotation> measurement() const override;
  PointerShape pointer_shape() const override { return PointerShape::crosshair; }
  std::string_view hint() const override {
    return "Click two points for their distance, a third for angle and circle; K keeps them, Esc clears";
  }

 private:
  static constexpr std::size_t kMostPlaces = 3;
  struct Place {
    Vec2 at{};
    SampleId sample;  ///< the sample on which it lies, if any
  };
  Place place_at(const Pointer& pointer) const;
  SampleSlot sample_of(const Place& place) const;
  Vec2 position_of(const Place& place) const;

  std::vector<Place> places_;
  std::optional<Place> now_;        // the point under the pointer
  std::optional<Vec2> pressed_px_;  // where the button went down; empty while it is up
};

}  // namespace mes
