// SPDX-License-Identifier: GPL-3.0-or-later
// Columns describe the tables of a structure to code that does not know the structure: writers of files, the card,
// bindings of other languages.
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
#include "core/base/slot.h"
#include "core/graph/element.h"

namespace mes {

/// A boolean is one byte, 0 or 1.
enum class ColumnType : std::uint8_t { float64, uint32, uint8, int8, boolean };
/// "float64", as NumPy calls it.
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

/// In a column of row numbers, the number of no row.
inline constexpr RowNumber kNoRow = 0xffffffffU;

/// One value, or a few, for each row of a table.
///
/// A column is *stored* where its values lie in the memory of the structure: those of row i are at `data` + i `stride`,
/// side by side. Otherwise it is *computed*, and `read` makes them.
struct TableColumn {
  std::string name{};         ///< in snake case
  std::string description{};  ///< one line without a full stop, with the unit
  ColumnType type = ColumnType::float64;
  unsigned width = 1;                         ///< values a row
  std::span<const std::string_view> parts{};  ///< names of these values; empty for one value
  std::size_t stride = 0;                     ///< bytes from row to row, if it is stored
  const void* data = nullptr;                 ///< the first row, if it is stored; null without rows
  std::function<void(RowNumber row, void* out)> read{};
  /// Values are rows of the table `refers_to`, which is empty where that table has no columns; `kNoRow` is none.
  bool is_reference = false;
  std::string refers_to{};              ///< as in "delaunay/sites"
  std::optional<RowNumber> infinity{};  ///< the number of the vertex at infinity, in a column where it occurs
  /// The change sets of the table name each row in which the column differs from before.
  bool is_followed = true;

  bool is_stored() const { return !read; }
  /// Bytes that the values of a row have side by side.
  std::size_t row_size() const { return width * size_of(type); }
  /// Copies the values of a row to `out`, which has room for `row_size` bytes.
  void copy_row(RowNumber row, void* out) const;
  /// The name of one of its values: that of the column, and for several that of the part behind it.
  std::string name_of(unsigned part) const;
};

/// Rows that may differ from before the last run, as in `ChangeSet`; a touched row need not be alive in the table. Both
/// are empty after a rebuild, which makes every row new.
struct RowChanges {
  std::span<const RowNumber> touched;
  std::span<const RowNumber> removed;
};

/// Slots are row numbers and nothing else.
template <class Row>
std::span<const RowNumber> row_numbers(const std::vector<Row>& rows) {
  static_assert(std::is_standard_layout_v<Row> && sizeof(Row) == sizeof(RowNumber));
  return {reinterpret_cast<const RowNumber*>(rows.data()), rows.size()};
}
template <class Row>
RowChanges row_numbers(const ChangeSet<Row>& changes) {
  return {row_numbers(changes.touched), row_numbers(changes.removed)};
}

/// What it guarantees, as long as the structure is up to date:
///  1. Every column can be read for each row below `rows`. Values of rows that are not alive mean nothing.
///  2. A row number of a column that says `refers_to` is a row that is alive there, unless it is none or infinity.
///  3. Where a computed column has no value for a row that is alive, a double is not a number and a row number is
///     `kNoRow`. Of a stored column the description says which rows have a value.
///  4. What points into a structure is valid until the next run of its graph.
///
/// Threads: const is safe while the graph does not run.
///
/// Smallest use:
///     for (const TableColumns& table : structure.table_columns())
///       for (RowNumber row = 0; row < table.rows; ++row)
///         if (table.is_alive(row)) print(table.columns.front(), row);
struct TableColumns {
  std::string name;         ///< in snake case, unique in its structure
  std::string description;  ///< one line without a full stop
  /// The table whose rows these are, as in "delaunay/faces"; empty if they are rows of their own. Its rows that are not
  /// alive here have no values here.
  std::string rows_of;
  std::size_t rows = 0;  ///< dead ones included
  std::vector<TableColumn> columns;
  std::function<bool(RowNumber row)> is_alive;
  std::optional<RowChanges> changes;  ///< none: the structure does not say which rows differ
  /// Brings addresses, number of rows and changes to what they are after a later run, at a fraction of the cost of making
  /// all anew. Valid as long as the structure lives; empty where that is not possible.
  std::function<void(TableColumns& table)> refresh;
  ElementKind kind = ElementKind::other;  ///< of the rows, as layers draw them
};

/// "delaunay/faces".
std::string table_name(std::string_view structure, std::string_view table);

}  // namespace mes
