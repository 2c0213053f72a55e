// SPDX-License-Identifier: GPL-3.0-or-later
// A slider beside a field in which its number can be typed.
#pragma once

#include <optional>

#include "app/ui/screen/gui.h"

namespace mes {

struct SliderLook {
  const char* format = "%.4g";  ///< format of the number, with its unit
  bool is_logarithmic = false;
  bool is_whole = false;
  double end = 0.0;    ///< above 0: end of a slider on which small numbers have more room; typed ones may be larger
  float width = 0.0F;  ///< width of slider and number together, in screen coordinates; 0: the free width
  struct Range {
    double low;
    double high;
  };
  std::optional<Range> typed{};  ///< range of typed numbers, if larger than that of the slider
  /// If given, it receives a typed number out of the range, and the nearest permitted number is taken. Otherwise such
  /// a number is refused at the field, with the reason.
  std::optional<double>* beyond = nullptr;
  bool takes_keyboard = false;  ///< the number can be typed at once, in place of the old one
};

/// The width of the slider itself, if it is `width` wide together with its number.
float slider_rail(const Gui& gui, float width);

/// The positions of the middle of the grip, from the least value to the largest, for a slider drawn from `left` on.
/// Marks of events on a slider belong there.
class SliderTrack {
 public:
  SliderTrack(float left, float width);
  /// Position at this share of the way, from 0 to 1.
  float at(double part) const { return from_ + length_ * static_cast<float>(part); }
  double part_at(float x) const;

 private:
  float from_;
  float length_;
};

/// `label` is shown after the number, without "##" and the text after it. The number stays within [low, high], or
/// within `typed`. Returns true when it has changed.
bool slider(const Gui& gui, const char* label, double& value, double low, double high, const SliderLook& look = {});

}  // namespace mes
