// SPDX-License-Identifier: GPL-3.0-or-later
// What the layers of a union of balls have in common: each exists once for every family of balls.
//
// A file here defines `Layer make_union_name_layer(const UnionFamily&)`; core/layers/CMakeLists.txt lists it once,
// and the registration makes a layer of it for each family, with the family's letter before id and name.
#pragma once

#include <string>

#include "core/layers/helpers.h"
#include "core/structures/ball_union.h"

namespace mes {

struct UnionFamily {
  char letter;  ///< 'A'
  const BallUnion& balls;
  LayerGroup group;
  bool in_paper;  ///< the paper has this family
};

/// Text that lives as long as the program.
std::string_view keep_text(std::string text);

/// A layer of the family. `id` and `name` without the letter: "v-points" becomes "a-v-points".
template <class... Parts>
Layer union_layer(const UnionFamily& family, LayerDescriptor descriptor, Parts... parts) {
  const char small = static_cast<char>(family.letter - 'A' + 'a');
  descriptor.id = keep_text(std::string(1, small) + '-' + std::string(descriptor.id));
  descriptor.name = keep_text(std::string(1, family.letter) + ' ' + std::string(descriptor.name));
  descriptor.group = family.group;
  descriptor.in_paper = descriptor.in_paper && family.in_paper;
  return make_layer(std::move(descriptor), {&family.balls}, std::move(parts)...);
}

/// Part over a table of the union: `emit(row of the table, instance)`.
template <class Table, class Emit>
auto union_part(std::vector<PrimitiveKind> kinds, const BallUnion& balls, Table UnionTables::*table,
                const ChangeSet& changes, Emit emit) {
  return table_part(
      std::move(kinds), [&balls, table] { return (balls.tables().*table).size(); }, changes,
      [&balls, table, emit](Slot row, Instance& out) { emit((balls.tables().*table)[row], out); });
}

}  // namespace mes
