// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of an evolution that grows or shrinks balls change in the topology of their union.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/insight/computation_control.h"
#include "app/insight/persistence_desk.h"
#include "app/insight/scale_events.h"
#include "app/layers/layer_stack.h"
#include "app/playing/evolution_player.h"

namespace mes {

/// What happens between a state and the one before; or between states some steps apart, where there are many.
struct StepEvent {
  std::uint64_t before = 0;
  std::uint64_t k = 0;      ///< the state that shows it
  std::uint64_t joins = 0;  ///< components that are joined to others
  std::uint64_t closes = 0;
  std::uint64_t fills = 0;
  bool is_undone = false;  ///< balls shrink: these are undone
  friend bool operator==(const StepEvent&, const StepEvent&) = default;

  /// "Step 7: components joined: 2, holes closed: 1".
  std::string words() const;
};

/// The part of an evolution that a slider shows: of a parameter, from its value in state 0 on.
struct StepRange {
  EvolutionChoice choice{};
  double first = 0.0;
  std::uint64_t end = 0;
  friend bool operator==(const StepRange&, const StepRange&) = default;
};

/// Of additive growth, exact. Ends where the parameter leaves its range. No more than `kMostStepEvents` places are looked at.
inline constexpr std::uint64_t kMostStepEvents = 250;
std::vector<StepEvent> step_events_of(const StepRange& range, const PersistenceTable& table);
/// Of balls along the axis; as exact as the factors are.
std::vector<StepEvent> step_events_of(const StepRange& range, const std::vector<ScaleEvent>& events);

/// Those of the evolution that is chosen, while its slider is shown. Of additive growth they are about what `shown_growth`
/// names. Nothing waits. Threads: the window's.
class StepEvents {
 public:
  struct Uses {
    const EvolutionPlayer& player;
    const Editor& editor;
    const LayerStack& layers;
    const ComputationControl& computation;
    PersistenceDesk& persistence;
    ScaleEvents& scale_events;
  };
  explicit StepEvents(const Uses& uses) : uses_(uses) {}

  /// Once a frame, after those who choose what grows.
  void follow();
  /// The evolution has some, or will when they are found: its layers are shown.
  bool has_place() const { return has_place_; }
  bool are_known() const { return table_ != nullptr || knows_factors_; }
  const std::vector<StepEvent>& events() const { return events_; }
  /// Why they cannot be had; empty: they can.
  const std::string& problem() const { return problem_; }

 private:
  void follow_growth(const StepRange& range);
  void follow_factors(const StepRange& range);
  void forget();

  Uses uses_;
  bool has_place_ = false;
  std::string problem_;
  StepRange range_;                                // of the events
  std::shared_ptr<const PersistenceTable> table_;  // they are of, or of these
  std::vector<ScaleEvent> factors_;
  bool knows_factors_ = false;
  std::vector<StepEvent> events_;
};

}  // namespace mes
