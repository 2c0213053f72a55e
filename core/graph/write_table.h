// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the columns of a table for other programs.
//
// Smallest use:
//     std::string text;
//     write_table(table, TableFormat::csv, [&](std::string_view piece) { text += piece; });
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/graph/table_columns.h"

namespace mes {

enum class TableFormat : std::uint8_t { csv, npy };
std::string_view name_of(TableFormat format);
std::optional<TableFormat> find_table_format(std::string_view name);

/// Receives the bytes of a file piece by piece. An exception from it ends the writing.
using TableSink = std::function<void(std::string_view bytes)>;

/// `csv`: a header line, then one line for each live row. The first field is the row number; a missing value is an
/// empty field, booleans are 0 and 1, infinity is `inf`. A double has the shortest digits that read back as the same
/// double. Columns of several values have a field for each, as in `position_x`.
///
/// `npy`: a NumPy structured array, format version 1.0, little endian. It has all rows, including dead ones, so that
/// row numbers are indices; the first field `is_alive` tells them apart. Columns of several values are sub-arrays. Row
/// numbers are not converted: 4294967295 means no row.
///
/// Uses about 64 KiB of memory; O(values).
void write_table(const TableColumns& table, TableFormat format, const TableSink& sink);

/// The values of one row as text, in the order of the columns; values of one column are separated by ", ".
std::vector<std::string> row_texts(const TableColumns& table, RowNumber row);

}  // namespace mes
