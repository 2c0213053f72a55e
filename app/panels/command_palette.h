// SPDX-License-Identifier: GPL-3.0-or-later
// A field and what fits to it: everything that can be done, by some letters of its name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/model/palette.h"
#include "app/ui/dialog.h"
#include "app/ui/name_field.h"

namespace mes {

/// Arrows, page keys and Tab move the mark, Enter or a click does what is marked, Esc or a click beside it closes. What
/// cannot be done now is listed in grey and stays in the list. It is closed before anything is done.
class CommandPalette final : public Dialog {
 public:
  using Source = std::function<std::vector<PaletteEntry>()>;

  /// Where the entries come from, asked each time it opens.
  void set_source(Source source) { source_ = std::move(source); }
  void toggle();

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;
  void press(const KeyChord& chord) override;

 private:
  void draw_field(const Gui& gui);
  /// The row that was clicked, or nothing.
  std::optional<std::size_t> draw_rows(const Gui& gui, float height);
  bool draw_row(const Gui& gui, std::size_t row);
  void draw_foot(const Gui& gui) const;

  Source source_;
  PaletteList list_;
  NameField field_;
  std::string query_;
  bool is_open_ = false;
  bool is_accepted_ = false;
  bool follows_mark_ = false;  // by keys: it is scrolled to
};

}  // namespace mes
