// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of the computation while the window is open, and a parameter that runs through its values.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "app/insight/parameter_animation.h"
#include "core/document/computation_settings.h"
#include "core/engine/engine.h"
#include "core/graph/live_registry.h"

namespace mes {

/// What it guarantees: the engine hears of each change of the settings, whose parameters are those of the registry; an
/// animated parameter takes one step for each complete picture, no more than its speed allows, and has its value back at
/// the end. Threads: the window's.
class ComputationControl {
 public:
  /// The engine outlives it.
  ComputationControl(LiveRegistry registry, Engine& engine) : registry_(std::move(registry)), engine_(engine) {}
  /// To be called when the registry was replaced. A parameter at its default has the new default, and other values are
  /// brought into the new range. The value of a parameter that is gone is kept for when it comes back.
  void follow_registry();

  /// All parameters that the settings can have.
  std::span<const Parameter> parameters() const { return registry_.now().parameters(); }

  const ComputationSettings& settings() const { return settings_; }
  void set(const ComputationSettings& settings);
  void set(const Parameter& parameter, double value);

  ParameterAnimation& animation() { return animation_; }
  /// Begins the animation. When it has come to its end, its parameter has the value of now again.
  void start_animation();
  /// Ends the animation there.
  void give_back();
  /// Once a frame in which the picture is complete; true when the animation took a step.
  bool advance(double now);
  /// When the next step of the animation is due, in seconds from `now`; nothing while none runs.
  std::optional<double> next_due(double now) const;

 private:
  LiveRegistry registry_;
  Engine& engine_;
  ComputationSettings settings_{};
  ParameterAnimation animation_{};
  double next_step_ = 0.0;  // of the animation, in seconds
  double before_ = 0.0;     // value of its parameter before it began
};

}  // namespace mes
