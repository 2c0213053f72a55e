// SPDX-License-Identifier: GPL-3.0-or-later
// TSV: columns separated by tabs.
#include "core/io/format_spec.h"
#include "core/io/tables/xy_table.h"

namespace mes {
namespace {

Match match_tsv(std::string_view bytes) {
  const auto kind = recognise_table(bytes);
  return kind && kind->separator == TableSeparator::tabulator ? Match::maybe : Match::no;
}

}  // namespace

Format tsv_format() {
  return {
      .descriptor = {.id = "tsv", .name = "Tab separated values", .extensions = {".tsv", ".tab"}, .can_read = true},
      .match = match_tsv,
      .read = read_xy_table};
}

}  // namespace mes
