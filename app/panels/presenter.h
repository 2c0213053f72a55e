// SPDX-License-Identifier: GPL-3.0-or-later
// The window before an audience: what is pressed is shown, and the pointer is large while it moves.
#pragma once

#include <optional>
#include <string>

#include "app/ui/gui.h"

namespace mes {

/// What it guarantees: both marks fade a while after the last motion or key, and after that no frame is wanted for
/// them. Times are seconds of one clock. Threads: the window's.
class Presenter {
 public:
  bool is_on() const { return is_on_; }
  void set_on(bool on);
  /// A key did something: what it is called, or whether it led to another slide. What is noted between two frames
  /// happened at the later one: the clock of the interface stands while the window sleeps.
  void note_key(std::string key, std::string meaning, bool leads_to_slide);
  bool shows_slide() const { return shows_slide_; }
  void note_pointer() { has_moved_ = true; }
  /// True if the pointer has faded: nothing lights up under it either.
  bool hides_pointer(double now) const;

  /// Over everything; `bundle`: the slide that is shown.
  void draw(const Gui& gui, const std::string& bundle, double now);
  /// Seconds until something begins to fade; 0 while it fades; nothing when all is gone.
  std::optional<double> next_due(double now) const;

 private:
  bool is_on_ = false;
  bool shows_slide_ = false;
  bool has_pressed_ = false;  ///< since the last frame
  bool has_moved_ = false;
  std::string key_;
  std::string meaning_;
  std::optional<double> key_at_;
  std::optional<double> pointer_at_;
};

}  // namespace mes
