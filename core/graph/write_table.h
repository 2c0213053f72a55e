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

/// Takes the bytes of a file piece by piece. What it throws ends the writing.
using TableSink = std::function<void(std::string_view bytes)>;

/// `csv`: one line for each row that is alive, after a line of names. The first field is the number of the row; a value
/// that is none is an empty field, booleans are 0 and 1, infinity is `inf`. A double has the shortest digits that read
/// back as the same double. Columns of several values have a field for each, as in `position_x`.
///
/// `npy`: an array of records as NumPy reads it, version 1.0, little endian. It has all rows, those that are not alive
/// too, so that row numbers are indices; the first field `is_alive` tells them apart. Columns of several values are
/// sub-arrays. Row numbers stay as they are: 4294967295 is none.
///
/// Some 64 KiB of memory; O(values).
void write_table(const TableColumns& table, TableFormat format, const TableSink& sink);

/// The values of one row as text, in the order of the columns; those of one column are separated by ", ".
std::vector<std::string> row_texts(const TableColumns& table, RowNumber row);

}  // namespace mes
