// SPDX-License-Identifier: GPL-3.0-or-later
// The manual of the program in its window, with a field that finds words and a list of its headings.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/actions/keymap.h"
#include "app/actions/manual_layout.h"
#include "app/actions/manual_text.h"
#include "app/ui/dialogs/dialog.h"
#include "app/ui/dialogs/name_field.h"
#include "core/graph/live_registry.h"

namespace mes {

/// Typing finds text; Enter goes to the next place and Shift+Enter to the one before. Arrows, page keys, Home and End
/// scroll, Ctrl with a page key goes to the next or last heading. Esc, a click beside the page, and the keys that open
/// it close it.
///
/// Cost: the text is written and read when it is shown first, and again when the registry has changed; it is laid out
/// when its width changes. A frame costs what it shows, whatever the length of the manual.
class ManualPage final : public Dialog {
 public:
  /// Writes the manual of a registry as Markdown.
  using Source = std::function<std::string(const Registry&)>;
  void set_source(Source source, LiveRegistry registry) {
    source_ = std::move(source);
    registry_.emplace(std::move(registry));
  }
  /// Sets the keys that close the page, which must outlive it.
  void set_keys(const Keymap& keymap) { keymap_ = &keymap; }

  const std::vector<ManualHeading>& headings();
  void toggle();
  /// Opens the manual at this heading, or as it was left if it no longer has that heading.
  void open_at(const std::string& section, const std::string& name);

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;
  void press(const KeyChord& chord) override;
  bool is_cancelled_by(const KeyChord& chord) const override;

 private:
  /// Brings the text up to date with the registry.
  void refresh();
  void draw_head(const Gui& gui, float width);
  void draw_headings(const Gui& gui, float width);
  void draw_text(const Gui& gui);
  void fit_layout(const Gui& gui, double width);
  void follow_keys(const Gui& gui);
  void draw_block(const Gui& gui, std::size_t block, ImVec2 corner) const;
  void draw_finds(const Gui& gui, std::size_t block, ImVec2 corner) const;
  void search();
  void step(int finds);
  /// The index of the last heading at or above the upper edge of the view.
  std::size_t present_heading() const;
  void jump_to_heading(std::size_t index);

  Source source_;
  std::optional<LiveRegistry> registry_;
  std::shared_ptr<const Registry> shown_registry_;
  const Keymap* keymap_ = nullptr;
  ManualText text_;
  std::vector<ManualHeading> headings_;
  ManualLayout layout_;
  double laid_out_width_ = 0.0;  // 0: not laid out
  double laid_out_unit_ = 0.0;
  bool had_letters_ = false;  // the large letters were loaded when the text was laid out

  NameField field_;
  std::string query_;
  std::string searched_;
  std::vector<ManualFind> finds_;
  std::size_t present_find_ = 0;
  int steps_ = 0;  // finds to go on by, once the field has taken what was typed before the key

  double scroll_ = 0.0;
  std::optional<double> scroll_to_;
  std::optional<std::size_t> jump_to_;  // block
  bool shows_find_ = false;             // scroll to the present find
  int lines_ = 0;                       // lines, pages and headings to scroll by
  int pages_ = 0;
  int sections_ = 0;
  std::optional<std::size_t> listed_;  // the heading that the list was scrolled to
  bool is_open_ = false;
};

}  // namespace mes
