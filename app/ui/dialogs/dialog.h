// SPDX-License-Identifier: GPL-3.0-or-later
// A dialog over the window, which takes all keys until it is answered.
#pragma once

#include "app/actions/key_chord.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Threads: the window's.
class Dialog {
 public:
  Dialog() = default;
  virtual ~Dialog() = default;
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;

  virtual bool is_open() const = 0;
  /// Closes the dialog without an answer.
  virtual void cancel() = 0;
  /// Call it in each turn, drawn or not: takes results of background work. A dialog below another is not drawn.
  virtual void follow() {}
  /// Call it in each frame, open or not. Acts on an answer before it returns.
  virtual void draw(const Gui& gui) = 0;
  /// Handles a key that does not cancel the dialog.
  virtual void press(const KeyChord& /*chord*/) {}
  /// True for the keys that cancel the dialog.
  virtual bool is_cancelled_by(const KeyChord& chord) const { return chord.symbol == key::escape; }
};

}  // namespace mes
