// SPDX-License-Identifier: GPL-3.0-or-later
// What lies over the window and takes all keys until it is answered.
#pragma once

#include "app/actions/key_chord.h"
#include "app/ui/gui.h"

namespace mes {

/// Threads: the window's.
class Dialog {
 public:
  Dialog() = default;
  virtual ~Dialog() = default;
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;

  virtual bool is_open() const = 0;
  /// Closes it without an answer.
  virtual void cancel() = 0;
  /// To be called in each turn, drawn or not: takes what was made aside. One that lies below another is not drawn.
  virtual void follow() {}
  /// To be called in each frame, open or not. An answer is acted on before it returns.
  virtual void draw(const Gui& gui) = 0;
  /// A key that does not cancel it.
  virtual void press(const KeyChord& /*chord*/) {}
  /// The keys that cancel it.
  virtual bool is_cancelled_by(const KeyChord& chord) const { return chord.symbol == key::escape; }
};

}  // namespace mes
