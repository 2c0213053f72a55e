// SPDX-License-Identifier: GPL-3.0-or-later
// Factors at which the union of grown balls of the scale axis changes its topology.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/system/latest.h"
#include "core/document/commands.h"
#include "core/document/computation_settings.h"
#include "core/graph/live_registry.h"

namespace mes {

/// The topology just below and just above.
struct ScaleEvent {
  double factor = 1.0;
  double within = 0.0;  ///< largest error of `factor`: 5e-4, or more if the search reached its limits
  std::int64_t components_before = 0, components_after = 0;
  std::int64_t holes_before = 0, holes_after = 0;
  friend bool operator==(const ScaleEvent&, const ScaleEvent&) = default;

  /// "components 2 to 1, holes 0 to 1".
  std::string words() const;
};

/// Found by halving intervals of the factor at whose ends the union differs, the widest first: from 32 equal ones between 1
/// and 3 on, and 6 below 1. So what happens and is undone within one of these is not seen, and events nearer than a
/// thousandth are one.
///
/// Below 1 nothing is looked for where the union at 1 is certified: shrunk balls along an axis have the topology of that
/// axis, which is then that of the union. Where it is not, balls of parts that are no neighbours may part as they shrink.
/// Of these factors those are left out at which the union fails, as it does where it takes too many balls.
///
/// Balls are sampled at 175 degrees at most; dents between them are then no deeper than a thousandth of the radius.
///
/// Throws `Cancelled`. Error: a structure failed, or 39 unions are too much. Cost: at most 400 unions, and none after 4 * 10^7
/// balls.
Expected<std::vector<ScaleEvent>> scale_events_of(const Registry& registry, const SampleData& data,
                                                  const ComputationSettings& settings, JobControl& job);

/// Events of the document, found on a thread of their own, one at a time, while they are looked at. Threads: the
/// window's; `wake` is called from the other.
class ScaleEvents {
 public:
  ScaleEvents(LiveRegistry registry, Waker wake)
      : registry_(std::move(registry)), latest_(std::move(wake), Outdated::give_up) {}

  /// Takes what is ready, and begins what is missing. `data` is called when a computation begins.
  void follow(std::uint64_t document, const ComputationSettings& settings, const std::function<SampleData()>& data);
  /// Once a frame, after those who may follow: what nothing followed is given up.
  void end_frame() { latest_.end_frame(); }
  /// Of the state followed last; null while they are not known.
  const std::vector<ScaleEvent>* events() const { return latest_.is_current() ? latest_.result().get() : nullptr; }
  /// Why they cannot be had; empty: they can.
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
