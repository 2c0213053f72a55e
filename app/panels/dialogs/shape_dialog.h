// SPDX-License-Identifier: GPL-3.0-or-later
// "Make a shape": choice of the shape, its parameters, and a preview.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/panels/dialogs/sample_maker.h"
#include "app/panels/dialogs/sampling_controls.h"
#include "app/system/waker.h"
#include "app/ui/dialogs/dialog.h"
#include "core/graph/live_registry.h"
#include "core/shapes/shape.h"

namespace mes {

/// Threads: the window's.
class ShapeDialog final : public Dialog {
 public:
  /// Sets the registry, whose shapes are listed, the receiver of the samples, and the waker of the window.
  void set_uses(LiveRegistry registry, SampleMaker::Make make, Waker wake) {
    registry_ = std::move(registry);
    maker_.set_uses(std::move(make), std::move(wake));
  }

  /// Opens in the state in which it was closed. Stays closed if there are no shapes.
  void open();

  bool is_open() const override { return is_open_; }
  void cancel() override {
    is_open_ = false;
    maker_.stop();
    wished_for_.reset();
  }
  void follow() override { maker_.follow(); }
  void draw(const Gui& gui) override;
  /// Enter makes the shape, and arrow keys choose one, unless the user is typing.
  void press(const KeyChord& chord) override;

 private:
  void draw_list(const Gui& gui);
  void draw_parameters(const Gui& gui);
  /// Requests the samples again if a parameter has changed.
  void follow_wish();
  std::span<const std::shared_ptr<const ShapeDescriptor>> shapes() const { return registry_->now().shapes().all(); }
  /// Takes the shape of the chosen id from the present registry, or its first one. Returns false if there is none.
  bool follow_registry();

  struct Choice {
    std::shared_ptr<const ShapeDescriptor> shape;
    ShapeValues values;
  };
  std::optional<LiveRegistry> registry_;
  bool is_open_ = false;
  std::string chosen_id_;                  // id of a shape
  std::map<std::string, Choice> choices_;  // by id of the shape
  Choice* chosen_ = nullptr;               // points into `choices_`; null before the first choice
  SamplingControls sampling_;
  SampleMaker maker_;
  std::optional<ShapeRequest> wished_for_;
  std::shared_ptr<const ShapeDescriptor> wished_of_;
};

}  // namespace mes
