// SPDX-License-Identifier: GPL-3.0-or-later
// CSV: columns separated by commas, or by semicolons if the comma is the decimal sign.
#include "core/io/format_spec.h"
#include "core/io/tables/xy_table.h"

namespace mes {
namespace {

Match match_csv(std::string_view bytes) {
  const auto kind = recognise_table(bytes);
  return kind && (kind->separator == TableSeparator::comma || kind->separator == TableSeparator::semicolon)
             ? Match::maybe
             : Match::no;
}

}  // namespace

Format csv_format() {
  return {.descriptor = {.id = "csv", .name = "Comma separated values", .extensions = {".csv"}, .can_read = true},
          .match = match_csv,
          .read = read_xy_table};
}

}  // namespace mes
