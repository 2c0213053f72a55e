// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesecina/table.h>

#include <fmt/core.h>

#include <exception>
#include <utility>

#include "core/graph/write_table.h"
#include "core/library/internal/adapter.h"
#include "core/library/internal/table_access.h"

namespace mesecina {
inline namespace v1 {
namespace {

ColumnType outer(mes::ColumnType type) {
  switch (type) {
    case mes::ColumnType::float64: return ColumnType::float64;
    case mes::ColumnType::uint32: return ColumnType::uint32;
    case mes::ColumnType::uint8: return ColumnType::uint8;
    case mes::ColumnType::int8: return ColumnType::int8;
    case mes::ColumnType::boolean: break;
  }
  return ColumnType::boolean;
}

ColumnInfo info_of(const mes::TableColumn& column) {
  return {.name = column.name,
          .description = column.description,
          .type = outer(column.type),
          .width = column.width,
          .parts = all_texts(column.parts),
          .is_stored = column.is_stored(),
          .is_reference = column.is_reference,
          .refers_to = column.refers_to,
          .infinity = column.infinity,
          .is_followed = column.is_followed};
}

/// Carries an exception of the caller's callback past the code that called it.
struct ThrownByCaller {
  std::exception_ptr exception;
};

}  // namespace

std::string_view name_of(ColumnType type) noexcept {
  switch (type) {
    case ColumnType::float64: return "float64";
    case ColumnType::uint32: return "uint32";
    case ColumnType::uint8: return "uint8";
    case ColumnType::int8: return "int8";
    case ColumnType::boolean: break;
  }
  return "bool";
}

std::size_t size_of(ColumnType type) noexcept {
  switch (type) {
    case ColumnType::float64: return 8;
    case ColumnType::uint32: return 4;
    case ColumnType::uint8:
    case ColumnType::int8:
    case ColumnType::boolean: break;
  }
  return 1;
}

TableInfo info_of(std::string_view structure, const mes::TableColumns& table) {
  TableInfo out{.id = mes::table_name(structure, table.name),
                .structure = std::string(structure),
                .name = table.name,
                .description = table.description,
                .rows_of = table.rows_of};
  out.columns.reserve(table.columns.size());
  for (const mes::TableColumn& column : table.columns) out.columns.push_back(info_of(column));
  return out;
}

const mes::TableColumns& TableAccess::current() const {
  if (!is_current()) refuse(fmt::format("table {} is outdated: a later run computed its structure", info.id));
  return table;
}

Column::Column(std::shared_ptr<const TableAccess> table, std::size_t index) noexcept
    : table_(std::move(table)), index_(index) {}
Column::~Column() = default;
Column::Column(const Column&) noexcept = default;
Column& Column::operator=(const Column&) noexcept = default;

const ColumnInfo& Column::info() const noexcept {
  return table_->info.columns[index_];
}

std::size_t Column::rows() const {
  return table_->current().rows;
}

const void* Column::data() const {
  const mes::TableColumn& column = table_->current().columns[index_];
  if (!column.is_stored()) refuse(fmt::format("column {} of {} is computed", info().name, table_->info.id));
  return column.data;
}

std::size_t Column::stride() const {
  const mes::TableColumn& column = table_->current().columns[index_];
  if (!column.is_stored()) refuse(fmt::format("column {} of {} is computed", info().name, table_->info.id));
  return column.stride;
}

void Column::read(Row row, void* out) const {
  const mes::TableColumns& table = table_->current();
  if (row >= table.rows) refuse(fmt::format("table {} has no row {}", table_->info.id, row));
  guarded([&] { table.columns[index_].copy_row(row, out); });
}

void Column::require(ColumnType type, unsigned width) const {
  const ColumnInfo& column = info();
  if (column.type == type && column.width == width) return;
  refuse(fmt::format("column {} of {} has {} {} in a row, not {} {}", column.name, table_->info.id, column.width,
                     name_of(column.type), width, name_of(type)));
}

Table::Table(std::shared_ptr<const TableAccess> access) noexcept : access_(std::move(access)) {}
Table::~Table() = default;
Table::Table(const Table&) noexcept = default;
Table& Table::operator=(const Table&) noexcept = default;

const TableInfo& Table::info() const noexcept {
  return access_->info;
}

std::size_t Table::rows() const {
  return access_->current().rows;
}

bool Table::is_alive(Row row) const {
  const mes::TableColumns& table = access_->current();
  if (row >= table.rows) refuse(fmt::format("table {} has no row {}", access_->info.id, row));
  return guarded([&] { return table.is_alive(row); });
}

std::vector<Row> Table::live_rows() const {
  const mes::TableColumns& table = access_->current();
  return guarded([&] {
    std::vector<Row> out;
    for (std::size_t row = 0; row < table.rows; ++row)
      if (table.is_alive(static_cast<Row>(row))) out.push_back(static_cast<Row>(row));
    return out;
  });
}

std::vector<Column> Table::columns() const {
  return guarded([&] {
    std::vector<Column> out;
    for (std::size_t i = 0; i < access_->info.columns.size(); ++i) out.push_back(Column(access_, i));
    return out;
  });
}

Column Table::column(std::string_view name) const {
  for (std::size_t i = 0; i < access_->info.columns.size(); ++i)
    if (access_->info.columns[i].name == name) return Column(access_, i);
  refuse_unknown(fmt::format("column of {}", access_->info.id), name);
}

std::optional<RowChanges> Table::changes() const {
  const mes::TableColumns& table = access_->current();
  if (access_->run != access_->clock->run())
    refuse(fmt::format("table {} was made before the last run, whose changes it does not know", access_->info.id));
  if (access_->is_rebuilt || !table.changes) return {};
  return RowChanges{table.changes->touched, table.changes->removed};
}

bool Table::is_current() const noexcept {
  return access_->is_current();
}

void Table::write(std::string_view format, const std::function<void(std::string_view bytes)>& sink) const {
  const mes::TableColumns& table = access_->current();
  const auto known = mes::find_table_format(format);
  if (!known) refuse_unknown("format of tables", format);
  if (!sink) refuse("a table is written to nothing");
  const auto checked_sink = [&sink](std::string_view bytes) {
    try {
      sink(bytes);
    } catch (...) {
      throw ThrownByCaller{std::current_exception()};
    }
  };
  std::exception_ptr thrown;
  guarded([&] {
    try {
      mes::write_table(table, *known, checked_sink);
    } catch (const ThrownByCaller& by_caller) {
      thrown = by_caller.exception;
    }
  });
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace v1
}  // namespace mesecina
