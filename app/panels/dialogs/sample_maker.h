// SPDX-License-Identifier: GPL-3.0-or-later
// The common part of the dialogs that make samples: facts, preview and buttons.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/editing/curves/sample_making.h"
#include "app/system/waker.h"
#include "app/ui/dialogs/large_dialog.h"

namespace mes {

/// Smallest use, in each frame, after `follow` in each turn:
///     if (wish != wished)
///       maker.want([wish](JobControl& job) { return SampleMaking::Made{sample_curves(curves, wish, &job)}; });
///     const DialogColumn columns[] = {{"settings", 300, [&] { maker.draw_facts(gui); }},
///                                     {"preview", 0, [&] { maker.draw_preview(gui); }}};
///     dialog_columns(gui, columns, maker.foot(gui, "Circle", "The shape ...", [&] { is_open = false; }));
///
/// Threads: the window's.
class SampleMaker {
 public:
  /// Receives the samples with a name for the step.
  using Make = std::function<void(const SampleData&, const std::string& name)>;

  /// Must be called before any other member.
  void set_uses(Make make, Waker wake);

  /// Takes finished samples.
  void follow() { making_->follow(); }
  void want(SampleMaking::Call call) { making_->want(std::move(call)); }
  /// Same as the button, e.g. for the key Enter.
  void accept() { making_->accept(); }
  void stop() { making_->stop(); }

  void draw_facts(const Gui& gui) const;
  /// The buttons of the dialog; `close` is called when samples were made, or it was cancelled.
  DialogFoot foot(const Gui& gui, const std::string& name, const char* explanation, std::function<void()> close);
  void draw_preview(const Gui& gui) const;

 private:
  bool draw_buttons(const Gui& gui, ButtonRows& buttons, const std::string& name, const char* explanation);

  Make make_;
  std::optional<SampleMaking> making_;
};

}  // namespace mes
