// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/internal/external_structure.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace mesecina {
inline namespace v1 {
namespace {

/// The program's table with the same rows as a table of the experiment; null if there is no such table.
std::shared_ptr<mes::TableColumns> rows_behind(Inputs::Impl& read, const mes::TableColumns& table) {
  if (table.rows_of.empty()) return nullptr;
  try {
    return std::make_shared<mes::TableColumns>(read.find(table.rows_of));
  } catch (const Error&) {
    return nullptr;  // the table belongs to no input
  }
}

}  // namespace

std::vector<mes::Structure*> inputs_in(const mes::StructureSet& set, const std::vector<std::string>& ids,
                                       bool with_settings) {
  std::vector<mes::Structure*> out;
  for (const std::string& id : ids) {
    out.push_back(set.find(id));
    MES_ASSERT(out.back() != nullptr);
  }
  if (with_settings) out.push_back(&set.get<mes::SettingsSource>());
  return out;
}

ExternalStructure::ExternalStructure(std::shared_ptr<const ExternalStructureSpec> spec, const mes::StructureSet& set)
    : mes::Structure(spec->id, inputs_in(set, spec->inputs, !spec->parameters.empty())),
      spec_(std::move(spec)),
      theirs_(shielded([&] { return spec_->make(); })) {
  if (!theirs_) throw mes::GeometryError("it makes no structure");
  for (const mes::Structure* input : inputs()) read_.structures.push_back(input);
  if (!spec_->parameters.empty()) read_.settings = settings_ = &set.get<mes::SettingsSource>();
  read_.parameters = spec_->parameters;
}

void ExternalStructure::keep_parameters() {
  values_.clear();
  for (const mes::Parameter& parameter : spec_->parameters) values_.push_back(settings_->current()[parameter]);
}

bool ExternalStructure::may_update() const {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i] != settings_->current()[spec_->parameters[i]]) return false;
  return true;
}

void ExternalStructure::rebuild(mes::JobControl& job) {
  has_changes_ = false;
  touched_ = 0;
  read_.begin(&job);
  shielded([&] { theirs_->rebuild(Inputs(read_)); });
  read_.begin(nullptr);
  keep_parameters();
}

bool ExternalStructure::update(mes::JobControl& job) {
  if (!may_update()) return false;
  has_changes_ = false;
  touched_ = 0;
  // Only settings that it does not read have changed.
  if (std::ranges::all_of(
          inputs(), [this](const mes::Structure* input) { return input == settings_ || input->touched() == 0; }))
    return true;
  read_.begin(&job);
  const bool is_done = shielded([&] { return theirs_->update(Inputs(read_)); });
  read_.begin(nullptr);
  if (!is_done) return false;
  has_changes_ = true;
  if (own_.empty() || !std::ranges::all_of(own_, [](const auto& table) { return static_cast<bool>(table.refresh); }))
    own_ = table_columns();
  else
    for (mes::TableColumns& table : own_) table.refresh(table);
  for (const mes::TableColumns& table : own_)
    touched_ += table.changes ? table.changes->touched.size() + table.changes->removed.size() : table.rows + 1;
  return true;
}

void ExternalStructure::clear_changes() {
  has_changes_ = false;
  touched_ = 0;
}

std::size_t ExternalStructure::touched() const {
  return touched_;
}

mes::StatList ExternalStructure::statistics() const {
  mes::StatList out;
  try {
    for (Statistic& statistic : theirs_->statistics())
      out.push_back({std::move(statistic.key), std::move(statistic.value)});
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    out.clear();  // a failing experiment has no statistics
  }
  return out;
}

std::vector<mes::TableColumns> ExternalStructure::table_columns() const {
  std::vector<mes::TableColumns> out;
  // Layers that are drawn in parallel call this.
  Inputs::Impl read;
  read.structures = read_.structures;
  try {
    for (OwnTable& own : theirs_->tables()) {
      const std::shared_ptr<const OwnTable::Impl> impl = OwnTableAccess::take(own);
      const std::shared_ptr<mes::TableColumns> behind = rows_behind(read, impl->table);
      mes::TableColumns& table = out.emplace_back(impl->table);
      if (behind) table.kind = behind->kind;
      if (impl->alive != nullptr)
        table.is_alive = [flags = impl->alive](mes::RowNumber row) { return (*flags)[row] != 0; };
      else if (behind)
        table.is_alive = behind->is_alive;
      else
        table.is_alive = [](mes::RowNumber) { return true; };
      const auto refresh = [this, impl, behind](mes::TableColumns& to) {
        impl->refresh(to, has_changes_);
        // The rows that are alive in the other table are those alive here.
        if (!behind || impl->alive != nullptr) return;
        if (behind->refresh) behind->refresh(*behind);
        to.rows = std::min(to.rows, behind->rows);
      };
      refresh(table);
      if (!behind || impl->alive != nullptr || behind->refresh) table.refresh = refresh;
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    out.clear();
  }
  return out;
}

std::vector<std::string_view> ExternalStructure::parameters() const {
  std::vector<std::string_view> out;
  for (const mes::Parameter& parameter : spec_->parameters) out.push_back(parameter.id);
  return out;
}

void ExternalStructure::find(std::vector<mes::Finding>& out) const {
  try {
    for (const Finding& finding : theirs_->findings()) {
      mes::Finding added;
      added.level = static_cast<mes::FindingLevel>(finding.level);
      added.text = one_line(finding.text);
      added.count = finding.count;
      for (const Point& place : finding.places)
        if (added.places.size() < mes::kMostPlaces) added.places.push_back({place.x, place.y});
      out.push_back(std::move(added));
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    // A failing experiment has no further findings.
  }
}

}  // namespace v1
}  // namespace mesecina
