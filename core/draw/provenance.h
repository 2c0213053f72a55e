// SPDX-License-Identifier: GPL-3.0-or-later
// Where something on the canvas comes from and what it made: the question, and the answer as text and shapes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/slot.h"
#include "core/base/vec2.h"
#include "core/draw/primitives.h"
#include "core/draw/variant.h"

namespace mes {

enum class ProvenanceWish : std::uint8_t {
  story,              ///< what lies there, where it comes from and where it leads
  shape,              ///< the first line of that alone, with the shape and no text
  insertion,          ///< what a further sample there would change; no layers are looked at
  sources_of_values,  ///< what those elements of the layer come from whose value is in a range; the place does not matter
};

inline constexpr std::size_t kProvenanceWishes = 4;

/// What lies at a place, nearest in the topmost layer that has something within reach.
struct ProvenanceQuestion {
  std::uint64_t ticket = 0;  ///< of the asker; the answer repeats it
  Vec2 at{};
  double reach = 0.0;                ///< in units of the document
  std::vector<VariantLayer> layers;  ///< to look at, top first
  ProvenanceWish wish = ProvenanceWish::story;
  double low = 0.0;  ///< the range of values, both ends included
  double high = 0.0;
};

/// What a place of a shape follows: nothing, samples, or balls of the document, as an `Anchor` does
/// (core/document/annotation.h). No slot stands for none.
struct Followed {
  std::array<SampleSlot, 3> samples{};
  std::array<BallSlot, 4> balls{};
  double along = 0.0;
  double scale = 1.0;
};

struct ProvenanceShape {
  PrimitiveKind kind = PrimitiveKind::point;
  std::array<double, 7> values{};  ///< as in core/draw/primitives.h, without the scalar
  /// Of the places that define it, in the order that `HighlightedElement` has (core/document/annotation.h).
  std::array<Followed, 3> follows{};
};

enum class ProvenanceRole : std::uint8_t { itself, origin, product };

struct ProvenanceLine {
  ProvenanceRole role = ProvenanceRole::itself;
  std::string text;  ///< no full stop
  std::vector<ProvenanceShape> shapes;
  bool is_heavy = false;  ///< what matters most among those of its role
};

/// A row that some structure has about what was asked for, with its columns as text (core/graph/table_columns.h).
struct ProvenanceRow {
  struct Value {
    std::string name;
    std::string text;
    std::string description;
  };
  std::string table;  ///< as in "delaunay/faces"
  RowNumber row = 0;
  std::vector<Value> values;
};

struct Provenance {
  std::uint64_t ticket = 0;
  VariantLayer layer{};               ///< where it was found
  std::vector<ProvenanceLine> lines;  ///< itself first; empty = nothing was there
  std::vector<ProvenanceRow> rows;    ///< of a story: inputs before consumers
};

}  // namespace mes
