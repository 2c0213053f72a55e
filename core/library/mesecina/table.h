// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of structures: typed columns that are read in place.
//
// A structure, such as the Delaunay triangulation, publishes one table for each kind of its elements. A row is one
// element and keeps its number while the element lives; rows of dead elements are reused, so some rows of a table are
// not alive. `Catalogue::structures` lists the tables and their columns.
//
// Guarantees:
//  1. `Column::values` copies nothing: it views the memory of the structure. Values are returned by copy, so the view
//     has no aliasing rules of its own.
//  2. Every column can be read for each row below `rows()`. Values of rows that are not alive mean nothing.
//  3. A row number in a column that refers to a table is a live row there, or `kNoRow`, or the column's `infinity`. If
//     a computed column has no value for a live row, a double is NaN and a row number `kNoRow`.
//  4. A table is valid until a run computes its structure, or one of its inputs, and while the structure is needed.
//     Edits without a run, and runs without changes, do not move it. Reading it afterwards throws `usage`; `is_current`
//     tells in advance. Pointers and `Values` taken earlier then dangle, as iterators do.
//  5. A table stays safe to destroy and to ask `is_current` after its workbench is gone.
//
// Smallest use:
//     const mesecina::Table faces = bench.table("delaunay/faces");
//     const auto is_finite = faces.column("is_finite").copy<bool>();
//     const auto radius = faces.column("circumradius").values<double>();
//     for (const mesecina::Row row : faces.live_rows())
//       if (is_finite[row]) sum += radius[row];
//
// Cost: a table O(its columns) and a view O(1). Reading a stored value costs a load; a computed value, a call.
// Threads: several threads may read tables of one workbench while no run is in progress.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <mesecina/geometry.h>
#include <mesecina/version.h>

namespace mesecina {
inline namespace v1 {

/// Number of a row of a table.
using Row = std::uint32_t;
/// Stands for no row in a column of row numbers.
inline constexpr Row kNoRow = 0xffffffffU;

/// A boolean is one byte, 0 or 1.
enum class ColumnType : std::uint8_t { float64 = 0, uint32 = 1, uint8 = 2, int8 = 3, boolean = 4 };
/// "float64", ..., "bool": the names of NumPy.
MESECINA_API std::string_view name_of(ColumnType type) noexcept;
/// Bytes of one value.
MESECINA_API std::size_t size_of(ColumnType type) noexcept;

/// The description of a column.
struct ColumnInfo {
  std::string name{};         ///< in snake case
  std::string description{};  ///< one line without a full stop, with the unit
  ColumnType type = ColumnType::float64;
  unsigned width = 1;                ///< values in a row
  std::vector<std::string> parts{};  ///< names of these values, as in x and y; empty for a width of 1
  bool is_stored = false;            ///< the values are in memory; else each is computed when it is read
  bool is_reference = false;         ///< values are rows of the table `refers_to`
  std::string refers_to{};           ///< as in "delaunay/sites"; empty if that table has no columns
  std::optional<Row> infinity{};     ///< the row that stands for the vertex at infinity, if it occurs
  bool is_followed = true;           ///< `Table::changes` covers this column
};

/// The description of a table.
struct TableInfo {
  std::string id{};           ///< as in "delaunay/faces"
  std::string structure{};    ///< id of the structure
  std::string name{};         ///< in snake case, unique in the structure
  std::string description{};  ///< one line without a full stop
  std::string rows_of{};      ///< id of the table whose row numbers these are; empty if they are its own
  std::vector<ColumnInfo> columns{};
};

/// Defines the C++ types as which a column can be read: its values for a width of 1, `std::array` or `Point` for more.
/// Must not be specialized elsewhere.
template <class T>
struct ColumnValue;
template <>
struct ColumnValue<double> {
  static constexpr ColumnType type = ColumnType::float64;
  static constexpr unsigned width = 1;
};
template <>
struct ColumnValue<std::uint32_t> {
  static constexpr ColumnType type = ColumnType::uint32;
  static constexpr unsigned width = 1;
};
template <>
struct ColumnValue<std::uint8_t> {
  static constexpr ColumnType type = ColumnType::uint8;
  static constexpr unsigned width = 1;
};
template <>
struct ColumnValue<std::int8_t> {
  static constexpr ColumnType type = ColumnType::int8;
  static constexpr unsigned width = 1;
};
template <>
struct ColumnValue<bool> {
  static_assert(sizeof(bool) == 1);
  static constexpr ColumnType type = ColumnType::boolean;
  static constexpr unsigned width = 1;
};
template <>
struct ColumnValue<Point> {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  static constexpr ColumnType type = ColumnType::float64;
  static constexpr unsigned width = 2;
};
template <class T, std::size_t N>
struct ColumnValue<std::array<T, N>> {
  static_assert(ColumnValue<T>::width == 1 && sizeof(std::array<T, N>) == N * sizeof(T));
  static constexpr ColumnType type = ColumnValue<T>::type;
  static constexpr unsigned width = N;
};

/// The values of a stored column, a random access range over all rows, including dead ones. A copy views the same
/// memory. Indices are not checked.
template <class T>
class Values {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  class Iterator {
   public:
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using reference = T;
    using pointer = void;
    using iterator_category = std::input_iterator_tag;
    using iterator_concept = std::random_access_iterator_tag;
    Iterator() = default;
    Iterator(const std::byte* at, std::ptrdiff_t stride) : at_(at), stride_(stride) {}
    T operator*() const { return load(at_); }
    T operator[](difference_type n) const { return load(at_ + n * stride_); }
    Iterator& operator++() { return *this += 1; }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    Iterator& operator--() { return *this -= 1; }
    Iterator operator--(int) {
      const Iterator before = *this;
      --*this;
      return before;
    }
    Iterator& operator+=(difference_type n) {
      at_ += n * stride_;
      return *this;
    }
    Iterator& operator-=(difference_type n) {
      at_ -= n * stride_;
      return *this;
    }
    friend Iterator operator+(Iterator a, difference_type n) { return a += n; }
    friend Iterator operator+(difference_type n, Iterator a) { return a += n; }
    friend Iterator operator-(Iterator a, difference_type n) { return a -= n; }
    friend difference_type operator-(const Iterator& a, const Iterator& b) { return (a.at_ - b.at_) / a.stride_; }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }
    friend auto operator<=>(const Iterator& a, const Iterator& b) { return a.at_ <=> b.at_; }

   private:
    const std::byte* at_ = nullptr;
    std::ptrdiff_t stride_ = static_cast<std::ptrdiff_t>(sizeof(T));
  };

  Values() = default;
  /// `stride` is in bytes.
  Values(const void* data, std::size_t size, std::size_t stride)
      : data_(static_cast<const std::byte*>(data)), size_(size), stride_(stride) {}

  T operator[](std::size_t row) const { return load(data_ + row * stride_); }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const void* data() const { return data_; }
  /// Bytes from row to row.
  std::size_t stride() const { return stride_; }
  bool is_contiguous() const { return stride_ == sizeof(T); }
  Iterator begin() const { return Iterator(data_, static_cast<std::ptrdiff_t>(stride_)); }
  Iterator end() const { return begin() + static_cast<std::ptrdiff_t>(size_); }

 private:
  static T load(const std::byte* at) {
    T out;
    std::memcpy(&out, at, sizeof(T));
    return out;
  }
  const std::byte* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t stride_ = sizeof(T);
};

struct TableAccess;

/// One column of a table. Keeps the description alive, but not the values.
class MESECINA_API Column {
 public:
  ~Column();
  Column(const Column&) noexcept;
  Column& operator=(const Column&) noexcept;

  const ColumnInfo& info() const noexcept;
  const std::string& name() const noexcept { return info().name; }
  std::size_t rows() const;
  /// The first row of a stored column; null without rows. Error: `usage` for a computed column or an outdated table.
  const void* data() const;
  /// Bytes from row to row of a stored column. Error: as `data`.
  std::size_t stride() const;
  /// Copies the values of one row, stored or computed, to `out`, which has room for `width` values. Error: `usage` for
  /// a row that the table does not have or an outdated table.
  void read(Row row, void* out) const;

  /// One value, stored or computed. Error: `usage` if the column has another type or width; as `read`.
  template <class T>
  T value(Row row) const {
    require(ColumnValue<T>::type, ColumnValue<T>::width);
    T out{};
    read(row, &out);
    return out;
  }
  /// Views a stored column. Error: `usage` for a computed column, another type or width, or an outdated table.
  template <class T>
  Values<T> values() const {
    require(ColumnValue<T>::type, ColumnValue<T>::width);
    return Values<T>(data(), rows(), stride());
  }
  /// Copies all rows of a stored or a computed column, including dead ones. Error: as `value`.
  template <class T>
  std::vector<T> copy() const {
    require(ColumnValue<T>::type, ColumnValue<T>::width);
    std::vector<T> out;
    const std::size_t count = rows();
    out.reserve(count);
    for (std::size_t row = 0; row < count; ++row) {
      T value{};
      read(static_cast<Row>(row), &value);
      out.push_back(value);
    }
    return out;
  }

 private:
  friend class Table;
  Column(std::shared_ptr<const TableAccess> table, std::size_t index) noexcept;
  void require(ColumnType type, unsigned width) const;
  std::shared_ptr<const TableAccess> table_;
  std::size_t index_;
};

/// Rows that may differ from before the last run. A touched row need not be alive.
struct RowChanges {
  std::span<const Row> touched{};
  std::span<const Row> removed{};
};

class MESECINA_API Table {
 public:
  ~Table();
  Table(const Table&) noexcept;
  Table& operator=(const Table&) noexcept;

  const TableInfo& info() const noexcept;
  const std::string& id() const noexcept { return info().id; }
  /// Number of all rows, including dead ones. Error, here and below: `usage` for an outdated table.
  std::size_t rows() const;
  /// Error: `usage` for a row that the table does not have.
  bool is_alive(Row row) const;
  /// Live rows by increasing number. O(rows).
  std::vector<Row> live_rows() const;
  std::vector<Column> columns() const;
  /// Error: `usage` for an unknown name.
  Column column(std::string_view name) const;
  /// Rows that the last run changed; empty lists: none. Nothing: any row may differ, because the structure was rebuilt
  /// or does not track its rows, or the previous run was stopped. Each run replaces the changes of the last one. Error:
  /// `usage` if there was a run since the table was made.
  std::optional<RowChanges> changes() const;
  /// Whether the table can be read: guarantee 4 holds for it, no run is in progress, and its workbench lives.
  bool is_current() const noexcept;

  /// Writes the table as a file, piece by piece: "csv" with the live rows after a line of names, or "npy", a NumPy
  /// array of records with all rows. Error: `usage` for another format.
  void write(std::string_view format, const std::function<void(std::string_view bytes)>& sink) const;

 private:
  friend class Inputs;
  friend class Workbench;
  explicit Table(std::shared_ptr<const TableAccess> access) noexcept;
  std::shared_ptr<const TableAccess> access_;
};

}  // namespace v1
}  // namespace mesecina
