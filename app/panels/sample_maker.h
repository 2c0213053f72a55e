// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialogs that make samples have in common: what the samples are, how they look, and the answer.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/editing/sample_making.h"
#include "app/system/waker.h"
#include "app/ui/gui.h"

namespace mes {

/// Smallest use, in each frame, after `follow` in each turn:
///     if (wish != wished)
///       maker.want([wish](JobControl& job) { return SampleMaking::Made{sample_curves(curves, wish, &job)}; });
///     maker.draw_facts(gui);
///     if (maker.draw_buttons(gui, "Circle", "The shape ...")) is_open = false;
///     maker.draw_preview(gui);
///
/// Threads: the window's.
class SampleMaker {
 public:
  /// What is done with the samples: called with a name for the step.
  using Make = std::function<void(const SampleData&, const std::string& name)>;

  /// Before all else.
  void set_uses(Make make, Waker wake);

  /// Takes what was made.
  void follow() { making_->follow(); }
  void want(SampleMaking::Call call) { making_->want(std::move(call)); }
  /// The key Enter, say.
  void accept() { making_->accept(); }
  void stop() { making_->stop(); }

  void draw_facts(const Gui& gui) const;
  /// True when the dialog is to be closed: samples were made, or it was cancelled.
  bool draw_buttons(const Gui& gui, const std::string& name, const char* explanation);
  void draw_preview(const Gui& gui) const;

 private:
  Make make_;
  std::optional<SampleMaking> making_;
};

}  // namespace mes
