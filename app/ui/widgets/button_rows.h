// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons at the foot of a dialog.
#pragma once

#include <span>

#include "app/ui/screen/gui.h"

namespace mes {

/// Guarantees: all buttons have the same width, which is never smaller than their texts; there are as many rows as
/// they need.
///
/// Smallest use:
///     ButtonRows buttons(gui, kLabels, ImGui::GetContentRegionAvail().x);
///     ImGui::BeginChild("choices", {0, -buttons.height()});
///     ...
///     ImGui::EndChild();
///     if (buttons.next(true)) accept();
///     if (buttons.next()) cancel();
class ButtonRows {
 public:
  /// `room` and `wanted` are widths, in screen coordinates: of a row, and of a button whose text is narrower. Without a
  /// wanted width, the buttons fill their rows.
  ButtonRows(const Gui& gui, std::span<const char* const> labels, float room, float wanted = 0.0F);

  /// The height of all rows, each with the spacing above it.
  float height() const;
  /// The width of the longest row.
  float width() const;
  /// Draws the next button; Enter presses a default one. Returns true when it is clicked.
  bool next(bool is_default = false);

 private:
  const Gui& gui_;
  std::span<const char* const> labels_;
  float button_ = 0.0F;
  std::size_t in_row_ = 1;
  std::size_t drawn_ = 0;
};

}  // namespace mes
