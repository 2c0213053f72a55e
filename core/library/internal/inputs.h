// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment reads, behind the public `Inputs` and `OwnTable`.
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

#include "core/base/job_control.h"
#include "core/document/parameter.h"
#include "core/graph/structure.h"
#include "core/graph/table_columns.h"
#include "core/library/internal/table_access.h"
#include "core/structures/inputs/settings_source.h"

namespace mesecina {
inline namespace v1 {

/// Tables of some structures, looked up by their ids, as they are since the last `begin`.
struct Inputs::Impl {
  std::vector<const mes::Structure*> structures;
  const mes::SettingsSource* settings = nullptr;  ///< null: no parameter is read
  std::vector<mes::Parameter> parameters;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { end(); }

  /// What was read before is outdated. A job of null cannot be stopped.
  void begin(mes::JobControl* its_job) {
    end();
    job = its_job;
    for (Known& one : known) one.is_fresh = false;
  }
  /// Tables that were given out are outdated.
  void end();
  /// Error: `usage`.
  const mes::TableColumns& find(std::string_view table);

  mes::JobControl* job = nullptr;
  struct Known {
    const mes::Structure* structure;
    std::vector<mes::TableColumns> tables;
    bool is_fresh = true;
  };
  std::deque<Known> known{};  // columns that were given out stay where they are
  std::shared_ptr<RunClock> clock{};
};

struct OwnTable::Impl {
  mes::TableColumns table{};
  std::vector<std::function<Place()>> places{};  ///< of its columns
  const std::vector<std::uint8_t>* alive = nullptr;
  const std::vector<Row>* touched = nullptr;  ///< null: it does not say which rows differ
  const std::vector<Row>* removed = nullptr;

  /// Addresses, rows and changes as they are now.
  void refresh(mes::TableColumns& out, bool has_changes) const;
};

struct OwnTableAccess {
  static std::shared_ptr<OwnTable::Impl> take(OwnTable& table) { return std::move(table.impl_); }
};

/// Words of what an experiment threw, in one line.
std::string one_line(std::string_view text);

/// Calls a function of an experiment. What it throws becomes what a structure of the program throws.
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
