// SPDX-License-Identifier: GPL-3.0-or-later
// A slider with its number beside it, where it can be typed.
#pragma once

#include <optional>

#include "app/ui/gui.h"

namespace mes {

struct SliderLook {
  const char* format = "%.4g";  ///< of the number, with its unit
  bool is_logarithmic = false;
  bool is_whole = false;
  double end = 0.0;    ///< above 0: of the slider, on which small numbers have more room; typed ones may be beyond
  float width = 0.0F;  ///< of slider and number together, in screen coordinates; 0: what is free
  struct Range {
    double low;
    double high;
  };
  std::optional<Range> typed{};  ///< what the number may be, where that is more than the slider has
  /// If given, gets a number that was typed and is not what it may be, and the nearest that it may be is taken; otherwise
  /// such a number is refused at the field, with the reason.
  std::optional<double>* beyond = nullptr;
};

/// How wide the slider itself is, of a slider that is `width` wide with its number.
float slider_rail(const Gui& gui, float width);

/// Where the middle of the grip is, from the least value to the largest, of a slider that is drawn from `left` on. Marks
/// that say where something happens on a slider belong there.
class SliderTrack {
 public:
  SliderTrack(float left, float width);
  /// `part` of the way, from 0 to 1.
  float at(double part) const { return from_ + length_ * static_cast<float>(part); }
  double part_at(float x) const;

 private:
  float from_;
  float length_;
};

/// `label` stands after the number; what follows "##" in it is not shown. The number stays within [low, high], or
/// within `typed`. Returns true when it has changed.
bool slider(const Gui& gui, const char* label, double& value, double low, double high, const SliderLook& look = {});

}  // namespace mes
