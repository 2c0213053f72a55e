// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of coordinates in common formats: csv, tsv, xyz, plain pairs. One reader detects the layout of a table; the
// formats differ only in their names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/format.h"
#include "core/io/text/read_job.h"

namespace mes {

/// The separator between columns.
enum class TableSeparator : std::uint8_t { semicolon, tabulator, comma, blanks };

struct TableKind {
  TableSeparator separator = TableSeparator::blanks;
  bool decimal_comma = false;
  std::size_t columns = 0;  ///< number of columns in the first row of numbers
};

/// The layout of the table, from its first two lines; nothing if they do not contain two columns of numbers.
std::optional<TableKind> recognise_table(std::string_view bytes);

/// Reads a table: one sample a row, without `#` lines and blank lines.
///
///  1. A first line without any number is a header. Columns called x and y (or lon and lat, easting and northing) are
///     used if present, else the first two that are not row numbers. Degrees of columns called lon or longitude and
///     lat or latitude are marked as such (`LoadedFile::has_degrees`), and become a map on WGS 84.
///  2. Columns called contour, ring, polygon, part, path, id ... put rows with the same value on one contour. A contour
///     whose last point repeats its first is closed, and the repetition is dropped; if the whole file has no
///     repetitions, the name of the column decides. Without such columns, if the last row repeats the first, all rows
///     are one closed contour.
///  3. Further columns are ignored. With `;` or tabs between columns, decimal commas are recognised; with blanks, only
///     if the first row has one in both columns.
///
/// Cost: linear; 10^6 rows well below a second. Error: `bad_input` with line and column of the field.
Expected<LoadedFile> read_xy_table(std::string_view bytes, const std::string& name, ReadJob& job);

}  // namespace mes
