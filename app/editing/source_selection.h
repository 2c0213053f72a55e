// SPDX-License-Identifier: GPL-3.0-or-later
// Selects the samples and balls from which an element on screen was made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "app/editing/editor.h"
#include "core/draw/provenance.h"
#include "core/engine/engine.h"

namespace mes {

/// Selects exactly the samples at points, ends and corners of the element and of its sources, and the balls among
/// these. Returns their number; if it is zero, the selection stays. O(shapes).
std::size_t select_sources(Editor& editor, const Provenance& element);

/// Selects the sources of those elements of a layer whose value is in a range.
///
/// Guarantees: the engine finds them, and the window does not wait for it; an edit before the answer cancels it.
/// Threads: the window's.
class ValueSelector {
 public:
  explicit ValueSelector(Editor& editor) : editor_(editor) {}

  void ask(Engine& engine, LayerIndex layer, double low, double high);
  /// A sentence on the effect, if the answer was to a question of this object.
  std::optional<std::string> take(const Provenance& answer);

 private:
  // Less than the tickets of other questions without a click.
  static constexpr std::uint64_t kFirstTicket = std::uint64_t{1} << 61U;
  Editor& editor_;
  std::uint64_t ticket_ = kFirstTicket;
  std::uint64_t revision_ = 0;  // revision of the document at the question
};

}  // namespace mes
