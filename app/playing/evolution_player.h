// SPDX-License-Identifier: GPL-3.0-or-later
// The evolution of the window: a slider over the states of the document, and their playback.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/editing/editor.h"
#include "core/evolutions/evolution_run.h"
#include "core/graph/live_registry.h"

namespace mes {

/// Guarantees:
///  1. State 0 is the document as of the first step after an edit; `step_to(0)` restores it exactly. Another
///     evolution begins at the state shown when it is chosen: the effect of the previous one is kept.
///  2. All states of one evolution are one step of undo (`Editor::evolve`). An edit at state k makes that state 0 of
///     the following steps; undo reverts first the edit and then the evolution. If a parameter moves instead of
///     samples, state 0 restores its value, and setting it at state k makes that state 0 of the following steps.
///  3. A step that is a length is a round fraction of the size of the document, and follows it in state 0, unless it
///     was set to another value. Its default stands for that fraction.
///  4. A step is requested and shown later, when it is computed; nothing waits. Playback takes a step when the
///     picture of the previous one is complete and the speed allows it.
///
/// Smallest use:
///     EvolutionPlayer player(registry, editor, settings, wake);
///     player.step_to(12);
///     ... each frame: player.follow(picture_is_complete, seconds_since_start);
///
/// Threads: the window's; `wake` is called from the thread of the run.
class EvolutionPlayer {
 public:
  static constexpr std::uint64_t kFirstEnd = 100;
  static constexpr double kFastest = 60.0;  ///< steps per second; as fast as pictures are completed

  /// Access to the settings of the computation, which some evolutions move.
  struct Settings {
    std::function<double(const Parameter&)> value;
    std::function<void(const Parameter&, double)> set;
  };
  /// The registry must have an evolution.
  EvolutionPlayer(LiveRegistry registry, Editor& editor, Settings settings, std::function<void()> wake);
  /// Call it when the registry was replaced. A removed evolution becomes a missing one, as in a session, until it
  /// returns; the document keeps its state. A replaced one continues from the same state 0. Returns true if the
  /// evolution has changed.
  bool follow_registry();

  std::span<const std::shared_ptr<const Evolution>> evolutions() const { return registry_.now().evolutions().all(); }

  const EvolutionChoice& choice() const { return choice_; }
  const EvolutionDescriptor& descriptor() const { return evolution().descriptor; }
  /// Chooses an evolution, with the present state as its state 0.
  void choose(const std::shared_ptr<const Evolution>& evolution);
  /// Chooses the evolution `places` positions after the present one, cyclically.
  void choose_next(int places);
  /// Computes and shows the present state again with this seed.
  void set_seed(std::uint64_t seed);
  void set_value(const Parameter& parameter, double value);

  /// Continues from a session: the document is in state `k`, and its last step of undo leads there from state 0; or
  /// the moved parameter has the value that `k` steps from its default give, else it is in state 0. A missing
  /// evolution stays in state `k` until the document changes.
  void resume(const EvolutionChoice& choice, std::uint64_t k);

  /// The present state of the document, or of the parameter.
  std::uint64_t position() const;
  /// State 0 of the document, and the revision that the document had in it. O(n).
  EvolutionState beginning() const;
  std::uint64_t beginning_revision() const {
    return position() == 0 || descriptor().is_missing ? editor_.document().revision() : beginning_revision_;
  }
  /// State 0 of the moved parameter; 0 if samples move.
  double first_value() const;
  /// Value of the moved parameter; nothing if samples move.
  std::optional<double> parameter_value() const;
  /// The state that is being computed, or else `position`.
  std::uint64_t target() const { return wanted_.value_or(position()); }
  /// Far end of the slider; it grows with the position.
  std::uint64_t end() const { return end_; }
  void set_end(std::uint64_t end);
  void step_to(std::uint64_t k);
  void step_forward() { step_to(target() + 1); }
  void step_back() { step_to(target() == 0 ? 0 : target() - 1); }

  enum class Direction : std::int8_t { backward = -1, none = 0, forward = 1 };
  void play(Direction direction);
  Direction direction() const { return direction_; }
  double speed() const { return speed_; }  ///< steps per second
  void set_speed(double speed) { speed_ = speed; }

  /// True while a requested state is not in the document yet.
  bool is_waiting() const { return wanted_.has_value(); }
  /// Progress of the steps that are being computed, in [0, 1].
  double progress() const;
  /// Gives up the computation, and stops the playback.
  void cancel();

  /// Call it once per frame: shows a finished state, and continues the playback.
  void follow(bool picture_is_complete, double now);
  /// Seconds from `now` until the next step is due, if it waits only for its time.
  std::optional<double> next_due(double now) const;
  /// True, once, after an edit in the middle of an evolution has made the present document state 0.
  bool take_restart() { return std::exchange(has_restarted_, false); }
  /// Says, once, what another choice has kept and which step was given up before it was computed; empty: neither.
  std::string take_remark() { return std::exchange(remark_, {}); }
  /// The reason why a state is impossible, given once.
  std::optional<Error> take_problem() { return std::exchange(problem_, std::nullopt); }

 private:
  /// A value that the player gave to a parameter.
  struct MovedParameter {
    std::uint64_t k = 0;
    double before = 0.0;
    double value = 0.0;
  };
  const Evolution& evolution() const { return *choice_.evolution; }
  bool has_beginning() const;
  void begin();
  void restart_from_beginning();
  /// The requested step, which is about to be given up, in words; empty: none.
  std::string given_up_step() const;
  void show(std::uint64_t k, const EvolutionState& state);
  /// O(n), if there are lengths that were not set to another value.
  void fit_lengths();
  /// A round fraction of the size of the document. O(n).
  std::optional<double> proposed_length() const;
  void move_parameter(const ParameterMove& move, std::uint64_t k);

  LiveRegistry registry_;
  Editor& editor_;
  Settings settings_;
  EvolutionRun run_;
  EvolutionChoice choice_;
  EvolutionState beginning_;
  std::uint64_t beginning_revision_ = ~std::uint64_t{0};
  std::uint64_t shown_revision_ = ~std::uint64_t{0};
  std::uint64_t shown_ = 0;
  MovedParameter moved_;
  std::optional<double> fitted_;  // last length that `fit_lengths` set
  std::uint64_t fitted_revision_ = ~std::uint64_t{0};
  std::uint64_t end_ = kFirstEnd;
  std::optional<std::uint64_t> wanted_;
  std::uint64_t wanted_from_ = 0;
  Direction direction_ = Direction::none;
  double speed_ = 10.0;
  double last_step_ = 0.0;
  std::optional<Error> problem_;
  bool has_restarted_ = false;
  std::string remark_;
};

}  // namespace mes
