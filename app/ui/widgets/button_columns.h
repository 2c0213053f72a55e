// SPDX-License-Identifier: GPL-3.0-or-later
// Square buttons below each other in as few columns as there is room for.
#pragma once

#include <cstddef>

#include "imgui.h"

namespace mes {

inline constexpr float kButtonGap = 2.0F;  ///< logical pixels

/// The size of buttons in logical pixels, with lines between their groups: buttons become smaller before there are two
/// columns, and again before there are three. `room`: the height for them.
float column_button_size(std::size_t buttons, std::size_t lines, float room);

/// Places buttons of `size` from `origin` on, at most `room` below each other, and draws lines between groups. Sizes are
/// in screen coordinates, the origin in those of the window; `unit`: the length of a logical pixel.
class ButtonColumns {
 public:
  ButtonColumns(ImVec2 origin, float size, float unit, float room)
      : origin_(origin), size_(size), gap_(kButtonGap * unit), room_(room) {}

  /// Sets the cursor to the position of the next button.
  void next(bool begins_group);
  /// The same without drawing, to measure. Returns whether there is a line above the button.
  bool advance(bool begins_group);
  /// The width of the columns so far.
  float width() const { return x_ + size_; }

 private:
  ImVec2 origin_;
  float size_;
  float gap_;
  float room_;
  float x_ = 0.0F;
  float y_ = 0.0F;    // of the present button
  float end_ = 0.0F;  // of its column
};

}  // namespace mes
