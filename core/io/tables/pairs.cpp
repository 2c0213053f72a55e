// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of numbers separated by blanks, one pair a line.
#include "core/io/format_spec.h"
#include "core/io/tables/xy_table.h"

namespace mes {
namespace {

Match match_pairs(std::string_view bytes) {
  const auto kind = recognise_table(bytes);
  return kind && kind->separator == TableSeparator::blanks ? Match::maybe : Match::no;
}

}  // namespace

Format pairs_format() {
  return {.descriptor = {.id = "pairs",
                         .name = "Plain pairs of numbers",
                         .extensions = {".txt", ".dat", ".xy", ".pts"},
                         .can_read = true},
          .match = match_pairs,
          .read = read_xy_table};
}

}  // namespace mes
