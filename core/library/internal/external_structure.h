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

/// What all that are made of one specification have in common.
struct ExternalStructureSpec {
  std::string id;
  std::vector<std::string> inputs;         ///< without the settings
  std::vector<mes::Parameter> parameters;  ///< that it reads
  std::function<std::unique_ptr<Structure>()> make;
};

/// What it guarantees: what mes::Structure promises, as far as the experiment's `update` names the rows that it changed.
/// Nothing but `mes::GeometryError`, `mes::Cancelled` and `std::bad_alloc` leaves it.
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
  std::vector<double> values_;          // of the parameters, at the last computation
  std::size_t touched_ = 0;             // rows
  std::vector<mes::TableColumns> own_;  // as they were after the last update
  bool has_changes_ = false;            // an update made some, which its tables name
};

/// The inputs of a structure or a layer, and the settings among them if there are parameters.
std::vector<mes::Structure*> inputs_in(const mes::StructureSet& set, const std::vector<std::string>& ids,
                                       bool with_settings);

}  // namespace v1
}  // namespace mesecina
