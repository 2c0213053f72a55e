// SPDX-License-Identifier: GPL-3.0-or-later
// Icons for buttons, drawn as lines, so that they are sharp at every scale.
#pragma once

#include <cstdint>

#include "imgui.h"

namespace mes {

enum class Icon : std::uint8_t {
  select,
  insert,
  spray,
  brush,
  ball,
  measure,
  annotate,
  fit,
  undo,
  redo,
  eye,
  eye_closed,
  close,
  grip,
  help,
  layers,
  statistics,
  parameters,
  play,
  pause,
  record,
  snapshot,
  more,
  play_back,
  step_forward,
  step_back,
  to_start,
  stop,
  evolution,
  bundles,
  selection,
  curves,
  sampling,
  branches,
  persistence,
  experiments,
  lesson,
  log,
  pin,
  pinned,
  enlarge,
  star,
  star_on
};

/// Draws the icon into the square `size` wide at `at`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 color);

/// Draws a triangle that points down at unfolded content, or right at folded content; `size` is half its side.
void draw_fold(ImDrawList& list, ImVec2 middle, float size, bool is_unfolded, ImU32 color);

enum class ButtonLook : std::uint8_t {
  plain,
  chosen,  ///< the one in use of several
  on,      ///< a switch that is on
};

/// Draws a square button with an icon. Returns true when it is clicked.
bool icon_button(const char* id, Icon icon, float size, ButtonLook look = ButtonLook::plain, bool enabled = true);

/// Draws a button for one of several words side by side, as wide as the word unless a width is given; the chosen one
/// stands out. Returns true when it is clicked.
bool choice_button(const char* label, bool chosen, float width = 0.0F);

}  // namespace mes
