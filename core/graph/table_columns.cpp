// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/table_columns.h"

#include <cstring>

#include "core/base/assert.h"
#include "core/graph/structure.h"

namespace mes {

std::vector<TableColumns> Structure::table_columns() const {
  return {};
}

std::string_view name_of(ColumnType type) {
  switch (type) {
    case ColumnType::float64: return "float64";
    case ColumnType::uint32: return "uint32";
    case ColumnType::uint8: return "uint8";
    case ColumnType::int8: return "int8";
    case ColumnType::boolean: return "bool";
  }
  return {};
}

void TableColumn::copy_row(RowNumber row, void* out) const {
  if (read) return read(row, out);
  MES_ASSERT(data != nullptr);
  std::memcpy(out, static_cast<const std::byte*>(data) + row * stride, row_size());
}

std::string TableColumn::name_of(unsigned part) const {
  return parts.empty() ? name : name + "_" + std::string(parts[part]);
}

std::string table_name(std::string_view structure, std::string_view table) {
  return std::string(structure) + "/" + std::string(table);
}

}  // namespace mes
