// SPDX-License-Identifier: GPL-3.0-or-later
// A narrow band below a slider, with marks at the values of events.
#pragma once

#include <string>

#include "app/ui/screen/gui.h"
#include "app/ui/widgets/slider.h"
#include "core/base/color.h"

namespace mes {

/// An item of Dear ImGui, constructed in each frame at the cursor.
///
/// Smallest use:
///     MarkBand band(gui, "events", 200.0F, 12.0F);
///     const Event* pointed_at = nullptr;
///     for (const Event& event : events)
///       if (band.mark(x_of(event), palette::green)) pointed_at = &event;
///     if (pointed_at != nullptr && band.is_clicked()) go_to(*pointed_at);
class MarkBand {
 public:
  /// Sizes are in screen coordinates.
  MarkBand(const Gui& gui, const char* id, float width, float height);

  /// The track of a slider above the band that has the same width.
  SliderTrack track() const { return {at_.x, size_.x}; }
  /// Draws a mark at screen position `x`. Returns true if the pointer is near, and nearest to this mark of all so
  /// far.
  bool mark(float x, Rgb color, float thickness = 1.0F);
  bool is_clicked() const { return is_clicked_; }
  /// Draws a small triangle at the present value of the slider.
  void show_value(float x) const;
  void explain(const std::string& words) const;

 private:
  const Gui& gui_;
  ImVec2 at_;
  ImVec2 size_;
  bool is_clicked_;
  bool is_hovered_;
  float nearest_;
};

}  // namespace mes
