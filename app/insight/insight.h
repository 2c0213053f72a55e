// SPDX-License-Identifier: GPL-3.0-or-later
// Tables and numbers that are computed beside the picture, while panels show them.
#pragma once

#include "app/insight/critical_values.h"
#include "app/insight/latest_branches.h"
#include "app/insight/latest_persistence.h"
#include "app/insight/parameter_sweep.h"
#include "app/insight/scale_events.h"
#include "app/system/waker.h"
#include "core/graph/live_registry.h"

namespace mes {

struct Insight {
  Insight(const LiveRegistry& registry, const Waker& wake)
      : branches(registry, wake),
        persistence(registry, wake),
        sweep(registry, wake),
        scale_events(registry, wake),
        critical_values(registry, wake) {}

  /// Once a frame, after the panels: gives up what none of them followed.
  void end_frame() {
    branches.end_frame();
    persistence.end_frame();
    scale_events.end_frame();
    critical_values.end_frame();
  }

  LatestBranches branches;
  LatestPersistence persistence;
  SweepJob sweep;
  ScaleEvents scale_events;
  CriticalValues critical_values;
};

}  // namespace mes
