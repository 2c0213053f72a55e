// SPDX-License-Identifier: GPL-3.0-or-later
// "Trace a picture": the choice of what becomes samples, with a preview of the outlines.
#pragma once

#include <functional>
#include <optional>

#include "app/store/trace_job.h"
#include "app/ui/dialogs/dialog.h"
#include "app/ui/widgets/button_rows.h"

namespace mes {

/// Threads: the window's.
class TraceDialog final : public Dialog {
 public:
  /// All members must outlive the dialog.
  struct Uses {
    TraceJob& job;
    std::function<ImTextureID()> texture;            ///< texture of the picture; null while there is none
    std::function<void(const TraceRequest&)> trace;  ///< traces the picture into samples
    std::function<void()> lay_underneath;
    std::function<void()> closed;  ///< called when closed without an answer
  };
  void set_uses(Uses uses) { uses_.emplace(std::move(uses)); }

  void open();
  /// Closes the dialog after an answer.
  void close() { is_open_ = false; }

  bool is_open() const override { return is_open_; }
  void cancel() override;
  void draw(const Gui& gui) override;
  /// Enter traces, unless a number is being typed.
  void press(const KeyChord& chord) override;

 private:
  /// Takes the defaults that the picture suggests once it has been read.
  void begin_choices();
  TraceRequest request() const;
  void draw_choices(const Gui& gui);
  void draw_facts(const Gui& gui);
  void draw_buttons(const Gui& gui, ButtonRows& buttons);
  void draw_preview(const Gui& gui);

  std::optional<Uses> uses_;
  bool is_open_ = false;
  bool is_accepted_ = false;
  std::uint64_t chosen_for_ = 0;  // number of the preview
  double threshold_ = 127.0;
  double specks_ = 16.0;
  FigureSide side_ = FigureSide::found;
};

}  // namespace mes
