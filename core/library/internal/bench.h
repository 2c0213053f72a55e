// SPDX-License-Identifier: GPL-3.0-or-later
// The program's workbench behind the public one.
#pragma once

#include <memory>

#include <mesecina/workbench.h>

#include "core/graph/registry.h"
#include "core/library/internal/adapter.h"
#include "core/library/internal/table_access.h"
#include "core/workbench/workbench.h"

namespace mesecina {
inline namespace v1 {

struct Workbench::Impl {
  Impl(const Catalogue& its_catalogue, const WorkbenchOptions& options)
      : catalogue(its_catalogue),
        bench(*CatalogueAccess::registry(catalogue),
              {.keeps_history = options.keeps_history, .keeps_instances = options.keeps_instances}) {}
  ~Impl() { clock->close(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  const mes::Registry& registry() const { return *CatalogueAccess::registry(catalogue); }

  Catalogue catalogue;  // outlives the workbench
  std::shared_ptr<RunClock> clock = std::make_shared<RunClock>(registry().structures().size());
  bool was_stopped = false;     // the last run was stopped or ran out of memory
  bool has_gap_before = false;  // the same for the run before it: changes of tables were lost
  mes::Workbench bench;
};

}  // namespace v1
}  // namespace mesecina
