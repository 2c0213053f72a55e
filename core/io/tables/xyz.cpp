// SPDX-License-Identifier: GPL-3.0-or-later
// XYZ: three or more columns separated by blanks; the third, a height, is left out.
#include "core/io/format_spec.h"
#include "core/io/tables/xy_table.h"

namespace mes {
namespace {

Match match_xyz(std::string_view bytes) {
  const auto kind = recognise_table(bytes);
  return kind && kind->separator == TableSeparator::blanks && kind->columns >= 3 ? Match::maybe : Match::no;
}

}  // namespace

Format xyz_format() {
  return {.descriptor = {.id = "xyz", .name = "XYZ points", .extensions = {".xyz"}, .can_read = true},
          .match = match_xyz,
          .read = read_xy_table};
}

}  // namespace mes
