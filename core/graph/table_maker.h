// SPDX-License-Identifier: GPL-3.0-or-later
// Makes columns of what a structure holds: a line a column, whose type, width and stride follow from the C++ type.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/change_set.h"
#include "core/base/disk.h"
#include "core/base/table.h"
#include "core/base/vec2.h"
#include "core/graph/table_columns.h"

namespace mes {

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// How a C++ type is a column: `type`, `width`, the names of `parts`, and whether values are row numbers.
template <class Value>
struct ColumnTraits;

template <ColumnType kType>
struct SingleValue {
  static constexpr ColumnType type = kType;
  static constexpr unsigned width = 1;
  static constexpr std::array<std::string_view, 0> parts{};
  static constexpr bool is_reference = false;
};
template <>
struct ColumnTraits<double> : SingleValue<ColumnType::float64> {};
template <>
struct ColumnTraits<std::uint32_t> : SingleValue<ColumnType::uint32> {};
template <>
struct ColumnTraits<std::uint8_t> : SingleValue<ColumnType::uint8> {};
template <>
struct ColumnTraits<std::int8_t> : SingleValue<ColumnType::int8> {};
template <>
struct ColumnTraits<bool> : SingleValue<ColumnType::boolean> {};
template <class Value>
requires(std::is_enum_v<Value>&& std::same_as<std::underlying_type_t<Value>, std::uint8_t>) struct ColumnTraits<Value>
    : SingleValue<ColumnType::uint8> {
};
template <class Tag>
struct ColumnTraits<Id<Tag>> : SingleValue<ColumnType::uint32> {};
template <class Tag>
struct ColumnTraits<Slot<Tag>> : SingleValue<ColumnType::uint32> {
  static constexpr bool is_reference = true;
};
template <>
struct ColumnTraits<Vec2> : SingleValue<ColumnType::float64> {
  static constexpr unsigned width = 2;
  static constexpr std::array<std::string_view, 2> parts{"x", "y"};
};
template <class Value, std::size_t N>
struct ColumnTraits<std::array<Value, N>> : ColumnTraits<Value> {
  static_assert(ColumnTraits<Value>::width == 1 && N > 1 && N <= 3);
  static constexpr unsigned width = N;
  static constexpr std::array<std::string_view, N> parts = [] {
    constexpr std::array<std::string_view, 3> kNumbers{"0", "1", "2"};
    std::array<std::string_view, N> out;
    std::copy_n(kNumbers.begin(), N, out.begin());
    return out;
  }();
};
template <class Value, std::size_t N>
struct ColumnTraits<Value[N]> : ColumnTraits<std::array<Value, N>> {};

/// The table that row numbers of a column belong to, and the number there of the vertex at infinity, if it occurs.
struct RowsOf {
  std::string table;
  std::optional<RowNumber> infinity;
  RowsOf(std::string name)
      : table(std::move(name)) {}  // NOLINT(google-explicit-constructor): most tables have no infinity
  RowsOf(std::string name, RowNumber at_infinity) : table(std::move(name)), infinity(at_infinity) {}
};

/// Makes a `TableColumns` whose rows are slots of one kind.
///
/// What it guarantees: every stored column has at least as many rows as the table; a column of row numbers names the
/// table that they index.
///
/// Smallest use:
///     TableMaker<FaceSlot> faces("faces", "Triangles", face_.size(), [this](FaceSlot face) { return is_face(face); });
///     faces.column("circumradius", "radius of the circumcircle", face_, &FaceRow::radius);
///     faces.reference("corners", "counter-clockwise", face_, &FaceRow::v, table_name(id(), "sites"));
///     return taken(faces);
template <class Row>
class TableMaker {
 public:
  /// `rows` is the number of rows, or a function that returns it. With a function the table can be refreshed; its
  /// columns and change sets are then members of the structure, or of what it keeps as long as it lives.
  template <class Rows, class IsAlive>
  TableMaker(std::string name, std::string description, Rows rows, IsAlive is_alive) {
    table_.name = std::move(name);
    table_.description = std::move(description);
    if constexpr (std::is_invocable_v<Rows>) {
      table_.rows = rows();
      refresh_ = std::make_shared<Refresh>();
      refresh_->rows = std::move(rows);
    } else {
      table_.rows = rows;
    }
    table_.is_alive = [is_alive = std::move(is_alive)](RowNumber row) -> bool { return is_alive(Row(row)); };
  }

  void set_kind(ElementKind kind) { table_.kind = kind; }
  void set_rows_of(std::string table) { table_.rows_of = std::move(table); }
  void set_changes(const ChangeSet<Row>& changes) { set_changes_of(changes); }
  /// The change set of another table with the same row numbers.
  template <class Other>
  void set_changes_of(const ChangeSet<Other>& changes) {
    table_.changes = {numbers(changes.touched), numbers(changes.removed)};
    if (refresh_)
      refresh_->changes = [&changes] { return RowChanges{numbers(changes.touched), numbers(changes.removed)}; };
  }
  /// The table has no more rows than these values.
  template <class Values>
  void limit_rows(const Values& values) {
    table_.rows = std::min(table_.rows, values.size());
    if (refresh_) refresh_->limits.push_back([&values] { return values.size(); });
  }

  // Columns that are stored: as a table of their own, or as a member of each row. `reference` is for row numbers, and
  // `flag` for bytes that are 0 or 1.
  template <class Value>
  TableColumn& column(std::string name, std::string description, const Table<Row, Value>& values) {
    return plain(stored(std::move(name), std::move(description), values.values()));
  }
  template <class Struct, class Value>
  TableColumn& column(std::string name, std::string description, const Table<Row, Struct>& rows,
                      Value Struct::*member) {
    return plain(stored(std::move(name), std::move(description), rows.values(), member));
  }
  template <class Struct, class Value>
  TableColumn& column(std::string name, std::string description, const std::vector<Struct>& rows,
                      Value Struct::*member) {
    return plain(stored(std::move(name), std::move(description), rows, member));
  }
  TableColumn& flag(std::string name, std::string description, const Table<Row, std::uint8_t>& values) {
    return boolean(stored(std::move(name), std::move(description), values.values()));
  }
  template <class Struct>
  TableColumn& flag(std::string name, std::string description, const Table<Row, Struct>& rows,
                    std::uint8_t Struct::*member) {
    return boolean(stored(std::move(name), std::move(description), rows.values(), member));
  }
  template <class Value>
  TableColumn& reference(std::string name, std::string description, const Table<Row, Value>& values,
                         const RowsOf& target) {
    return refer(stored(std::move(name), std::move(description), values.values()), target);
  }
  template <class Struct, class Value>
  TableColumn& reference(std::string name, std::string description, const Table<Row, Struct>& rows,
                         Value Struct::*member, const RowsOf& target) {
    return refer(stored(std::move(name), std::move(description), rows.values(), member), target);
  }
  template <class Struct, class Value>
  TableColumn& reference(std::string name, std::string description, const std::vector<Struct>& rows,
                         Value Struct::*member, const RowsOf& target) {
    return refer(stored(std::move(name), std::move(description), rows, member), target);
  }

  // Columns that are computed, by a function of the row, which is asked for rows that are alive.
  template <class ValueOf>
  TableColumn& computed(std::string name, std::string description, ValueOf value_of) {
    return plain(made(std::move(name), std::move(description), std::move(value_of)));
  }
  template <class ValueOf>
  TableColumn& computed_reference(std::string name, std::string description, ValueOf value_of, const RowsOf& target) {
    return refer(made(std::move(name), std::move(description), std::move(value_of)), target);
  }

  TableColumns take() {
    if (refresh_) table_.refresh = [refresh = std::move(refresh_)](TableColumns& table) { refresh->apply(table); };
    return std::move(table_);
  }

 private:
  /// Functions that read where everything is now.
  struct Refresh {
    std::function<std::size_t()> rows;
    std::vector<std::function<std::size_t()>> limits;
    std::vector<std::pair<std::size_t, std::function<const void*()>>> columns;  // by their places
    std::function<RowChanges()> changes;

    void apply(TableColumns& table) const {
      table.rows = rows();
      for (const auto& limit : limits) table.rows = std::min(table.rows, limit());
      for (const auto& [column, address] : columns) table.columns[column].data = address();
      if (changes) table.changes = changes();
    }
  };

  std::size_t index_of_last() const { return table_.columns.size() - 1; }
  template <class Other>
  static std::span<const RowNumber> numbers(const std::vector<Other>& rows) {
    static_assert(std::is_standard_layout_v<Other> && sizeof(Other) == sizeof(RowNumber));
    return {reinterpret_cast<const RowNumber*>(rows.data()), rows.size()};
  }
  template <class Value>
  TableColumn& add(std::string name, std::string description) {
    using Traits = ColumnTraits<Value>;
    static_assert(sizeof(Value) % Traits::width == 0);
    TableColumn column{.name = std::move(name),
                       .description = std::move(description),
                       .type = Traits::type,
                       .width = Traits::width,
                       .parts = Traits::parts,
                       .is_reference = Traits::is_reference};
    MES_ASSERT(column.row_size() == sizeof(Value));
    return table_.columns.emplace_back(std::move(column));
  }
  template <class Value>
  TableColumn& stored(std::string name, std::string description, const std::vector<Value>& values) {
    static_assert(!std::same_as<Value, bool>, "bits have no address");
    TableColumn& column = add<Value>(std::move(name), std::move(description));
    column.stride = sizeof(Value);
    column.data = values.data();
    limit_rows(values);
    if (refresh_)
      refresh_->columns.emplace_back(index_of_last(), [&values]() -> const void* { return values.data(); });
    return column;
  }
  template <class Struct, class Value>
  TableColumn& stored(std::string name, std::string description, const std::vector<Struct>& rows,
                      Value Struct::*member) {
    TableColumn& column = add<Value>(std::move(name), std::move(description));
    const auto address = [&rows, member]() -> const void* {
      return rows.empty() ? nullptr : std::addressof(rows.front().*member);
    };
    column.stride = sizeof(Struct);
    column.data = address();
    limit_rows(rows);
    if (refresh_) refresh_->columns.emplace_back(index_of_last(), address);
    return column;
  }
  template <class ValueOf>
  TableColumn& made(std::string name, std::string description, ValueOf value_of) {
    using Value = std::remove_cvref_t<std::invoke_result_t<ValueOf&, Row>>;
    TableColumn& column = add<Value>(std::move(name), std::move(description));
    column.read = [is_alive = table_.is_alive, value_of = std::move(value_of)](RowNumber row, void* out) {
      const Value value = is_alive(row) ? value_of(Row(row)) : Value{};
      std::memcpy(out, &value, sizeof(Value));
    };
    return column;
  }
  // The assertion fails when a structure lists row numbers as plain values; a reference has to name its table.
  static TableColumn& plain(TableColumn& column) {
    MES_ASSERT(!column.is_reference);
    return column;
  }
  static TableColumn& boolean(TableColumn& column) {
    column.type = ColumnType::boolean;
    return column;
  }
  static TableColumn& refer(TableColumn& column, const RowsOf& target) {
    MES_ASSERT(column.is_reference);
    column.refers_to = target.table;
    column.infinity = target.infinity;
    return column;
  }

  TableColumns table_;
  std::shared_ptr<Refresh> refresh_;  // null: it cannot be refreshed
};

/// The tables of several makers, which are empty afterwards.
template <class... Rows>
std::vector<TableColumns> taken(TableMaker<Rows>&... makers) {
  std::vector<TableColumns> out;
  (out.push_back(makers.take()), ...);
  return out;
}

}  // namespace mes
