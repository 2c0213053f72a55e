// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of an experiment, behind the public `Inputs` and `OwnTable`.
#pragma once

#include <deque>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <mesecina/experiment.h>

#include "core/base/jobs/job_control.h"
#include "core/document/settings/parameter.h"
#include "core/graph/structure.h"
#include "core/graph/table_columns.h"
#include "core/library/internal/table_access.h"
#include "core/structures/inputs/settings_source.h"

namespace mesecina {
inline namespace v1 {

/// Tables of some structures by id, as of the last `begin`.
struct Inputs::Impl {
  std::vector<const mes::Structure*> structures;
  const mes::SettingsSource* settings = nullptr;  ///< null if no parameter is read
  std::vector<mes::Parameter> parameters;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { end(); }

  /// Outdates everything read before. A null job cannot be stopped.
  void begin(mes::JobControl* its_job) {
    end();
    job = its_job;
    for (Known& one : known) one.is_fresh = false;
  }
  /// Outdates all tables returned so far.
  void end();
  /// Error: `usage`.
  const mes::TableColumns& find(std::string_view table);

  mes::JobControl* job = nullptr;
  struct Known {
    const mes::Structure* structure;
    std::vector<mes::TableColumns> tables;
    bool is_fresh = true;
  };
  std::deque<Known> known{};  // a deque, because returned columns must not move
  std::shared_ptr<RunClock> clock{};
};

struct OwnTable::Impl {
  mes::TableColumns table{};
  std::vector<std::function<Place()>> places{};  ///< one for each of its columns
  const std::vector<std::uint8_t>* alive = nullptr;
  const std::vector<Row>* touched = nullptr;  ///< null if the changed rows are unknown
  const std::vector<Row>* removed = nullptr;

  /// Updates addresses, rows and changes.
  void refresh(mes::TableColumns& out, bool has_changes) const;
};

struct OwnTableAccess {
  static std::shared_ptr<OwnTable::Impl> take(OwnTable& table) { return std::move(table.impl_); }
};

/// The text of an experiment's exception as one line.
std::string one_line(std::string_view text);

/// Calls a function of an experiment and converts its exceptions to those of a structure of the program.
template <class Work>
decltype(auto) shielded(Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw mes::Cancelled{};
    std::vector<mes::SampleId> witnesses;
    for (const SampleId id : error.witnesses()) witnesses.push_back({id.value});
    throw mes::GeometryError(one_line(error.what()), std::move(witnesses));
  } catch (const mes::Cancelled&) {
    throw;
  } catch (const mes::GeometryError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw mes::GeometryError(one_line(error.what()));
  } catch (...) {
    throw mes::GeometryError("it threw something that is no exception");
  }
}

}  // namespace v1
}  // namespace mesecina
