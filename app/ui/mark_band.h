// SPDX-License-Identifier: GPL-3.0-or-later
// A narrow band below a slider, with marks at values where something happens.
#pragma once

#include <string>

#include "app/ui/gui.h"
#include "app/ui/slider.h"
#include "core/base/color.h"

namespace mes {

/// An item of Dear ImGui, made in each frame where the band is to be.
///
/// Smallest use:
///     MarkBand band(gui, "events", 200.0F, 12.0F);
///     const Event* pointed_at = nullptr;
///     for (const Event& event : events)
///       if (band.mark(x_of(event), palette::green)) pointed_at = &event;
///     if (pointed_at != nullptr && band.is_clicked()) go_to(*pointed_at);
class MarkBand {
 public:
  /// In screen coordinates.
  MarkBand(const Gui& gui, const char* id, float width, float height);

  /// Of a slider above the band that is as wide.
  SliderTrack track() const { return {at_.x, size_.x}; }
  /// Draws a mark at this place of the screen; true: the pointer is near, and nearest to this one of all so far.
  bool mark(float x, Rgb color, float thickness = 1.0F);
  bool is_clicked() const { return is_clicked_; }
  /// A small triangle at the value that the slider has.
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
