// SPDX-License-Identifier: GPL-3.0-or-later
// Selecting the samples and balls that something on screen comes from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "app/editing/editor.h"
#include "core/draw/provenance.h"
#include "core/engine/engine.h"

namespace mes {

/// Selects the samples that lie at places, ends and corners of the element and of what it comes from, and the balls that
/// are among these, and nothing else. How many there are; where there are none, what was selected stays so. O(shapes).
std::size_t select_sources(Editor& editor, const Provenance& element);

/// Selects what those elements of a layer come from whose value is in a range.
///
/// What it guarantees: the engine finds them, and the window does not wait for it; an edit before the answer drops it.
/// Threads: the window's.
class ValueSelector {
 public:
  explicit ValueSelector(Editor& editor) : editor_(editor) {}

  void ask(Engine& engine, LayerIndex layer, double low, double high);
  /// What was done, as a sentence, when the answer was to a question of this object.
  std::optional<std::string> take(const Provenance& answer);

 private:
  // Below those of other questions that come without a click.
  static constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 61U;
  Editor& editor_;
  std::uint64_t ticket_ = kFirstTicket;
  std::uint64_t revision_ = 0;  // of the document, when it was asked
};

}  // namespace mes
