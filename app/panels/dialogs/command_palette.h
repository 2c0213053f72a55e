// SPDX-License-Identifier: GPL-3.0-or-later
// The palette: finds every possible action by some letters of its name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/actions/palette.h"
#include "app/ui/dialogs/dialog.h"
#include "app/ui/dialogs/name_field.h"

namespace mes {

/// Arrows, page keys and Tab move the mark, Enter or a click runs the marked entry, Esc or a click beside it closes.
/// Entries that are not possible now stay in the list, in grey. The palette closes before an entry runs.
class CommandPalette final : public Dialog {
 public:
  using Source = std::function<std::vector<PaletteEntry>()>;

  /// Sets the source of the entries, which is called each time the palette opens.
  void set_source(Source source) { source_ = std::move(source); }
  void toggle();

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;
  void press(const KeyChord& chord) override;

 private:
  void draw_field(const Gui& gui);
  /// Returns the row that was clicked, or nothing.
  std::optional<std::size_t> draw_rows(const Gui& gui, float height);
  bool draw_row(const Gui& gui, std::size_t row);
  void draw_foot(const Gui& gui) const;

  Source source_;
  PaletteList list_;
  NameField field_;
  std::string query_;
  bool is_open_ = false;
  bool is_accepted_ = false;
  bool follows_mark_ = false;  // the mark was moved by keys: scroll to it
};

}  // namespace mes
