// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the instance of a layer at a position.
#pragma once

#include <limits>
#include <optional>

#include "core/draw/provenance.h"
#include "core/graph/element.h"

namespace mes {

/// The best instance so far. Points win over lines, lines over areas. Among points or lines the nearest wins, among
/// areas that contain the position the smallest.
class HitSearch {
 public:
  HitSearch(Vec2 at, double reach) : at_(at), reach_(reach) {}
  /// `values` as in core/draw/primitives.h.
  void look_at(PrimitiveKind kind, const double* values, ElementType type, RowNumber row);

  struct Hit {
    Element element;
    ProvenanceShape shape;
  };
  const std::optional<Hit>& best() const { return best_; }

 private:
  Vec2 at_;
  double reach_;
  int best_rank_ = 3;  ///< 0 point, 1 line, 2 area
  double best_measure_ = std::numeric_limits<double>::infinity();
  std::optional<Hit> best_;
};

}  // namespace mes
