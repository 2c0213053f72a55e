// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of what only some of the panes have, on the canvas.
//
// What it guarantees:
//  1. Nothing is computed twice and nothing waits: what the engine sent for the panes is compared, as `render
//     --differences` does, on a thread of its own. Marks of an earlier state stay until those of the present one are
//     there; a state that changes while it is being compared is compared after that.
//  2. While nothing is to be marked no comparison is made.
//
// Smallest use, once a frame:
//     marks.follow(is_wanted ? std::optional(state) : std::nullopt, is_later, panes_revision,
//                  [&] { return DifferenceMarks::Panes{registry, comparison_of(shown, layers), picture.instances(), extent}; },
//                  picture);
//
// Cost: O(instances of all panes) a comparison, beside the window. Threads: the window's; `wake` is called from others.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/export/comparison.h"
#include "app/model/pane_list.h"
#include "app/picture/picture.h"
#include "app/system/background_job.h"

namespace mes {

class DifferenceMarks {
 public:
  explicit DifferenceMarks(Waker wake) : comparing_(std::move(wake)) {}

  /// What the panes show, as far as it can change.
  struct State {
    std::uint64_t document = 0;  ///< revisions
    std::uint64_t before_last_edit = 0;
    std::uint64_t beginning = 0;  ///< of the evolution
    std::uint64_t layers = 0;
    std::uint64_t panes = 0;
    ComputationSettings settings{};
    PaneEvolution evolution{};
    friend bool operator==(const State&, const State&) = default;
  };
  /// What is compared.
  struct Panes {
    std::shared_ptr<const Registry> registry;  ///< whose layers these are
    Comparison comparison;
    std::shared_ptr<const LayerMirror> drawn;
    double extent = 0.0;             ///< of all that is drawn
    std::optional<Error> problem{};  ///< why they cannot be compared
  };
  /// `state`: what is shown, with all of it computed; none: nothing is to be marked. `later` says that a state is still
  /// being computed: what is marked stays.
  /// Marks are of the panes by their numbers: where these are others now (`panes_revision`), there are none.
  void follow(const std::optional<State>& state, bool later, std::uint64_t panes_revision,
              const std::function<Panes()>& panes, Picture& picture);
  /// The marks are those of the state, or it has none.
  bool is_complete(const std::optional<State>& state) const { return state == marked_; }
  /// Why panes could not be compared, once.
  std::optional<Error> take_problem() { return std::exchange(problem_, std::nullopt); }

 private:
  struct Compared {
    State state;
    FramePatch patch;
    std::vector<std::vector<render::LayerView>> marks;  // of each pane, the main one first
    std::optional<Error> problem;
  };
  static Compared compare_panes(Panes panes, const State& state);

  std::optional<State> marked_;  // what the picture's marks are of
  bool is_comparing_ = false;
  std::optional<Error> problem_;
  BackgroundJob<Compared> comparing_;
};

}  // namespace mes
