// SPDX-License-Identifier: GPL-3.0-or-later
// The changes of topology by the steps of an evolution that grows or shrinks balls.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/insight/computation_control.h"
#include "app/insight/latest_persistence.h"
#include "app/insight/scale_events.h"
#include "app/layers/layer_stack.h"
#include "app/playing/evolution_player.h"

namespace mes {

/// The events between a state and the previous one, or the one several steps before if there are many states.
struct StepEvent {
  std::uint64_t before = 0;
  std::uint64_t k = 0;      ///< the state that shows it
  std::uint64_t joins = 0;  ///< components joined to others
  std::uint64_t closes = 0;
  std::uint64_t fills = 0;
  bool is_undone = false;  ///< balls shrink: the events are undone
  friend bool operator==(const StepEvent&, const StepEvent&) = default;

  /// A description: "Step 7: components joined: 2, holes closed: 1".
  std::string words() const;
};

/// The part of an evolution that a slider shows; a parameter begins with its value in state 0.
struct StepRange {
  EvolutionChoice choice{};
  double first = 0.0;
  std::uint64_t end = 0;
  friend bool operator==(const StepRange&, const StepRange&) = default;
};

/// Events of additive growth, exact. Ends where the parameter leaves its range. Examines at most `kMostStepEvents`
/// positions.
inline constexpr std::uint64_t kMostStepEvents = 250;
std::vector<StepEvent> step_events_of(const StepRange& range, const PersistenceTable& table);
/// Events of scaled balls along the axis; as exact as the factors.
std::vector<StepEvent> step_events_of(const StepRange& range, const std::vector<ScaleEvent>& events);

/// The events of the chosen evolution, while its slider is visible. For additive growth they belong to the family
/// that `shown_growth` returns. Nothing waits. Threads: the window's.
class StepEvents {
 public:
  struct Uses {
    const EvolutionPlayer& player;
    const Editor& editor;
    const LayerStack& layers;
    const ComputationControl& computation;
    LatestPersistence& persistence;
    ScaleEvents& scale_events;
  };
  explicit StepEvents(const Uses& uses) : uses_(uses) {}

  /// Call it once per frame, after the family has been chosen.
  void follow();
  /// True if the evolution has events or may have them when found, because its layers are visible.
  bool has_place() const { return has_place_; }
  bool are_known() const { return table_ != nullptr || knows_factors_; }
  const std::vector<StepEvent>& events() const { return events_; }
  /// The reason why they are unavailable; empty if there is none.
  const std::string& problem() const { return problem_; }

 private:
  void follow_growth(const StepRange& range);
  void follow_factors(const StepRange& range);
  void forget();

  Uses uses_;
  bool has_place_ = false;
  std::string problem_;
  StepRange range_;                                // range of the events
  std::shared_ptr<const PersistenceTable> table_;  // source of the events, or else `factors_`
  std::vector<ScaleEvent> factors_;
  bool knows_factors_ = false;
  std::vector<StepEvent> events_;
};

}  // namespace mes
