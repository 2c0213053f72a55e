// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/inputs/samples.h"

namespace mes {

// The program that draws the layers writes the numbers, because the space for them depends on the view.
Layer make_indices_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  return make_layer({.id = "indices",
                     .name = "Indices",
                     .tooltip = "The indices of the samples, from 0; where they would overlap, only the rounder ones",
                     .group = LayerGroup::samples,
                     .points_as = PointsAs::numbers,
                     .style = {.color = palette::black, .point_size_px = 13},
                     .kinds = {PrimitiveKind::point}},
                    {&samples},
                    table_part(
                        {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
                        [&samples](SampleSlot row, Instance& out) {
                          if (samples.is_alive(row)) out.point(samples.position(row));
                        },
                        ElementType{ElementKind::sample}));
}

}  // namespace mes
