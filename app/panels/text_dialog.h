// SPDX-License-Identifier: GPL-3.0-or-later
// "Write a text": the text, its font, and the samples of its outlines.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/sampling_controls.h"
#include "app/ui/dialog.h"
#include "core/glyphs/text_outlines.h"
#include "core/shapes/shape.h"

namespace mes {

/// Threads: the window's.
class TextDialog final : public Dialog {
 public:
  /// What is done with the samples: called with a name for the step.
  using Make = std::function<void(const SampleData&, const std::string& name)>;
  void set_make(Make make) { make_ = std::move(make); }
  /// The font of the program, first in the list; it has none where this is not set.
  void set_own_font(FontFile font) { own_font_ = std::move(font); }

  /// As it was when it was closed.
  void open();

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;
  /// Enter makes the samples, unless something is being typed.
  void press(const KeyChord& chord) override;

 private:
  void draw_fonts(const Gui& gui);
  void draw_settings(const Gui& gui);
  void draw_facts(const Gui& gui) const;
  void draw_buttons(const Gui& gui);
  /// Computes it again if something is another than before.
  void follow();
  Expected<FontFile> font() const;

  struct Wish {
    std::string family;  // empty: the program's own
    bool is_bold = false;
    bool is_italic = false;
    TextRequest request{};
    ShapeSampling sampling{};
    friend bool operator==(const Wish&, const Wish&) = default;
  };

  Make make_;
  std::optional<FontFile> own_font_;
  std::vector<std::string> families_;
  std::string filter_;
  Wish wish_{.family = {}, .request = {.text = "Mesecina"}};
  SamplingControls sampling_;
  bool is_open_ = false;
  bool is_accepted_ = false;
  std::optional<Wish> made_for_;
  std::optional<Expected<SampleData>> made_;
  std::vector<std::string> remarks_;
};

}  // namespace mes
