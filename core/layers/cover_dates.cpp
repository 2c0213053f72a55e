// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/cover_dates.h"

#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_cover_dates_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& dates = set.get<CoverDates>();
  return make_layer({.id = "cover-dates",
                     .name = "Cover dates",
                     .tooltip = "Centres of the inner balls, with 1 - 1/s, where s is the growth factor at which "
                                "another grown ball swallows them; 1: never",
                     .group = LayerGroup::scale_axis,
                     .scalar = "1 - 1/s",
                     .style = {.color = palette::orange, .point_size_px = 5, .color_map = "viridis"},
                     .kinds = {PrimitiveKind::point}},
                    {&delaunay, &dates},
                    faces_part({PrimitiveKind::point}, delaunay, dates.changes(), [&](FaceSlot face, Instance& out) {
                      if (dates.has_date(face)) out.point(delaunay.circumcenter(face), 1.0 - 1.0 / dates.date(face));
                    }));
}

}  // namespace mes
