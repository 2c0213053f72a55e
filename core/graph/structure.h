// SPDX-License-Identifier: GPL-3.0-or-later
// A node of the geometry graph: owns tables, and keeps them consistent with its inputs.
//
// A structure promises:
//  1. After `rebuild` or `update` its tables are a function of its inputs' tables alone, up to the numbering of rows;
//     the history does not matter (tests compare the two after every step of random edit scripts).
//  2. After `update` its change sets name every row that differs from before the call, and only rows near the change.
//     After `rebuild` they are empty and every row counts as new.
//  3. It may throw `GeometryError` or `Cancelled`; its tables are then invalid until the next `rebuild`.
//
// In a one-shot graph (core/engine/graph.h), `forgo_updates` is called first, and `update` is never called.
//
// Calls come for inputs first, both methods on the engine's thread. `update` is called if this structure was up to date
// in the previous run and no changed input was rebuilt; it may return false to request `rebuild` instead. The change
// sets of an input that did not change in this run are empty.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry/finding.h"
#include "core/base/geometry/vec2.h"
#include "core/base/ids.h"
#include "core/base/jobs/job_control.h"
#include "core/base/stat.h"
#include "core/graph/element.h"

namespace mes {

class Explanation;
struct TableColumns;

class Structure {
 public:
  Structure(std::string_view id, std::vector<Structure*> inputs) : id_(id), inputs_(std::move(inputs)) {}
  virtual ~Structure() = default;
  Structure(const Structure&) = delete;
  Structure& operator=(const Structure&) = delete;

  /// Public name, kebab case.
  std::string_view id() const { return id_; }
  std::span<Structure* const> inputs() const { return inputs_; }

  /// Announces that `update` will never be called, so that data only for updates need not be made or kept.
  void forgo_updates() { forgoes_updates_ = true; }

  virtual void rebuild(JobControl& job) = 0;
  virtual bool update(JobControl& job) = 0;
  /// Called after a run that brought everything up to date, while the engine has no other work: prepares data that only
  /// an `update` needs. May throw `Cancelled` or `std::bad_alloc`; the tables do not change.
  virtual void get_ready_to_update(JobControl& /*job*/) {}
  virtual void clear_changes() = 0;
  /// Number of rows named by the change sets.
  virtual std::size_t touched() const = 0;
  /// Counters under their public names (snake case); may cost O(n).
  virtual StatList statistics() const = 0;
  /// Its tables as columns (core/graph/table_columns.h); empty if it has no rows. Called while the structure is up to
  /// date: columns point into it and into its inputs, and are valid until the next run. Tables that were never computed
  /// have no rows. O(columns).
  virtual std::vector<TableColumns> table_columns() const;
  /// Ids of the parameters that it reads from the settings itself. Other parameters do not affect it directly.
  virtual std::vector<std::string_view> parameters() const { return {}; }
  /// Name of the number type that decides in this structure, as in its documentation (a literal); empty if none does.
  virtual std::string_view kernel() const { return {}; }
  /// Adds doubts about the results. Called while the theorem light is visible; cheap if there is nothing to report.
  virtual void find(std::vector<Finding>& /*out*/) const {}
  /// Whether the theorem light depends on this structure.
  virtual bool is_judge() const { return false; }
  /// Whether a judge without findings has proved the theorem for this input.
  virtual bool has_verdict() const { return is_judge(); }
  /// Adds its information on a row to the explanation; nothing if the row is dead. Called while the structure is up to
  /// date: for its own rows, and for rows without an owner (core/graph/explain.h). The kind says which slot type the
  /// number belongs to.
  virtual void explain(ElementKind /*kind*/, RowNumber /*row*/, Explanation& /*out*/) const {}
  /// Adds the changes that a further sample, whose coordinates are finite, would cause in its tables; nothing at an
  /// existing sample. Called while the structure is up to date, inputs before consumers.
  virtual void explain_insertion(Vec2 /*at*/, Explanation& /*out*/) const {}

 protected:
  bool forgoes_updates() const { return forgoes_updates_; }

 private:
  std::string id_;
  std::vector<Structure*> inputs_;
  bool forgoes_updates_ = false;
};

/// All structures, inputs before consumers. Structures find their inputs by type.
///
/// The set of a variant (core/draw/variant.h) holds only the structures that differ, and finds the rest in another set.
class StructureSet {
 public:
  /// The shared set must outlive this one, at the same address; null: this set holds everything itself.
  explicit StructureSet(const StructureSet* shared = nullptr) : shared_(shared) {}

  template <class T>
  T& get() const {
    for (const auto& structure : structures_)
      if (typeid(*structure) == typeid(T)) return static_cast<T&>(*structure);
    if (shared_ != nullptr) return shared_->get<T>();
    assertion_failed("a structure is listed after its inputs", __FILE_NAME__, __LINE__);
  }
  /// Finds a structure by its id; null if there is none.
  Structure* find(std::string_view id) const {
    for (const auto& structure : structures_)
      if (structure->id() == id) return structure.get();
    return shared_ == nullptr ? nullptr : shared_->find(id);
  }
  void add(std::shared_ptr<Structure> structure) { structures_.push_back(std::move(structure)); }
  /// Excludes those of the shared set.
  std::span<const std::shared_ptr<Structure>> all() const { return structures_; }
  bool holds(const Structure& structure) const {
    return std::ranges::any_of(structures_, [&](const auto& own) { return own.get() == &structure; });
  }
  bool is_variant() const { return shared_ != nullptr; }

 private:
  const StructureSet* shared_;
  std::vector<std::shared_ptr<Structure>> structures_;  // shared by two sets while a graph changes its registry
};

}  // namespace mes
