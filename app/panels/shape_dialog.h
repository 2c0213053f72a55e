// SPDX-License-Identifier: GPL-3.0-or-later
// "Make a shape": which one, its parameters, and what it will be.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/sample_maker.h"
#include "app/panels/sampling_controls.h"
#include "app/ui/dialog.h"
#include "core/graph/registry.h"
#include "core/shapes/shape.h"

namespace mes {

/// Threads: the window's.
class ShapeDialog final : public Dialog {
 public:
  /// The shapes, which outlive it; what is done with the samples, and what wakes the window.
  void set_uses(const NamedList<ShapeDescriptor>& shapes, SampleMaker::Make make, std::function<void()> wake) {
    shapes_ = &shapes;
    maker_.set_uses(std::move(make), std::move(wake));
  }

  /// As it was when it was closed. Stays closed where there are no shapes.
  void open();

  bool is_open() const override { return is_open_; }
  bool is_busy() const { return maker_.is_busy(); }
  void cancel() override {
    is_open_ = false;
    maker_.stop();
    wished_for_.reset();
  }
  void follow() override { maker_.follow(); }
  void draw(const Gui& gui) override;
  /// Enter makes the shape, unless something is being typed.
  void press(const KeyChord& chord) override;

 private:
  void draw_list(const Gui& gui);
  void draw_parameters(const Gui& gui);
  /// Wishes for it again if a parameter is another than before.
  void follow_wish();
  const ShapeDescriptor& shape() const;

  const NamedList<ShapeDescriptor>* shapes_ = nullptr;
  bool is_open_ = false;
  std::size_t chosen_ = 0;
  std::vector<ShapeValues> values_;  // of each shape
  SamplingControls sampling_;
  SampleMaker maker_;
  std::optional<ShapeRequest> wished_for_;
  std::size_t wished_of_ = 0;  // index among the shapes
};

}  // namespace mes
