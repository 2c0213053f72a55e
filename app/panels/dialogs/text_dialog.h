// SPDX-License-Identifier: GPL-3.0-or-later
// "Write a text": the text, its font, and the samples of its outlines.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/dialogs/sample_maker.h"
#include "app/panels/dialogs/sampling_controls.h"
#include "app/system/waker.h"
#include "app/ui/dialogs/dialog.h"
#include "core/glyphs/text_outlines.h"
#include "core/shapes/shape.h"

namespace mes {

/// Threads: the window's.
class TextDialog final : public Dialog {
 public:
  /// Sets the receiver of the samples, and the waker of the window.
  void set_uses(SampleMaker::Make make, Waker wake) { maker_.set_uses(std::move(make), std::move(wake)); }
  /// Sets the font of the program, which is first in the list; without it the list has only the system's fonts.
  void set_own_font(FontFile font) { own_font_ = std::move(font); }

  /// Opens in the state in which it was closed.
  void open();

  bool is_open() const override { return is_open_; }
  void cancel() override {
    is_open_ = false;
    maker_.stop();
    wished_for_.reset();
  }
  void follow() override { maker_.follow(); }
  void draw(const Gui& gui) override;
  /// Enter makes the samples, unless the user is typing.
  void press(const KeyChord& chord) override;

 private:
  void draw_fonts(const Gui& gui);
  void draw_settings(const Gui& gui);
  /// Requests the samples again if something has changed.
  void follow_wish();

  struct Wish {
    std::string family;  // empty: the program's own font
    bool is_bold = false;
    bool is_italic = false;
    TextRequest request{};
    ShapeSampling sampling{};
    friend bool operator==(const Wish&, const Wish&) = default;
  };

  std::optional<FontFile> own_font_;
  std::vector<std::string> families_;
  std::string filter_;
  Wish wish_{.family = {}, .request = {.text = "Mesecina"}};
  SamplingControls sampling_;
  SampleMaker maker_;
  bool is_open_ = false;
  bool takes_keyboard_ = false;  // the text field, when the dialog opens
  bool writes_ = false;          // the text field has the keyboard
  std::optional<Wish> wished_for_;
};

}  // namespace mes
