// SPDX-License-Identifier: GPL-3.0-or-later
// The view and settings of a document, beside its layers, and their changes on the timeline.
#pragma once

#include "app/editing/editor.h"

namespace mes {

struct Surroundings {
  const ComputationSettings& settings;
  Box2 view{};  ///< the visible area; empty: not known yet
};

/// Guarantees: after `follow`, folding the timeline's entries gives these surroundings. A new document gets them in
/// full, later only the differences. Cost: a few comparisons if nothing has changed. Threads: none.
class SurroundingsNotes {
 public:
  /// Call it at rest, so that dragging a slider makes one entry.
  void follow(Editor& editor, const Surroundings& now);
  /// Notes that these surroundings were restored with the document: they are on its timeline already.
  void take_as_noted(const Editor& editor, const Surroundings& now);

 private:
  std::uint64_t generation_ = ~std::uint64_t{0};
  std::optional<ComputationSettings> settings_{};
  Box2 view_{};
};

}  // namespace mes
