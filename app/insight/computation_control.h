// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of the computation while the window is open, and a parameter that is animated through its values.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "app/insight/parameter_animation.h"
#include "core/document/settings/computation_settings.h"
#include "core/engine/engine.h"
#include "core/graph/live_registry.h"

namespace mes {

/// Guarantees: the engine gets each change of the settings, whose parameters are those of the registry. An animated
/// parameter takes one step per complete picture, no faster than its speed allows, and finally gets its old value
/// back. Threads: the window's.
class ComputationControl {
 public:
  /// The engine must outlive this object.
  ComputationControl(LiveRegistry registry, Engine& engine) : registry_(std::move(registry)), engine_(engine) {}
  /// Call it when the registry was replaced. A parameter at its default gets the new default, and other values are
  /// clamped to the new range. The value of a removed parameter is kept in case it returns.
  void follow_registry();

  /// All parameters of the settings.
  std::span<const Parameter> parameters() const { return registry_.now().parameters(); }

  const ComputationSettings& settings() const { return settings_; }
  void set(const ComputationSettings& settings);
  void set(const Parameter& parameter, double value);

  ParameterAnimation& animation() { return animation_; }
  /// Begins the animation. At its end the parameter returns to its present value.
  void start_animation();
  /// Ends the animation early and restores the value.
  void give_back();
  /// Call it once per frame in which the picture is complete; returns true when the animation took a step.
  bool advance(double now);
  /// Seconds from `now` until the next step of the animation; nothing while none runs.
  std::optional<double> next_due(double now) const;

 private:
  LiveRegistry registry_;
  Engine& engine_;
  ComputationSettings settings_{};
  ParameterAnimation animation_{};
  double next_step_ = 0.0;  // time of the next step of the animation, in seconds
  double before_ = 0.0;     // value of the animated parameter before the animation
};

}  // namespace mes
