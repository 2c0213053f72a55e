// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/contours.h"

#include <numbers>

#include "core/base/geometry/angle.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_contours_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  const auto& contours = set.get<Contours>();
  return make_layer(
      {.id = "contours",
       .name = "Contours",
       .tooltip = "The order of the samples along curves as the file gave it, or as it was edited; the "
                  "number is the direction from each sample to the next, counter-clockwise from the right",
       .group = LayerGroup::samples,
       .scalar = "direction in degrees",
       .style = {.color = palette::orange, .opacity = 0.7, .line_width_px = 3},
       .kinds = {PrimitiveKind::segment}},
      {&samples, &contours},
      table_part(
          {PrimitiveKind::segment}, [&contours] { return contours.row_count(); }, contours.changes(),
          [&samples, &contours](ContourSlot row, Instance& out) {
            if (!contours.has_link(row)) return;
            const auto [from, to] = contours.link(row);
            const Vec2 along = samples.position(to) - samples.position(from);
            out.segment(samples.position(from), samples.position(to), angle_of(along) * (180.0 / std::numbers::pi));
          },
          ElementType{ElementKind::contour_link, &contours}));
}

}  // namespace mes
