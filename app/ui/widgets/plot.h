// SPDX-License-Identifier: GPL-3.0-or-later
// A frame with axes and round numbers around the diagrams of panels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/ui/widgets/widgets.h"

namespace mes {

struct PlotAxis {
  double low = 0.0;
  double high = 1.0;
  std::string title{};
  bool is_root = false;  ///< positions are square roots, so that small numbers have more room; then `low` is 0
  /// A vertical axis: the label of a line above the numbers, for values beyond them; empty: only room for words.
  std::optional<std::string> above{};
};

struct PlotTick {
  double value = 0.0;
  std::string text{};
  friend bool operator==(const PlotTick&, const PlotTick&) = default;
};
/// Round numbers of the axis, each of which differs from its neighbours and is at least `apart` from them on an axis of
/// this length.
std::vector<PlotTick> plot_ticks(const PlotAxis& axis, double length, double apart);

/// Lays out a diagram in an area, in screen coordinates. Cost: O(numbers at the axes). Threads: the window's.
class Plot {
 public:
  /// The diagram is black on white, as on paper, in dark panels too. `is_large`: with larger letters and margins.
  Plot(const Gui& gui, const PanelArea& area, PlotAxis x, PlotAxis y, bool is_large);

  /// Draws ground, grid, numbers and titles.
  void draw_frame(ImDrawList& list) const;

  // Positions beyond the axes are moved to their ends.
  float x_of(double value) const;
  float y_of(double value) const;
  double x_at(float position) const;
  const PanelArea& inside() const { return inside_; }
  /// The middle of the room above the numbers, and the upper end of the diagram with it.
  float above() const { return inside_.at.y - 0.5F * room_above_; }
  float top() const { return inside_.at.y - room_above_; }
  static constexpr ImU32 kInk = IM_COL32(0, 0, 0, 255);
  static constexpr ImU32 kQuietInk = IM_COL32(90, 90, 90, 255);  ///< numbers and helping lines

 private:
  const Gui& gui_;
  PanelArea area_;
  PlotAxis x_;
  PlotAxis y_;
  bool is_large_;
  ImFont* font_;
  float room_above_ = 0.0F;
  PanelArea inside_;
  std::vector<PlotTick> x_ticks_;
  std::vector<PlotTick> y_ticks_;
};

}  // namespace mes
