// SPDX-License-Identifier: GPL-3.0-or-later
// "Make a shape": which one, its parameters, and what it will be.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/sampling_controls.h"
#include "app/ui/dialog.h"
#include "core/shapes/shape.h"

namespace mes {

/// Threads: the window's.
class ShapeDialog final : public Dialog {
 public:
  /// What is done with the shape: called with its name.
  using Make = std::function<void(const SampleData&, const std::string& name)>;
  void set_make(Make make) { make_ = std::move(make); }

  /// As it was when it was closed.
  void open();

  bool is_open() const override { return is_open_; }
  void cancel() override { is_open_ = false; }
  void draw(const Gui& gui) override;
  /// Enter makes the shape, unless something is being typed.
  void press(const KeyChord& chord) override;

 private:
  void draw_list(const Gui& gui);
  void draw_parameters(const Gui& gui);
  void draw_facts(const Gui& gui) const;
  void draw_buttons(const Gui& gui);
  /// Computes it again if a parameter is another than before.
  void follow();
  const ShapeDescriptor& shape() const { return shapes()[chosen_]; }

  Make make_;
  bool is_open_ = false;
  bool is_accepted_ = false;
  std::size_t chosen_ = 0;
  std::vector<ShapeValues> values_;  // of each shape
  SamplingControls sampling_;
  std::optional<ShapeRequest> made_for_;
  std::size_t made_of_ = 0;  // place in `shapes()`
  std::optional<Expected<SampleData>> made_;
};

}  // namespace mes
