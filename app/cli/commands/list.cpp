// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina list`: layers, structures, formats and more, as a table for people and as JSON for programs.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/actions/actions.h"
#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/bundle_request.h"
#include "app/cli/requests/names.h"
#include "app/store/lessons.h"
#include "app/store/looks/color_maps.h"
#include "app/store/sample_shapes.h"
#include "app/store/texts/layer_text.h"
#include "core/base/counted.h"
#include "core/document/settings/parameter.h"
#include "core/evolutions/evolution.h"
#include "core/glyphs/fonts.h"
#include "core/graph/registry.h"
#include "core/graph/structure.h"
#include "core/graph/table_columns.h"
#include "core/io/format_spec.h"
#include "core/io/session/json_text.h"
#include "core/io/text/text_numbers.h"
#include "core/shapes/shape.h"

namespace mes::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A listed item: the table shows its name and a line of text, JSON shows everything.
struct Entry {
  std::string id;
  std::string text;
  Json json;
};

std::string hex_of(Rgb color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const unsigned channel : {color.r, color.g, color.b}) {
    out += kDigits[channel >> 4U];
    out += kDigits[channel & 15U];
  }
  return out;
}

std::vector<Entry> layer_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const LayerDescriptor& layer : registry.layers()) {
    if (layer.is_removed) continue;
    Json kinds = Json::array();
    for (const PrimitiveKind kind : layer.kinds) kinds.push_back(name_of(kind));
    out.push_back({std::string(layer.id),
                   std::string(layer.tooltip),
                   {{"id", layer.id},
                    {"name", layer.name},
                    {"tooltip", layer.tooltip},
                    {"group", title_of(layer.group)},
                    {"paper", layer.in_paper},
                    {"visible_at_start", layer.visible_at_start},
                    {"in_fit_box", layer.in_fit_box},
                    {"kinds", kinds},
                    {"scalar", layer.scalar.empty() ? Json() : Json(layer.scalar)},
                    {"structures", layer.structures},
                    {"parameters", layer.parameters},
                    {"style",
                     {{"color", hex_of(layer.style.color)},
                      {"opacity", layer.style.opacity},
                      {"point_size_px", layer.style.point_size_px},
                      {"line_width_px", layer.style.line_width_px},
                      {"dashed", layer.style.dashed},
                      {"flat", layer.style.flat},
                      {"thin_when_dense", layer.style.thin_when_dense}}}}});
  }
  return out;
}

Json tables_of(const Structure& structure) {
  Json out = Json::array();
  for (const TableColumns& table : structure.table_columns()) {
    Json columns = Json::array();
    for (const TableColumn& column : table.columns)
      columns.push_back({{"name", column.name},
                         {"description", column.description},
                         {"type", std::string(name_of(column.type))},
                         {"width", column.width},
                         {"refers_to", column.refers_to}});
    out.push_back({{"name", table.name},
                   {"description", table.description},
                   {"rows_of", table.rows_of},
                   {"columns", std::move(columns)}});
  }
  return out;
}

std::vector<Entry> structure_entries(const Registry& registry) {
  std::vector<Entry> out;
  const StructureSet structures = registry.make_structures();
  for (const auto& structure : structures.all()) {
    const std::string_view id = structure->id();
    const StructureSpec& spec = *registry.find_structure(id);
    const Json tables = tables_of(*structure);
    std::string names;
    for (const Json& table : tables) names += (names.empty() ? "" : ", ") + table["name"].get<std::string>();
    Json readers = Json::array();
    for (const LayerDescriptor& layer : registry.layers())
      if (!layer.is_removed && std::ranges::find(layer.structures, id) != layer.structures.end())
        readers.push_back(layer.id);
    out.push_back({std::string(id),
                   fmt::format("read by {}; {}", counted(readers.size(), "layer"),
                               tables.empty() ? "no table" : "tables: " + names),
                   {{"id", id},
                    {"inputs", spec.inputs},
                    {"parameters", spec.parameters},
                    {"layers", readers},
                    {"tables", tables}}});
  }
  return out;
}

std::vector<Entry> format_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const auto& each : registry.formats().all()) {
    const FormatDescriptor& format = each->descriptor;
    const bool is_exported = std::ranges::find(export_formats(), format.id) != export_formats().end();
    std::string text = std::string(format.name) + " (";
    for (std::size_t i = 0; i < format.extensions.size(); ++i) {
      if (i != 0) text += ' ';
      text += format.extensions[i];
    }
    text += format.can_read ? "), read" : ")";
    if (is_exported) text += ", exported";
    out.push_back({std::string(format.id),
                   text,
                   {{"id", format.id},
                    {"name", format.name},
                    {"extensions", format.extensions},
                    {"read", format.can_read},
                    {"write", format.can_write},
                    {"export", is_exported}}});
  }
  for (const LayerTextFormat& format : layer_text_formats()) {
    const std::string id(format.name);
    if (std::ranges::find(out, id, &Entry::id) != out.end()) continue;
    out.push_back({id,
                   fmt::format("{}, exported", format.title),
                   {{"id", id},
                    {"name", format.title},
                    {"extensions", Json::array()},
                    {"read", false},
                    {"write", false},
                    {"export", true}}});
  }
  return out;
}

Entry entry_of(const Parameter& parameter, const Json& evolutions) {
  std::string range;
  append_number(range, parameter.low);
  range += " to ";
  append_number(range, parameter.high);
  return {std::string(parameter.id),
          std::string(parameter.explanation) + " (" + range + ")",
          {{"id", parameter.id},
           {"explanation", parameter.explanation},
           {"unit", parameter.unit},
           {"low", parameter.low},
           {"high", parameter.high},
           {"default", parameter.default_value},
           {"evolutions", evolutions}}};
}

Json readers_of(const Registry& registry, const Parameter& parameter) {
  Json out = Json::array();
  for (const auto& evolution : registry.evolutions().all())
    if (const auto own = parameters_of(*evolution); std::ranges::find(own, parameter) != own.end())
      out.push_back(evolution->descriptor.id);
  return out;
}

std::vector<Entry> parameter_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const Parameter& parameter : registry.parameters()) out.push_back(entry_of(parameter, Json::array()));
  for (const Parameter& parameter : parameters_of(registry.evolutions().all()))
    out.push_back(entry_of(parameter, readers_of(registry, parameter)));
  return out;
}

std::vector<Entry> evolution_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const auto& each : registry.evolutions().all()) {
    const EvolutionDescriptor& evolution = each->descriptor;
    Json parameters = Json::array();
    for (const Parameter& parameter : parameters_of(*each)) parameters.push_back(parameter.id);
    out.push_back({evolution.id,
                   evolution.tooltip,
                   {{"id", evolution.id},
                    {"name", evolution.name},
                    {"tooltip", evolution.tooltip},
                    {"random", evolution.is_random},
                    {"parameters", parameters}}});
  }
  return out;
}

std::vector<Entry> precision_entries(const Registry& /*registry*/) {
  std::vector<Entry> out;
  for (const PrecisionDescriptor& precision : kPrecisionDescriptors)
    out.push_back({std::string(precision.id),
                   std::string(precision.explanation),
                   {{"id", precision.id}, {"name", precision.name}, {"explanation", precision.explanation}}});
  return out;
}

std::vector<Entry> action_entries(const Registry& /*registry*/) {
  std::vector<Entry> out;
  for (const ActionDescriptor& action : action_descriptors()) {
    std::string text(action.tooltip);
    for (std::size_t i = 0; i < action.keys.size(); ++i) {
      text += i == 0 ? " [" : ", ";
      text += action.keys[i];
    }
    if (!action.keys.empty()) text += ']';
    out.push_back({std::string(action.public_id),
                   text,
                   {{"id", action.public_id},
                    {"name", action.name},
                    {"tooltip", action.tooltip},
                    {"group", title_of(action.group)},
                    {"keys", action.keys}}});
  }
  return out;
}

std::vector<Entry> bundle_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const auto& [bundle, is_built_in] : available_bundles(registry)) {
    Json shown = Json::array();
    std::string text;
    for (const LayerConfiguration::Entry& entry : bundle.layers.layers) {
      if (!entry.visible) continue;
      shown.push_back(entry.layer);
      text += (text.empty() ? "" : ", ") + entry.layer;
    }
    out.push_back(
        {printable(bundle.name),
         printable(bundle.description.empty() ? text : bundle.description),
         {{"id", bundle.name}, {"description", bundle.description}, {"built_in", is_built_in}, {"layers", shown}}});
  }
  return out;
}

std::vector<Entry> color_map_entries(const Registry& /*registry*/) {
  const LoadedColorMaps loaded = load_color_maps(find_assets({}), user_color_map_folder());
  for (const Error& problem : loaded.problems) say("a colour map is left out: " + problem.message());
  std::vector<Entry> out;
  for (const render::ColorMap& map : loaded.maps) {
    out.push_back({map.name,
                   fmt::format("{} colours{}", map.colors.size(),
                               map.is_categorical ? " for whole numbers" : ", and all between them"),
                   {{"id", map.name}, {"colors", map.colors.size()}, {"categorical", map.is_categorical}}});
  }
  return out;
}

std::vector<Entry> lesson_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const ShippedLesson& lesson : read_shipped_lessons(find_assets({}))) {
    const auto session = session_of(registry, lesson, find_assets({}));
    if (!session) {
      say(fmt::format("a lesson is left out: {}: it cannot be read", lesson.name));
      continue;
    }
    const Lesson& contents = (*session)->lesson;
    out.push_back({lesson.name,
                   fmt::format("{} ({} steps)", printable(contents.title), contents.steps.size()),
                   {{"id", lesson.name}, {"title", contents.title}, {"steps", contents.steps.size()}}});
  }
  return out;
}

std::vector<Entry> shape_entries(const Registry& registry) {
  std::vector<Entry> out;
  for (const auto& each : registry.shapes().all()) {
    const ShapeDescriptor& shape = *each;
    std::string text(shape.explanation);
    Json parameters = Json::array();
    std::string names;
    for (const Parameter& parameter : shape.parameters) {
      parameters.push_back(entry_of(parameter, {}).json);
      parameters.back().erase("evolutions");
      names += (names.empty() ? "" : ", ") + std::string(parameter.id) + '=';
      append_number(names, parameter.default_value);
    }
    Json formulas = Json::array();
    for (const FormulaParameter& formula : shape.formulas) {
      formulas.push_back(
          {{"id", formula.id}, {"explanation", formula.explanation}, {"default", formula.default_text}});
      names +=
          (names.empty() ? "" : ", ") + std::string(formula.id) + "=\"" + std::string(formula.default_text) + '"';
    }
    if (!names.empty()) text += " (" + names + ')';
    out.push_back({std::string(shape.id),
                   text,
                   {{"id", shape.id},
                    {"name", shape.name},
                    {"explanation", shape.explanation},
                    {"parameters", parameters},
                    {"formulas", formulas},
                    {"points", shape.points}}});
  }
  return out;
}

std::vector<Entry> font_entries(const Registry& /*registry*/) {
  std::vector<Entry> out;
  for (const std::string& family : font_families()) {
    const std::string name = printable(family);
    out.push_back({name, {}, {{"id", name}}});
  }
  return out;
}

struct Listing {
  std::string_view name;
  std::vector<Entry> (*entries)(const Registry& registry);
};

constexpr std::array<Listing, 12> kListings{{{"layers", layer_entries},
                                             {"structures", structure_entries},
                                             {"evolutions", evolution_entries},
                                             {"formats", format_entries},
                                             {"parameters", parameter_entries},
                                             {"precisions", precision_entries},
                                             {"actions", action_entries},
                                             {"bundles", bundle_entries},
                                             {"color-maps", color_map_entries},
                                             {"lessons", lesson_entries},
                                             {"shapes", shape_entries},
                                             {"fonts", font_entries}}};

std::string table_of(const std::vector<Entry>& entries) {
  std::size_t width = 0;
  for (const Entry& entry : entries) width = std::max(width, entry.id.size());
  std::string out;
  for (const Entry& entry : entries) {
    out += entry.id;
    if (!entry.text.empty()) out += std::string(width - entry.id.size() + 2, ' ') + entry.text;
    out += '\n';
  }
  return out;
}

}  // namespace

std::vector<std::string> listed_things() {
  std::vector<std::string> out;
  for (const Listing& listing : kListings) out.emplace_back(listing.name);
  return out;
}

Expected<void> run_list(const Registry& registry, const ListRequest& request, Interruption& interruption) {
  std::vector<std::string_view> names;
  for (const Listing& listing : kListings) {
    names.push_back(listing.name);
    if (listing.name != request.what) continue;
    const std::vector<Entry> entries = listing.entries(registry);
    if (!request.as_json) return write_output({}, table_of(entries), interruption);
    Json out = Json::array();
    for (const Entry& entry : entries) out.push_back(entry.json);
    return write_output({}, json_text(out, 2) + '\n', interruption);
  }
  return usage_error("cannot list " + in_quotes(request.what) + "; it is one of " + one_of(names));
}

}  // namespace mes::cli
