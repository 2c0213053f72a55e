// SPDX-License-Identifier: GPL-3.0-or-later
// What a document is looked at with, beside its layers, and its changes on the timeline.
#pragma once

#include "app/editing/editor.h"

namespace mes {

struct Surroundings {
  const ComputationSettings& settings;
  Box2 view{};  ///< what is to be seen; empty: not known yet
};

/// What it guarantees: after `follow` the timeline's entries, folded, give these surroundings; of a new document they
/// are noted in full, then only what is different. Cost: a few comparisons when nothing changed. Threads: none.
class SurroundingsNotes {
 public:
  /// To be called when things are at rest, so that a slider being dragged makes one entry.
  void follow(Editor& editor, const Surroundings& now);
  /// The document was restored, and these surroundings with it: they are on its timeline already.
  void take_as_noted(const Editor& editor, const Surroundings& now);

 private:
  std::uint64_t generation_ = ~std::uint64_t{0};
  std::optional<ComputationSettings> settings_{};
  Box2 view_{};
};

}  // namespace mes
