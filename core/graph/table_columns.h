// SPDX-License-Identifier: GPL-3.0-or-later
// Columns describe the tables of a structure for code that does not know the structure: file writers, the info card,
// bindings for other languages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/ids.h"
#include "core/graph/element.h"

namespace mes {

/// Type of the values in a column. A boolean is one byte, 0 or 1.
enum class ColumnType : std::uint8_t { float64, uint32, uint8, int8, boolean };
/// The name in NumPy, such as "float64".
std::string_view name_of(ColumnType type);
constexpr std::size_t size_of(ColumnType type) {
  switch (type) {
    case ColumnType::float64: return 8;
    case ColumnType::uint32: return 4;
    case ColumnType::uint8:
    case ColumnType::int8:
    case ColumnType::boolean: return 1;
  }
  return 0;
}

/// The value in a column of row numbers that means "no row".
inline constexpr RowNumber kNoRow = 0xffffffffU;

/// One value, or a few, for each row of a table.
///
/// A column is *stored* if its values lie in the memory of the structure: those of row i are at `data` + i `stride`,
/// side by side. Otherwise it is *computed* by `read`.
struct TableColumn {
  std::string name{};         ///< in snake case
  std::string description{};  ///< one line without a full stop, with the unit
  ColumnType type = ColumnType::float64;
  unsigned width = 1;                         ///< number of values in each row
  std::span<const std::string_view> parts{};  ///< names of these values; empty for a single value
  std::size_t stride = 0;                     ///< bytes from row to row, if stored
  const void* data = nullptr;                 ///< the first row, if stored; null without rows
  std::function<void(RowNumber row, void* out)> read{};
  /// Values are rows of the table `refers_to`, which is empty if that table has no columns; `kNoRow` means no row.
  bool is_reference = false;
  std::string refers_to{};              ///< full name, as in "delaunay/sites"
  std::optional<RowNumber> infinity{};  ///< row number of the vertex at infinity, if the column contains it
  /// True if some pairs x, y may be directions, which lie nowhere on a map; otherwise all are positions.
  bool has_directions = false;
  /// Whether the change sets of the table name each row in which the column changed.
  bool is_followed = true;

  bool is_stored() const { return !read; }
  /// Bytes of the values of one row, side by side.
  std::size_t row_size() const { return width * size_of(type); }
  /// Copies the values of a row to `out`, which has room for `row_size` bytes.
  void copy_row(RowNumber row, void* out) const;
  /// The name of one of its values: that of the column, with the part appended if there are several.
  std::string name_of(unsigned part) const;
};

/// Rows that may have changed in the last run, as in `ChangeSet`; a touched row need not be alive in the table. Both
/// are empty after a rebuild, which makes every row new.
struct RowChanges {
  std::span<const RowNumber> touched;
  std::span<const RowNumber> removed;
};

/// Views slots as row numbers, which have the same layout.
template <class Row>
std::span<const RowNumber> row_numbers(const std::vector<Row>& rows) {
  static_assert(std::is_standard_layout_v<Row> && sizeof(Row) == sizeof(RowNumber));
  return {reinterpret_cast<const RowNumber*>(rows.data()), rows.size()};
}
template <class Row>
RowChanges row_numbers(const ChangeSet<Row>& changes) {
  return {row_numbers(changes.touched), row_numbers(changes.removed)};
}

/// Guarantees, as long as the structure is up to date:
///  1. Every column can be read for each row below `rows`. Values of dead rows have no meaning.
///  2. A row number in a column with `refers_to` is a live row there, unless it means "no row" or infinity.
///  3. If a computed column has no value for a live row, a double is NaN and a row number is `kNoRow`. For a stored
///     column the description says which rows have a value.
///  4. Pointers into a structure are valid until the next run of its graph.
///
/// Threads: const members are safe while the graph does not run.
///
/// Smallest use:
///     for (const TableColumns& table : structure.table_columns())
///       for (RowNumber row = 0; row < table.rows; ++row)
///         if (table.is_alive(row)) print(table.columns.front(), row);
struct TableColumns {
  std::string name;         ///< in snake case, unique in its structure
  std::string description;  ///< one line without a full stop
  /// The table whose rows these are, as in "delaunay/faces"; empty for a table with its own rows. Rows that are dead
  /// there have no values here.
  std::string rows_of;
  std::size_t rows = 0;  ///< includes dead rows
  std::vector<TableColumn> columns;
  std::function<bool(RowNumber row)> is_alive;
  std::optional<RowChanges> changes;  ///< unset: the structure does not report changed rows
  /// Updates addresses, number of rows and changes after a later run, much faster than creating the columns again.
  /// Valid as long as the structure lives; empty if that is not possible.
  std::function<void(TableColumns& table)> refresh;
  ElementKind kind = ElementKind::other;  ///< element kind of the rows in layers
};

/// The full name of a table, as in "delaunay/faces".
std::string table_name(std::string_view structure, std::string_view table);

}  // namespace mes
