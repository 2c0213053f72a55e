// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/table_maker.h"

#include "core/base/assert.h"

namespace mes {

/// Functions that return the present addresses and sizes.
struct AnyTableMaker::Refresh {
  std::function<std::size_t()> rows;
  std::vector<std::function<std::size_t()>> limits;
  std::vector<std::pair<std::size_t, std::function<const void*()>>> columns;  // pairs with the index of each column
  std::function<RowChanges()> changes;

  void apply(TableColumns& table) const {
    table.rows = rows();
    for (const auto& limit : limits) table.rows = std::min(table.rows, limit());
    for (const auto& [column, address] : columns) table.columns[column].data = address();
    if (changes) table.changes = changes();
  }
};

AnyTableMaker::AnyTableMaker(std::string_view name, std::string_view description,
                             std::function<bool(RowNumber)> is_alive) {
  table_.name = name;
  table_.description = description;
  table_.is_alive = std::move(is_alive);
}

TableColumns AnyTableMaker::take() {
  if (refresh_) table_.refresh = [refresh = std::move(refresh_)](TableColumns& table) { refresh->apply(table); };
  return std::move(table_);
}

void AnyTableMaker::set_rows(std::function<std::size_t()> rows) {
  table_.rows = rows();
  refresh_ = std::make_shared<Refresh>();
  refresh_->rows = std::move(rows);
}

void AnyTableMaker::set_changes(std::function<RowChanges()> changes) {
  table_.changes = changes();
  if (refresh_) refresh_->changes = std::move(changes);
}

void AnyTableMaker::limit_rows(const std::function<std::size_t()>& size) {
  table_.rows = std::min(table_.rows, size());
  if (refresh_) refresh_->limits.push_back(size);
}

TableColumn& AnyTableMaker::add(std::string_view name, std::string_view description, const ValueShape& shape) {
  TableColumn column;
  column.name = name;
  column.description = description;
  column.type = shape.type;
  column.width = shape.width;
  column.parts = shape.parts;
  column.is_reference = shape.is_reference;
  return table_.columns.emplace_back(std::move(column));
}

TableColumn& AnyTableMaker::add_stored(std::string_view name, std::string_view description, const ValueShape& shape,
                                       std::size_t stride, const std::function<std::size_t()>& size,
                                       const std::function<const void*()>& address) {
  limit_rows(size);
  if (refresh_) refresh_->columns.emplace_back(table_.columns.size(), address);
  TableColumn& column = add(name, description, shape);
  column.stride = stride;
  column.data = address();
  return column;
}

TableColumn& AnyTableMaker::add_read(std::string_view name, std::string_view description, const ValueShape& shape,
                                     std::function<void(RowNumber, void*)> read) {
  TableColumn& column = add(name, description, shape);
  column.read = [is_alive = table_.is_alive, read = std::move(read)](RowNumber row, void* out) {
    read(is_alive(row) ? row : kNoRow, out);
  };
  return column;
}

TableColumn& AnyTableMaker::plain(TableColumn& column) {
  MES_ASSERT(!column.is_reference);
  return column;
}

TableColumn& AnyTableMaker::boolean(TableColumn& column) {
  column.type = ColumnType::boolean;
  return column;
}

TableColumn& AnyTableMaker::refer(TableColumn& column, const RowsOf& target) {
  MES_ASSERT(column.is_reference);
  column.refers_to = target.table;
  column.infinity = target.infinity;
  return column;
}

}  // namespace mes
