// SPDX-License-Identifier: GPL-3.0-or-later
// Marks on the canvas for elements that only some of the panes have.
//
// Guarantees:
//  1. Nothing is computed twice and nothing waits: a separate thread compares the layers that the engine sent for the
//     panes, as `render --differences` does. Marks of an earlier state stay until the new ones are ready; a state
//     that changes during its comparison is compared again afterwards.
//  2. No comparison is made while no marks are wanted.
//
// Smallest use, once a frame:
//     marks.follow(is_wanted ? std::optional(state) : std::nullopt, is_later, panes_revision,
//                  [&] { return DifferenceMarks::Panes{registry, comparison_of(shown, layers), picture.instances(), extent}; },
//                  picture);
//
// Cost: O(instances of all panes) per comparison, beside the window. Threads: the window's; `wake` is called from
// others.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/export/comparison.h"
#include "app/panes/pane_list.h"
#include "app/picture/picture.h"
#include "app/system/background_job.h"

namespace mes {

class DifferenceMarks {
 public:
  explicit DifferenceMarks(Waker wake) : comparing_(std::move(wake)) {}

  /// The changeable state that the panes show.
  struct State {
    std::uint64_t document = 0;  ///< revision, like the numbers below
    std::uint64_t before_last_edit = 0;
    std::uint64_t beginning = 0;  ///< beginning of the evolution
    std::uint64_t layers = 0;
    std::uint64_t panes = 0;
    ComputationSettings settings{};
    PaneEvolution evolution{};
    friend bool operator==(const State&, const State&) = default;
  };
  /// The input of a comparison.
  struct Panes {
    std::shared_ptr<const Registry> registry;  ///< the registry of these layers
    Comparison comparison;
    std::shared_ptr<const LayerMirror> drawn;
    double extent = 0.0;             ///< extent of the whole drawing
    std::optional<Error> problem{};  ///< why the panes cannot be compared
  };
  /// `state`: the displayed state, completely computed; nothing: no marks are wanted. `later`: a state is still being
  /// computed, so the present marks stay. Marks refer to panes by number, so they are dropped when `panes_revision`
  /// changes.
  void follow(const std::optional<State>& state, bool later, std::uint64_t panes_revision,
              const std::function<Panes()>& panes, Picture& picture);
  /// True if the marks belong to the state, or it has none.
  bool is_complete(const std::optional<State>& state) const { return state == marked_; }
  /// The reason why panes could not be compared, given once.
  std::optional<Error> take_problem() { return std::exchange(problem_, std::nullopt); }

 private:
  struct Compared {
    State state;
    FramePatch patch;
    std::vector<std::vector<render::LayerView>> marks;  // for each pane, the main one first
    std::optional<Error> problem;
  };
  static Compared compare_panes(Panes panes, const State& state);

  std::optional<State> marked_;  // the state of the picture's marks
  bool is_comparing_ = false;
  std::optional<Error> problem_;
  BackgroundJob<Compared> comparing_;
};

}  // namespace mes
