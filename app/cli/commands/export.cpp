// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina export`: the geometry of layers as text.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/feature_list.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "app/export/cell_export.h"
#include "app/export/geometry_export.h"
#include "app/store/texts/layer_text.h"
#include "core/base/counted.h"
#include "core/base/jobs/parallel.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

Expected<const LayerTextFormat*> select_format(const std::string& name) {
  if (const LayerTextFormat* const format = find_layer_text_format(name)) return format;
  return usage_error(
      fmt::format("unknown export format {}; it is one of {}", in_quotes(name), one_of(export_formats())));
}

/// The features that the points with cells belong to; none if the file has no features with properties. Each feature is
/// read by itself, in degrees, to count its points; they are in the order of the file.
CellOwners owners_of(const Registry& registry, const ExportRequest& request, const LoadedFile& file,
                     CellRegion region) {
  const std::string_view format = file.format;
  const bool has_properties = std::ranges::find(feature_formats(), format) != feature_formats().end();
  if (request.source.file == "-" || !has_properties || format == "wkt" || request.format == "wkt") return {};
  // Samples of curves belong to no feature.
  const bool has_curves = file.data.source && !file.data.source->curves->curves.empty();
  if (has_curves && region != CellRegion::outline) return {};
  const auto list = read_features(registry, request.source.file, format, !request.source.reading.system.empty());
  if (!list) return {};
  ReadingOptions reading = request.source.reading;
  reading.keeps_degrees = true;
  reading.wants_curves = true;
  const PropertyNames names(list->features);
  constexpr std::string_view kPrefix = "cell_";
  std::vector<std::vector<CellOwner>> found(list->features.size());
  run_tasks(found.size(), [&](std::size_t i) {
    const Feature& feature = list->features[i];
    const auto alone = read_input_bytes(registry, feature.text, feature.name, feature.format, reading);
    if (!alone) return;
    CellOwner owner{feature.id, feature.properties};
    if (!owner.id.empty() && request.format != "geojson") {
      if (!owner.properties.empty()) owner.properties += ',';
      owner.properties += fmt::format("\"{}\":{}", names.free_name("feature_id", kPrefix), owner.id);
      owner.id.clear();
    }
    const auto& source = alone->data.source;
    const bool has_lines = source && !source->curves->curves.empty();
    found[i].assign(has_lines ? source->curves->points.size() : alone->data.positions.size(), owner);
  });
  CellOwners out;
  for (const std::vector<CellOwner>& of_feature : found)
    out.of_point.insert(out.of_point.end(), of_feature.begin(), of_feature.end());
  if (out.of_point.size() != points_with_cells(file.data, region).size()) {
    say(request.source.file +
        ": cells have no attributes, since the points of its features are not those of the map");
    return {};
  }
  for (std::string* const name : {&out.columns.sample, &out.columns.center, &out.columns.area})
    *name = names.free_name(*name, kPrefix);
  return out;
}

// Removes the progress line before it returns.
Expected<LayerText> compute_text(const Registry& registry, const SampleData& data, const LayerTextFormat& format,
                                 const std::vector<LayerIndex>& layers, const ComputationSettings& settings) {
  Progress progress;
  return compute_layer_text(
      registry, data, format,
      {.layers = main_layers(layers),
       .settings = settings,
       .on_patch = {},
       .on_progress = [&progress](std::string_view task, double fraction) { progress.show(task, fraction); }});
}

}  // namespace

std::span<const std::string_view> export_formats() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    for (const LayerTextFormat& format : layer_text_formats()) out.push_back(format.name);
    return out;
  }();
  return names;
}

Expected<void> run_export(const Registry& registry, const ExportRequest& request, Interruption& interruption) {
  if (!request.cells.empty()) return run_cell_export(registry, request, interruption);
  if (!request.structure.empty() || !request.table.empty()) return run_table_export(registry, request, interruption);
  if (request.layer.empty())
    return usage_error(
        "export needs --layer (mesecina list layers), --structure (mesecina list structures) or --cells");
  const auto format = select_format(request.format);
  if (!format) return std::unexpected(format.error());
  auto layers = select_layers(registry, request.layer);
  if (!layers) return std::unexpected(layers.error());
  if (request.layer == "all")
    std::erase_if(*layers, [&](LayerIndex layer) { return !(*format)->holds(registry.layers()[layer]); });
  if (auto good = check_layers(registry.layers(), **format, *layers); !good) return good;
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());

  const auto out = compute_text(registry, input->file.data, **format, *layers, input->settings);
  if (!out) return std::unexpected(out.error());
  if (const std::string remark = remark_about(*out, **format); !remark.empty()) say(remark);
  const bool is_of_its_kind =
      request.format == input->file.format && (request.format == "poff" || request.format == "wpoff");
  return write_output(request.output, out->text, interruption, {input->file.sources, request.force, is_of_its_kind});
}

Expected<void> run_cell_export(const Registry& registry, const ExportRequest& request, Interruption& interruption) {
  if (!request.layer.empty() || !request.structure.empty() || !request.table.empty())
    return usage_error("export takes --layer, --structure or --cells, one of them");
  constexpr std::array<std::string_view, 3> kRegions{"box", "hull", "outline"};
  const auto region = std::ranges::find(kRegions, request.cells);
  if (region == kRegions.end())
    return usage_error("--cells expects " + one_of(kRegions) + ", not " + in_quotes(request.cells));
  if (std::ranges::find(cell_formats(), request.format) == cell_formats().end())
    return usage_error("cells are written as " + one_of(cell_formats()) + ", not " + in_quotes(request.format));
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());

  Expected<CellText> out;
  {
    Progress progress;
    JobControl job;
    const auto within = static_cast<CellRegion>(region - kRegions.begin());
    out = compute_cell_text(
        registry, input->file.data, within, request.format, job,
        [&](std::string_view task) { progress.show(task, 0.0); }, owners_of(registry, request, input->file, within));
  }
  if (!out) return std::unexpected(out.error());
  if (out->without_cell != 0)
    say(out->without_cell == 1 ? std::string("1 sample lies on another one, and shares its cell")
                               : fmt::format("{} samples lie on others, and share their cells", out->without_cell));
  if (out->off_earth != 0)
    say(fmt::format("{} left out that {} beyond the poles or around the Earth",
                    counted(out->off_earth, "cell is", "cells are"), out->off_earth == 1 ? "reaches" : "reach"));
  return write_output(request.output, out->text, interruption, {input->file.sources, request.force});
}

}  // namespace mes::cli
