// SPDX-License-Identifier: GPL-3.0-or-later
// A structure of an experiment as a node of the graph.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <mesecina/experiment.h>

#include "core/graph/structure.h"
#include "core/library/internal/inputs.h"

namespace mesecina {
inline namespace v1 {

/// Shared by all structures made from one specification.
struct ExternalStructureSpec {
  std::string id;
  std::vector<std::string> inputs;         ///< without the settings
  std::vector<mes::Parameter> parameters;  ///< parameters that it reads
  std::function<std::unique_ptr<Structure>()> make;
};

/// Guarantees: everything that mes::Structure promises, provided that the experiment's `update` reports all
/// rows that it changed. Throws only `mes::GeometryError`, `mes::Cancelled` and `std::bad_alloc`.
class ExternalStructure final : public mes::Structure {
 public:
  ExternalStructure(std::shared_ptr<const ExternalStructureSpec> spec, const mes::StructureSet& set);

  void rebuild(mes::JobControl& job) override;
  bool update(mes::JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override;
  mes::StatList statistics() const override;
  std::vector<mes::TableColumns> table_columns() const override;
  std::vector<std::string_view> parameters() const override;
  void find(std::vector<mes::Finding>& out) const override;

 private:
  bool may_update() const;
  void keep_parameters();

  std::shared_ptr<const ExternalStructureSpec> spec_;
  const mes::SettingsSource* settings_ = nullptr;
  std::unique_ptr<v1::Structure> theirs_;
  Inputs::Impl read_;
  std::vector<double> values_;          // parameter values at the last computation
  std::size_t touched_ = 0;             // number of touched rows
  std::vector<mes::TableColumns> own_;  // as of the last update
  bool has_changes_ = false;            // the last update made changes, reported by its tables
};

/// The inputs of a structure or a layer, including the settings if it has parameters.
std::vector<mes::Structure*> inputs_in(const mes::StructureSet& set, const std::vector<std::string>& ids,
                                       bool with_settings);

}  // namespace v1
}  // namespace mesecina
