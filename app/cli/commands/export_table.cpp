// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina export --structure`: a table of a structure for other programs.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "core/graph/registry.h"
#include "core/graph/write_table.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"
#include "core/workbench/workbench.h"

namespace mes::cli {
namespace {

std::vector<TableColumns> tables_of(const StructureSet& structures, std::string_view id) {
  for (const auto& structure : structures.all())
    if (structure->id() == id) return structure->table_columns();
  return {};
}

std::string in_words(const std::vector<TableColumns>& tables) {
  std::vector<std::string_view> names;
  for (const TableColumns& table : tables) names.push_back(table.name);
  return one_of(names);
}

/// Checks that the table exists before the file is read. The only table of a structure need not be named.
Expected<std::string> select_table(const Registry& registry, const ExportRequest& request) {
  if (!request.layer.empty() && !request.structure.empty())
    return usage_error("export takes --layer or --structure, not both");
  if (request.structure.empty()) return usage_error("--table needs --structure (mesecina list structures)");
  const auto ids = registry.structures();
  if (std::ranges::find(ids, request.structure) == ids.end())
    return usage_error(unknown_word("structure", request.structure, ids) + " (mesecina list structures)");
  const auto tables = tables_of(registry.make_structures(), request.structure);
  if (tables.empty()) return usage_error(fmt::format("the structure {} has no table", request.structure));
  if (request.table.empty() && tables.size() == 1) return tables.front().name;
  if (request.table.empty())
    return usage_error(fmt::format("--table says which table of {}: {}", request.structure, in_words(tables)));
  if (std::ranges::find(tables, request.table, &TableColumns::name) == tables.end())
    return usage_error(
        fmt::format("{} has no table {}; it has {}", request.structure, in_quotes(request.table), in_words(tables)));
  return request.table;
}

bool is_pair(const TableColumn& column) {
  return column.type == ColumnType::float64 && column.parts.size() == 2 && column.parts.front() == "x";
}

/// Positions become those of the map. A table with directions stays as it is, since its rows would be of two planes.
/// `plane` has to live as long as the table.
void write_on_map(TableColumns& table, const WrittenPlane& plane) {
  const auto is_position = [](const TableColumn& column) { return is_pair(column) && !column.has_directions; };
  if (std::ranges::none_of(table.columns, is_position)) return;
  if (std::ranges::any_of(table.columns, &TableColumn::has_directions))
    return say(table.name + ": positions are those of the plane, since the table has directions");
  for (TableColumn& column : table.columns) {
    if (!is_pair(column)) continue;
    column.read = [on_plane = column, &plane](RowNumber row, void* out) {
      Vec2 p;
      on_plane.copy_row(row, &p);
      if (std::isfinite(p.x) && std::isfinite(p.y)) p = plane.position(p);
      std::memcpy(out, &p, sizeof p);
    };
  }
}

}  // namespace

Expected<void> run_table_export(const Registry& registry, const ExportRequest& request, Interruption& interruption) {
  const auto name = select_table(registry, request);
  if (!name) return std::unexpected(name.error());
  const auto format = find_table_format(request.format);
  if (!format) return usage_error("a table is written as csv or npy, not " + in_quotes(request.format));
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());

  const std::optional<MapPlane>& map = input->file.data.map;
  const auto plane = WrittenPlane::of(map);
  if (!plane) return std::unexpected(plane.error());
  std::string bytes;
  {
    Progress progress;
    Workbench bench(registry, {.keeps_history = false, .keeps_instances = false});
    bench.choose(input->settings);
    if (auto loaded = bench.load(input->file.data); !loaded) return loaded;
    if (auto known = bench.need({std::string_view(request.structure)}); !known) return known;
    const auto ids = registry.structures();
    bench.set_on_task([&](std::string_view task) {
      const auto at = std::ranges::find(ids, task) - ids.begin();
      progress.show(task, static_cast<double>(at) / static_cast<double>(ids.size()));
    });
    JobControl job;
    if (auto done = bench.run(job); !done) return done;
    auto tables = tables_of(bench.graph().structures(), request.structure);
    const auto table = std::ranges::find(tables, *name, &TableColumns::name);
    if (map && map->projection != MapProjection::none) write_on_map(*table, *plane);
    write_table(*table, *format, [&bytes](std::string_view piece) { bytes += piece; });
  }
  return write_output(request.output, bytes, interruption, {input->file.sources, request.force});
}

}  // namespace mes::cli
