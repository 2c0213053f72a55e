// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/inputs/samples.h"

namespace mes {

Layer make_points_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  return make_layer({.id = "points",
                     .name = "Points",
                     .tooltip = "The sample points",
                     .group = LayerGroup::samples,
                     .data = LayerData::samples,
                     .in_paper = true,
                     .visible_at_start = true,
                     .scalar = "id",
                     .scalars_are_names = true,
                     .style = {.color = palette::black, .point_size_px = 5},
                     .kinds = {PrimitiveKind::point}},
                    {&samples},
                    table_part(
                        {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
                        [&samples](SampleSlot row, Instance& out) {
                          if (samples.is_alive(row)) out.point(samples.position(row), samples.id(row).value);
                        },
                        ElementType{ElementKind::sample}));
}

}  // namespace mes
