// SPDX-License-Identifier: GPL-3.0-or-later
// Creates columns from the data of a structure, one line each; the C++ type determines type, width and stride.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/base/table.h"
#include "core/graph/table_columns.h"

namespace mes {

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Maps a C++ type to a column: `type`, `width`, the names of `parts`, and whether values are row numbers.
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

/// The table that row numbers of a column refer to, and the row number of the vertex at infinity there, if it occurs.
/// Keeps a reference to the name.
struct RowsOf {
  std::string_view table;
  std::optional<RowNumber> infinity;
  RowsOf(const std::string& name) : table(name) {}  // NOLINT(google-explicit-constructor): most have no infinity
  RowsOf(std::string_view name, RowNumber at_infinity) : table(name), infinity(at_infinity) {}
};

/// The part of `TableMaker` that is the same for all kinds of rows.
class AnyTableMaker {
 public:
  void set_kind(ElementKind kind) { table_.kind = kind; }
  void set_rows_of(std::string table) { table_.rows_of = std::move(table); }
  TableColumns take();

 protected:
  struct ValueShape {
    ColumnType type;
    unsigned width;
    std::span<const std::string_view> parts;
    bool is_reference;
  };
  template <class Value>
  static constexpr ValueShape shape_of() {
    using Traits = ColumnTraits<Value>;
    static_assert(sizeof(Value) == Traits::width * size_of(Traits::type));
    return {Traits::type, Traits::width, Traits::parts, Traits::is_reference};
  }

  AnyTableMaker(std::string_view name, std::string_view description, std::function<bool(RowNumber)> is_alive);
  void set_rows(std::size_t rows) { table_.rows = rows; }
  void set_rows(std::function<std::size_t()> rows);
  void set_changes(std::function<RowChanges()> changes);
  void limit_rows(const std::function<std::size_t()>& size);
  TableColumn& add(std::string_view name, std::string_view description, const ValueShape& shape);
  TableColumn& add_stored(std::string_view name, std::string_view description, const ValueShape& shape,
                          std::size_t stride, const std::function<std::size_t()>& size,
                          const std::function<const void*()>& address);
  /// `read` is called with `kNoRow` if the row is not alive.
  TableColumn& add_read(std::string_view name, std::string_view description, const ValueShape& shape,
                        std::function<void(RowNumber, void*)> read);
  // An assertion fails if a structure lists row numbers as plain values; a reference must name its table.
  static TableColumn& plain(TableColumn& column);
  static TableColumn& boolean(TableColumn& column);
  static TableColumn& refer(TableColumn& column, const RowsOf& target);

 private:
  struct Refresh;
  TableColumns table_;
  std::shared_ptr<Refresh> refresh_;  // null if the table cannot be refreshed
};

/// Makes a `TableColumns` whose rows are slots of one kind.
///
/// Guarantees: every stored column has at least as many rows as the table; a column of row numbers names the
/// table that they index.
///
/// Smallest use:
///     TableMaker<FaceSlot> faces("faces", "Triangles", face_.size(), [this](FaceSlot face) { return is_face(face); });
///     faces.column("circumradius", "radius of the circumcircle", face_, &FaceRow::radius);
///     faces.reference("corners", "counter-clockwise", face_, &FaceRow::v, table_name(id(), "sites"));
///     return taken(faces);
template <class Row>
class TableMaker : public AnyTableMaker {
 public:
  /// `rows` is the number of rows, or a function that returns it. A table with a function can be refreshed; its columns
  /// and change sets must then be members of the structure, or live as long as it.
  template <class Rows, class IsAlive>
  TableMaker(std::string_view name, std::string_view description, Rows rows, IsAlive is_alive)
      : AnyTableMaker(name, description,
                      [is_alive = std::move(is_alive)](RowNumber row) -> bool { return is_alive(Row(row)); }) {
    set_rows(std::move(rows));
  }

  void set_changes(const ChangeSet<Row>& changes) { set_changes_of(changes); }
  /// Uses the change set of another table with the same row numbers.
  template <class Other>
  void set_changes_of(const ChangeSet<Other>& changes) {
    AnyTableMaker::set_changes([&changes] { return row_numbers(changes); });
  }
  /// Limits the table to as many rows as there are values.
  template <class Values>
  void limit_rows(const Values& values) {
    AnyTableMaker::limit_rows([&values] { return values.size(); });
  }

  // Stored columns: a table of their own, or a member of each row. Use `reference` for row numbers, and `flag` for
  // bytes that are 0 or 1.
  template <class Value>
  TableColumn& column(std::string_view name, std::string_view description, const Table<Row, Value>& values) {
    return plain(stored(name, description, values.values()));
  }
  template <class Struct, class Value>
  TableColumn& column(std::string_view name, std::string_view description, const Table<Row, Struct>& rows,
                      Value Struct::*member) {
    return plain(stored(name, description, rows.values(), member));
  }
  template <class Struct, class Value>
  TableColumn& column(std::string_view name, std::string_view description, const std::vector<Struct>& rows,
                      Value Struct::*member) {
    return plain(stored(name, description, rows, member));
  }
  TableColumn& flag(std::string_view name, std::string_view description, const Table<Row, std::uint8_t>& values) {
    return boolean(stored(name, description, values.values()));
  }
  template <class Struct>
  TableColumn& flag(std::string_view name, std::string_view description, const Table<Row, Struct>& rows,
                    std::uint8_t Struct::*member) {
    return boolean(stored(name, description, rows.values(), member));
  }
  template <class Value>
  TableColumn& reference(std::string_view name, std::string_view description, const Table<Row, Value>& values,
                         const RowsOf& target) {
    return refer(stored(name, description, values.values()), target);
  }
  template <class Struct, class Value>
  TableColumn& reference(std::string_view name, std::string_view description, const Table<Row, Struct>& rows,
                         Value Struct::*member, const RowsOf& target) {
    return refer(stored(name, description, rows.values(), member), target);
  }
  template <class Struct, class Value>
  TableColumn& reference(std::string_view name, std::string_view description, const std::vector<Struct>& rows,
                         Value Struct::*member, const RowsOf& target) {
    return refer(stored(name, description, rows, member), target);
  }

  // Computed columns, by a function that is called only for live rows.
  template <class ValueOf>
  TableColumn& computed(std::string_view name, std::string_view description, ValueOf value_of) {
    return plain(made(name, description, std::move(value_of)));
  }
  template <class ValueOf>
  TableColumn& computed_reference(std::string_view name, std::string_view description, ValueOf value_of,
                                  const RowsOf& target) {
    return refer(made(name, description, std::move(value_of)), target);
  }

 private:
  template <class Value>
  TableColumn& stored(std::string_view name, std::string_view description, const std::vector<Value>& values) {
    static_assert(!std::same_as<Value, bool>, "bits have no address");
    return add_stored(
        name, description, shape_of<Value>(), sizeof(Value), [&values] { return values.size(); },
        [&values]() -> const void* { return values.data(); });
  }
  template <class Struct, class Value>
  TableColumn& stored(std::string_view name, std::string_view description, const std::vector<Struct>& rows,
                      Value Struct::*member) {
    return add_stored(
        name, description, shape_of<Value>(), sizeof(Struct), [&rows] { return rows.size(); },
        [&rows, member]() -> const void* { return rows.empty() ? nullptr : std::addressof(rows.front().*member); });
  }
  template <class ValueOf>
  TableColumn& made(std::string_view name, std::string_view description, ValueOf value_of) {
    using Value = std::remove_cvref_t<std::invoke_result_t<ValueOf&, Row>>;
    return add_read(name, description, shape_of<Value>(), [value_of = std::move(value_of)](RowNumber row, void* out) {
      const Value value = row == kNoRow ? Value{} : value_of(Row(row));
      std::memcpy(out, &value, sizeof(Value));
    });
  }
};

/// Takes the tables of several makers, which are empty afterwards.
template <class... Rows>
std::vector<TableColumns> taken(TableMaker<Rows>&... makers) {
  std::vector<TableColumns> out;
  (out.push_back(makers.take()), ...);
  return out;
}

}  // namespace mes
