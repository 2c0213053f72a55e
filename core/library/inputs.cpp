// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of experiments, and the tables that they describe.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

#include "core/library/internal/adapter.h"
#include "core/library/internal/inputs.h"

namespace mesecina {
inline namespace v1 {
namespace {

mes::ColumnType inner(ColumnType type) {
  return static_cast<mes::ColumnType>(type);
}

void read_computed(const void* column, Row row, void* out) {
  static_cast<const mes::TableColumn*>(column)->copy_row(row, out);
}

}  // namespace

// Column types are converted by numeric value.
static_assert(static_cast<int>(ColumnType::float64) == static_cast<int>(mes::ColumnType::float64) &&
              static_cast<int>(ColumnType::uint32) == static_cast<int>(mes::ColumnType::uint32) &&
              static_cast<int>(ColumnType::uint8) == static_cast<int>(mes::ColumnType::uint8) &&
              static_cast<int>(ColumnType::int8) == static_cast<int>(mes::ColumnType::int8) &&
              static_cast<int>(ColumnType::boolean) == static_cast<int>(mes::ColumnType::boolean));

std::string one_line(std::string_view text) {
  std::string out(text.empty() ? "it gave no reason" : text);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return out;
}

void Inputs::Impl::end() {
  if (clock) clock->close();
  clock.reset();
}

const mes::TableColumns& Inputs::Impl::find(std::string_view table) {
  const std::string_view id = table.substr(0, table.find('/'));
  const std::string_view name = table.substr(std::min(table.size(), id.size() + 1));
  const auto structure = std::ranges::find(structures, id, [](const mes::Structure* one) { return one->id(); });
  if (structure == structures.end()) refuse(fmt::format("{} is not among the inputs", id));
  auto its = std::ranges::find(known, *structure, &Known::structure);
  if (its == known.end()) {
    its = known.insert(its, {*structure, (*structure)->table_columns()});
  } else if (!std::exchange(its->is_fresh, true)) {
    if (std::ranges::all_of(its->tables, [](const auto& one) { return static_cast<bool>(one.refresh); }))
      for (mes::TableColumns& one : its->tables) one.refresh(one);
    else
      its->tables = (*structure)->table_columns();
  }
  const auto found = std::ranges::find(its->tables, name, &mes::TableColumns::name);
  if (found == its->tables.end()) refuse_unknown("table", table);
  return *found;
}

Table Inputs::table(std::string_view id) const {
  return guarded([&] {
    const mes::TableColumns& table = impl_.find(id);
    if (!impl_.clock) impl_.clock = std::make_shared<RunClock>(1);
    return Table(std::make_shared<TableAccess>(
        TableAccess{.info = info_of(id.substr(0, id.find('/')), table), .table = table, .clock = impl_.clock}));
  });
}

std::size_t Inputs::rows(std::string_view table) const {
  return guarded([&] { return impl_.find(table).rows; });
}

std::vector<Row> Inputs::live_rows(std::string_view id) const {
  return guarded([&] {
    const mes::TableColumns& table = impl_.find(id);
    std::vector<Row> out;
    for (std::size_t row = 0; row < table.rows; ++row)
      if (table.is_alive(static_cast<Row>(row))) out.push_back(static_cast<Row>(row));
    return out;
  });
}

bool Inputs::is_alive(std::string_view id, Row row) const {
  return guarded([&] {
    const mes::TableColumns& table = impl_.find(id);
    return row < table.rows && table.is_alive(row);
  });
}

RowChanges Inputs::changes(std::string_view id) const {
  return guarded([&]() -> RowChanges {
    const mes::TableColumns& table = impl_.find(id);
    if (!table.changes) refuse(fmt::format("table {} does not say which rows differ", id));
    return {table.changes->touched, table.changes->removed};
  });
}

double Inputs::parameter(std::string_view id) const {
  return guarded([&] {
    const auto found = std::ranges::find(impl_.parameters, id, &mes::Parameter::id);
    if (found == impl_.parameters.end()) refuse(fmt::format("parameter {} is not named by the experiment", id));
    return impl_.settings->current()[*found];
  });
}

void Inputs::checkpoint(std::uint64_t done, std::uint64_t total) const {
  guarded([&] {
    if (impl_.job != nullptr) impl_.job->checkpoint(done, total);
  });
}

Inputs::Found Inputs::find(std::string_view path, ColumnType type, unsigned width) const {
  return guarded([&]() -> Found {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string_view::npos || path.find('/') == slash)
      refuse(fmt::format("{} is no path of a column, such as delaunay/faces/circumcenter", path));
    const mes::TableColumns& table = impl_.find(path.substr(0, slash));
    const auto found = std::ranges::find(table.columns, path.substr(slash + 1), &mes::TableColumn::name);
    if (found == table.columns.end()) refuse_unknown("column", path);
    if (found->type != inner(type) || found->width != width)
      refuse(fmt::format("column {} has {} {} in a row, not {} {}", path, found->width, name_of(found->type), width,
                         name_of(type)));
    if (found->is_stored()) return {found->data, table.rows, found->stride, nullptr, nullptr};
    return {nullptr, table.rows, 0, &*found, read_computed};
  });
}

OwnTable::OwnTable(std::string name, std::string description) : impl_(std::make_unique<Impl>()) {
  impl_->table.name = std::move(name);
  impl_->table.description = std::move(description);
}
OwnTable::~OwnTable() = default;
OwnTable::OwnTable(OwnTable&&) noexcept = default;
OwnTable& OwnTable::operator=(OwnTable&&) noexcept = default;

OwnTable& OwnTable::rows_of(std::string table) {
  impl_->table.rows_of = std::move(table);
  return *this;
}

OwnTable& OwnTable::alive(const std::vector<std::uint8_t>& flags) {
  impl_->alive = &flags;
  return *this;
}

OwnTable& OwnTable::changes(const std::vector<Row>& touched, const std::vector<Row>& removed) {
  impl_->touched = &touched;
  impl_->removed = &removed;
  return *this;
}

void OwnTable::Impl::refresh(mes::TableColumns& out, bool has_changes) const {
  out.rows = places.empty() ? 0 : std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place place = places[i]();
    out.columns[i].data = place.data;
    out.rows = std::min(out.rows, place.rows);
  }
  if (alive != nullptr) out.rows = std::min(out.rows, alive->size());
  if (touched == nullptr) return;
  out.changes = has_changes ? mes::RowChanges{*touched, *removed} : mes::RowChanges{};
}

OwnTable& OwnTable::refers_to(std::string table) {
  if (impl_->table.columns.empty()) refuse("a table without columns refers to nothing");
  mes::TableColumn& column = impl_->table.columns.back();
  column.is_reference = true;
  column.refers_to = std::move(table);
  return *this;
}

OwnTable& OwnTable::add(std::string name, std::string description, ColumnType type, unsigned width,
                        std::size_t stride, std::function<Place()> place) {
  if (width > 3) refuse(fmt::format("column {} has {} values in a row, more than 3", name, width));
  mes::TableColumn& column = impl_->table.columns.emplace_back();
  impl_->places.push_back(std::move(place));
  column.name = std::move(name);
  column.description = std::move(description);
  column.type = inner(type);
  column.width = width;
  column.stride = stride;
  static constexpr std::array<std::string_view, 2> kCoordinates{"x", "y"};
  static constexpr std::array<std::string_view, 3> kNumbers{"0", "1", "2"};
  if (width == 2 && type == ColumnType::float64) {
    column.parts = kCoordinates;
    column.has_directions = true;  // an experiment does not say which they are
  } else if (width > 1 && width <= kNumbers.size()) {
    column.parts = std::span(kNumbers).first(width);
  }
  return *this;
}

}  // namespace v1
}  // namespace mesecina
