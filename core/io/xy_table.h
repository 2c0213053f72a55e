// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of coordinates as people keep them: csv, tsv, xyz, plain pairs. One reader finds out how a table is written;
// the formats differ in their names only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/format.h"
#include "core/io/read_job.h"

namespace mes {

/// How the columns of a table are kept apart.
enum class TableSeparator : std::uint8_t { semicolon, tabulator, comma, blanks };

struct TableKind {
  TableSeparator separator = TableSeparator::blanks;
  bool decimal_comma = false;
  std::size_t columns = 0;  ///< of the first row of numbers
};

/// What the table is, judged by its first two lines; nothing when they hold no two columns of numbers.
std::optional<TableKind> recognise_table(std::string_view bytes);

/// Reads a table: one sample a row, `#` lines and blank lines left out.
///
///  1. A first line without any number is a header. Columns called x and y (or lon and lat, easting and northing)
///     are taken if there are such, else the first two that do not number something.
///  2. Columns called contour, ring, polygon, part, path, id ... put the rows of equal value on one contour. A
///     contour whose last point repeats its first is closed, and the repetition is dropped; without repetitions in
///     the whole file the name of the column decides. Without such columns a repetition of the first row by the last
///     closes the one contour that all rows make.
///  3. Further columns are ignored. With `;` or tabulators between columns a decimal comma is understood; so it is
///     between blanks when the first row has one in both columns.
///
/// Cost: linear; 10^6 rows well below a second. Error: `bad_input` with line and column of the field.
Expected<LoadedFile> read_xy_table(std::string_view bytes, const std::string& name, ReadJob& job);

}  // namespace mes
