// SPDX-License-Identifier: GPL-3.0-or-later
// Provenance of elements on the canvas: the question, and the answer as text and shapes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/slot.h"
#include "core/draw/primitives.h"
#include "core/draw/provenance_role.h"
#include "core/draw/variant.h"

namespace mes {

enum class ProvenanceWish : std::uint8_t {
  story,              ///< the element there, its origins and its products
  shape,              ///< only the first line of that, with the shape and no text
  insertion,          ///< the changes that a further sample there would cause; no layers are searched
  sources_of_values,  ///< origins of all elements of the layer with a value in the range; ignores the position
};

inline constexpr std::size_t kProvenanceWishes = 4;

/// Asks for the nearest element at a position, in the topmost layer that has one within reach.
struct ProvenanceQuestion {
  std::uint64_t ticket = 0;  ///< chosen by the asker; the answer repeats it
  Vec2 at{};
  double reach = 0.0;                ///< in units of the document
  std::vector<VariantLayer> layers;  ///< layers to search, top first
  ProvenanceWish wish = ProvenanceWish::story;
  double low = 0.0;  ///< range of values, both ends included
  double high = 0.0;
};

/// The thing that a point of a shape follows: nothing, samples, or balls of the document, like an `Anchor`
/// (core/document/annotation.h). "No slot" means unused.
struct Followed {
  std::array<SampleSlot, 3> samples{};
  std::array<BallSlot, 4> balls{};
  double along = 0.0;
  double scale = 1.0;
};

struct ProvenanceShape {
  PrimitiveKind kind = PrimitiveKind::point;
  std::array<double, 7> values{};  ///< see core/draw/primitives.h; without the scalar
  /// For its defining points, in the order of `HighlightedElement` (core/document/annotation.h).
  std::array<Followed, 3> follows{};
};

struct ProvenanceLine {
  ProvenanceRole role = ProvenanceRole::itself;
  std::string text;  ///< no full stop
  std::vector<ProvenanceShape> shapes;
  bool is_heavy = false;  ///< among the most important of its role
};

/// A row of a structure about the element, with its columns as text (core/graph/table_columns.h).
struct ProvenanceRow {
  struct Value {
    std::string name;
    std::string text;
    std::string description;
  };
  std::string table;  ///< full name, as in "delaunay/faces"
  RowNumber row = 0;
  std::vector<Value> values;
};

struct Provenance {
  std::uint64_t ticket = 0;
  VariantLayer layer{};               ///< layer where the element was found
  std::vector<ProvenanceLine> lines;  ///< the element itself first; empty if nothing was found
  std::vector<ProvenanceRow> rows;    ///< only for a story: inputs before consumers
};

}  // namespace mes
