// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual/option_values.h"

#include <algorithm>
#include <array>

#include "app/cli/commands/commands.h"
#include "app/cli/manual/completions.h"
#include "app/cli/requests/compare_request.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/picture_request.h"
#include "app/export/page_size.h"
#include "app/settings/paper_place.h"
#include "core/curves/sampling.h"
#include "core/document/settings/computation_settings.h"
#include "core/document/settings/parameter.h"
#include "core/evolutions/evolution.h"
#include "core/graph/registry.h"
#include "core/graph/table_columns.h"
#include "core/shapes/shape.h"

namespace mes::cli {
namespace {

std::vector<std::string> id_list(const auto& descriptors) {
  std::vector<std::string> out;
  for (const auto& descriptor : descriptors) out.emplace_back(descriptor.id);
  return out;
}

std::vector<std::string> offered_layers(const Registry& registry) {
  std::vector<std::string> out;
  for (const LayerDescriptor& layer : registry.layers())
    if (!layer.is_removed) out.push_back(layer.id);
  return out;
}

std::vector<std::string> offered_formats(const Registry& registry) {
  const auto ids = registry.formats().ids();
  return {ids.begin(), ids.end()};
}

std::vector<std::string> exported(const Registry& /*registry*/) {
  const auto formats = export_formats();
  return {formats.begin(), formats.end()};
}

std::vector<std::string> formats_of_lines(const Registry& /*registry*/) {
  const auto formats = centerline_formats();
  return {formats.begin(), formats.end()};
}

std::vector<std::string> picture_format_names(const Registry& /*registry*/) {
  const auto formats = picture_formats();
  return {formats.begin(), formats.end()};
}

std::vector<std::string> offered_precisions(const Registry& /*registry*/) {
  return id_list(kPrecisionDescriptors);
}

std::vector<std::string> offered_parameters(const Registry& registry) {
  std::vector<std::string> out = id_list(registry.parameters());
  for (const Parameter& parameter : parameters_of(registry.evolutions().all())) out.emplace_back(parameter.id);
  for (std::string& name : out) name += '=';
  return out;
}

std::vector<std::string> swept(const Registry& registry) {
  std::vector<std::string> out = id_list(registry.parameters());
  for (std::string& name : out) name += '=';
  return out;
}

std::vector<std::string> structure_ids(const Registry& registry) {
  const auto ids = registry.structures();
  return {ids.begin(), ids.end()};
}

/// Lists the names of tables of all structures, without repetitions.
std::vector<std::string> table_names(const Registry& registry) {
  std::vector<std::string> out;
  const StructureSet structures = registry.make_structures();
  for (const auto& structure : structures.all())
    for (TableColumns& table : structure->table_columns())
      if (std::ranges::find(out, table.name) == out.end()) out.push_back(std::move(table.name));
  return out;
}

std::vector<std::string> evolution_ids(const Registry& registry) {
  const auto ids = registry.evolutions().ids();
  return {ids.begin(), ids.end()};
}

std::vector<std::string> shape_ids(const Registry& registry) {
  const auto ids = registry.shapes().ids();
  return {ids.begin(), ids.end()};
}

std::vector<std::string> sampling_rule_ids(const Registry& /*registry*/) {
  return id_list(sampling_rules());
}

/// The parameters of all shapes, each once, because shell scripts do not know which shape was named.
std::vector<std::string> shape_parameters(const Registry& registry) {
  std::vector<std::string> out;
  const auto add = [&out](std::string_view id) {
    std::string name = std::string(id) + '=';
    if (std::ranges::find(out, name) == out.end()) out.push_back(std::move(name));
  };
  for (const auto& shape : registry.shapes().all()) {
    for (const Parameter& parameter : shape->parameters) add(parameter.id);
    for (const FormulaParameter& formula : shape->formulas) add(formula.id);
  }
  return out;
}

std::vector<std::string> page_sizes(const Registry& /*registry*/) {
  std::vector<std::string> out;
  for (const PagePreset& preset : page_presets()) out.emplace_back(preset.name);
  return out;
}

std::vector<std::string> bounds(const Registry& /*registry*/) {
  return {std::string(kBoundsOfView), std::string(kBoundsOfInk)};
}

std::vector<std::string> corners(const Registry& /*registry*/) {
  const auto corners = place_corners();
  return {corners.begin(), corners.end()};
}

std::vector<std::string> compared_things(const Registry& registry) {
  std::vector<std::string> out;
  for (const std::string_view subject : compared_subjects(registry)) out.push_back(std::string(subject) + '=');
  return out;
}

std::vector<std::string> things_to_list(const Registry& /*registry*/) {
  return listed_things();
}

std::vector<std::string> offered_beginnings(const Registry& /*registry*/) {
  return things_to_begin();
}

std::vector<std::string> offered_shells(const Registry& /*registry*/) {
  return shell_names();
}

std::vector<std::string> offered_sides(const Registry& /*registry*/) {
  return figure_sides();
}

constexpr std::array<OptionValue, 66> kValues{{
    {"FILE", {}, ValueKind::file},
    {"SESSION", {}, ValueKind::file},
    {"LESSON", {}, ValueKind::file},
    {"--pdf", "FILE", ValueKind::file},
    {"--html", "FILE", ValueKind::file},
    {"--vtt", "FILE", ValueKind::file},
    {"WHAT", {}, ValueKind::choice, things_to_list},
    {"WHAT", {}, ValueKind::choice, offered_beginnings, "new"},
    {"NAME", {}, ValueKind::choice, shape_ids},
    {"NAME", {}, ValueKind::text, nullptr, "new"},
    {"TEXT", {}},
    {"SHELL", {}, ValueKind::choice, offered_shells},
    {"--from", "FORMAT", ValueKind::choice, offered_formats},
    {"--format", "FORMAT", ValueKind::choice, exported},
    {"--format", "FORMAT", ValueKind::choice, formats_of_lines, "centerline"},
    {"--prune", "SHARE"},
    {"--smooth", "T"},
    {"--branches", "N"},
    {"--between", "X,Y"},
    {"--every", "D"},
    {"--to", "FORMAT", ValueKind::choice, picture_format_names},
    {"--threshold", "N"},
    {"--specks", "AREA"},
    {"--figure-side", "SIDE", ValueKind::choice, offered_sides},
    {"--precision", "TYPE", ValueKind::choice, offered_precisions},
    {"--set", "NAME=VALUE", ValueKind::choice, offered_parameters},
    {"--set", "KEY=VALUE", ValueKind::choice, shape_parameters, "shape"},
    {"--parameter", "NAME=FROM..TO", ValueKind::choice, swept},
    {"--layers", "IDS", ValueKind::choices, offered_layers},
    {"--layer", "ID", ValueKind::choice, offered_layers},
    {"--structure", "ID", ValueKind::choice, structure_ids},
    {"--table", "NAME", ValueKind::choice, table_names},
    {"--evolution", "ID", ValueKind::choice, evolution_ids},
    {"--compare", "WHAT=VALUES", ValueKind::choice, compared_things},
    {"--output", "FILE", ValueKind::file},
    {"--image", "FILE", ValueKind::file},
    {"--video", "FILE", ValueKind::file},
    {"--bundle", "NAME", ValueKind::file},
    {"--frames", "FOLDER", ValueKind::folder},
    {"--size", "WxH"},
    {"--size", "SIZE", ValueKind::text, nullptr, "text"},
    {"--font", "FONT", ValueKind::file},
    {"--line-spacing", "FACTOR"},
    {"--figure-size", "SIZE", ValueKind::choice, page_sizes},
    {"--bounds", "BOUNDS", ValueKind::choice, bounds},
    {"--rasterize", "IDS", ValueKind::choices, offered_layers},
    {"--dpi", "N"},
    {"--legend-at", "PLACE", ValueKind::choice, corners},
    {"--scale-bar-at", "PLACE", ValueKind::choice, corners},
    {"--view", "VIEW"},
    {"--scale", "FACTOR"},
    {"--background", "COLOR"},
    {"--set-style", "STYLE"},
    {"--steps", "N"},
    {"--seed", "N"},
    {"--fps", "N"},
    {"--samples", "N"},
    {"--spacing", "D"},
    {"--rule", "RULE", ValueKind::choice, sampling_rule_ids},
    {"--epsilon", "E"},
    {"--turn", "DEGREES"},
    {"--corner-angle", "DEGREES"},
    {"--corner-radius", "R"},
    {"--jitter", "J"},
    {"--shard", "I/N"},
    {"--with", "FILE", ValueKind::file},
}};
constexpr OptionValue kText{{}, "TEXT"};

}  // namespace

const OptionValue& value_of(std::string_view command, std::string_view option) {
  const auto find = [option](std::string_view wanted) {
    return std::ranges::find_if(
        kValues, [=](const OptionValue& value) { return value.option == option && value.command == wanted; });
  };
  auto found = find(command);
  if (found == kValues.end()) found = find({});
  return found != kValues.end() ? *found : kText;
}

std::vector<std::string> shell_names() {
  std::vector<std::string> out;
  for (const Shell& shell : shells()) out.emplace_back(shell.name);
  return out;
}

}  // namespace mes::cli
