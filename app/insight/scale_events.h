// SPDX-License-Identifier: GPL-3.0-or-later
// Factors at which the union of grown balls of the scale axis changes its topology.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/system/latest.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/graph/live_registry.h"

namespace mes {

/// The topology just below and just above a factor.
struct ScaleEvent {
  double factor = 1.0;
  double within = 0.0;  ///< largest error of `factor`: 5e-4, or more if the search reached its limits
  std::int64_t components_before = 0, components_after = 0;
  std::int64_t holes_before = 0, holes_after = 0;
  friend bool operator==(const ScaleEvent&, const ScaleEvent&) = default;

  /// "components 2 to 1, holes 0 to 1".
  std::string words() const;
};

/// Halves intervals of the factor at whose ends the union differs, the widest first. It starts with 32 equal
/// intervals between 1 and 3, and 6 below 1, so a change that is undone within one interval is missed, and events
/// closer than a thousandth are merged.
///
/// Factors below 1 are skipped if the union at 1 is certified: shrunk balls along an axis have the topology of that
/// axis, which is then that of the union. If it is not certified, balls of parts that are not neighbours may separate
/// as they shrink. Factors below 1 at which the union fails, for example because it takes too many balls, are left
/// out.
///
/// Balls are sampled at 175 degrees at most; dents between them are then no deeper than a thousandth of the radius.
///
/// Throws `Cancelled`. Error: a structure failed, or even 39 unions are too many. Cost: at most 400 unions, and none
/// after 4 * 10^7 balls.
Expected<std::vector<ScaleEvent>> scale_events_of(const Registry& registry, const SampleData& data,
                                                  const ComputationSettings& settings, JobControl& job);

/// Events of the document, found on a thread of their own, one search at a time, while they are displayed. Threads:
/// the window's; `wake` is called from the other.
class ScaleEvents {
 public:
  ScaleEvents(LiveRegistry registry, Waker wake)
      : registry_(std::move(registry)), latest_(std::move(wake), Outdated::give_up) {}

  /// Takes finished events, and begins a missing search. Calls `data` when a search begins.
  void follow(std::uint64_t document, const ComputationSettings& settings, const std::function<SampleData()>& data);
  /// Call it once per frame after all possible calls of `follow`: if there was none, the computation is given up.
  void end_frame() { latest_.end_frame(); }
  /// The events of the state followed last; null while they are unknown.
  const std::vector<ScaleEvent>* events() const { return latest_.is_current() ? latest_.result().get() : nullptr; }
  /// The reason why they are unavailable; empty if there is none.
  std::string problem() const { return latest_.problem(); }

 private:
  struct State {
    std::uint64_t document = 0;
    ComputationSettings settings{};
    friend bool operator==(const State&, const State&) = default;
  };
  LiveRegistry registry_;
  Latest<State, std::vector<ScaleEvent>> latest_;
};

}  // namespace mes
