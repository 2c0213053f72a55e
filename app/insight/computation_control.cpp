// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/computation_control.h"

namespace mes {

void ComputationControl::follow_registry() {
  if (registry_.now().find_parameter(animation_.parameter.id) == nullptr) give_back();
  ComputationSettings settings = settings_;
  settings.values = ParameterValues(settings_.values.changed());
  for (const Parameter& parameter : parameters()) settings[parameter] = within(parameter, settings[parameter]);
  set(settings);
}

// Indexing by the parameter turns a value that was read by id alone into one of the parameter.
void ComputationControl::set(const ComputationSettings& settings) {
  settings_ = settings;
  for (const Parameter& parameter : parameters()) static_cast<void>(settings_[parameter]);
  engine_.set_settings(settings_);
}

void ComputationControl::set(const Parameter& parameter, double value) {
  ComputationSettings settings = settings_;
  settings[parameter] = value;
  set(settings);
}

void ComputationControl::start_animation() {
  before_ = settings_[animation_.parameter];
  animation_.start();
}

void ComputationControl::give_back() {
  if (!animation_.is_running()) return;
  animation_.stop();
  set(animation_.parameter, before_);
}

bool ComputationControl::advance(double now) {
  if (!animation_.is_running()) return false;
  if (animation_.position() > 0 || settings_[animation_.parameter] == animation_.value()) {
    if (now < next_step_) return false;
    if (!animation_.advance()) {
      set(animation_.parameter, before_);
      return true;
    }
  }
  next_step_ = now + 1.0 / animation_.steps_per_second;
  set(animation_.parameter, animation_.value());
  return true;
}

std::optional<double> ComputationControl::next_due(double now) const {
  return animation_.is_running() ? std::optional(next_step_ - now) : std::nullopt;
}

}  // namespace mes
