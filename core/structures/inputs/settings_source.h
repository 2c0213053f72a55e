// SPDX-License-Identifier: GPL-3.0-or-later
// The user's settings for computations: a source of the graph like the data, so that changing a setting is an edit.
#pragma once

#include <optional>

#include "core/document/settings/computation_settings.h"
#include "core/graph/source_structure.h"

namespace mes {

/// Consumers list it as an input and compare the settings that they use: `update` is called on every change.
class SettingsSource final : public SourceStructure {
 public:
  SettingsSource() : SourceStructure("settings") {}

  void post(const ComputationSettings& settings) { pending_ = settings; }
  bool is_of_document() const override { return false; }
  bool has_pending() const override { return pending_.has_value() && *pending_ != current_; }
  const ComputationSettings& current() const { return current_; }
  Precision precision() const { return current_.precision; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { touched_ = 0; }
  std::size_t touched() const override { return touched_; }
  StatList statistics() const override;

 private:
  ComputationSettings current_;
  std::optional<ComputationSettings> pending_;
  std::size_t touched_ = 0;
};

}  // namespace mes
