// SPDX-License-Identifier: GPL-3.0-or-later
// Presentation mode: shows pressed keys, and a large pointer while it moves.
#pragma once

#include <optional>
#include <string>

#include "app/panels/on_canvas/note_room.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Guarantees: both marks fade some time after the last motion or key, and then require no more frames. Times are
/// seconds of one clock. Threads: the window's.
class Presenter {
 public:
  bool is_on() const { return is_on_; }
  void set_on(bool on);
  /// Notes that a key had an effect: its name, or whether it changed the slide. Keys between two frames count for the
  /// later one: the clock of the interface stops while the window sleeps.
  void note_key(std::string key, std::string meaning, bool leads_to_slide);
  bool shows_slide() const { return shows_slide_; }
  void note_pointer() { has_moved_ = true; }
  /// True if the pointer has faded: then no element is highlighted under it either.
  bool hides_pointer(double now) const;

  /// Draws over everything; `bundle`: the slide that is shown. A key appears where it hides least, of equal places in
  /// the middle of the lower edge, and stays there.
  void draw(const Gui& gui, const std::string& bundle, const NoteRoom& room, double now);
  /// Ends both marks at once.
  void end_marks();
  /// Seconds until a mark begins to fade; 0 while one fades; nothing when none is left.
  std::optional<double> next_due(double now) const;

 private:
  bool is_on_ = false;
  bool shows_slide_ = false;
  bool has_pressed_ = false;  ///< true since the last frame
  bool has_moved_ = false;
  std::string key_;
  std::string meaning_;
  std::optional<double> key_at_;
  std::optional<NotePlace> place_;  ///< of the present key
  std::optional<double> pointer_at_;
};

}  // namespace mes
