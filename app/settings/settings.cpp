// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/settings.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "app/system/data_folder.h"
#include "core/io/files/atomic_file.h"
#include "core/io/session/json_text.h"

namespace mes {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kSchema = 1;
// A settings file is small; a larger file is not one, and is not read into memory.
constexpr std::uintmax_t kLargestFile = 1U << 20U;

constexpr std::size_t kMostListedLayers = 1000;

constexpr std::string_view kDark = "dark";
constexpr std::string_view kLight = "light";

template <class T>
T number_in(const json& object, const char* key, T low, T high, T otherwise) {
  const auto entry = object.find(key);
  if (entry == object.end() || !entry->is_number()) return otherwise;
  const double value = entry->get<double>();
  return static_cast<T>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

bool flag_in(const json& object, const char* key, bool otherwise) {
  const auto entry = object.find(key);
  return entry != object.end() && entry->is_boolean() ? entry->get<bool>() : otherwise;
}

std::string text_in(const json& object, const char* key) {
  const auto entry = object.find(key);
  return entry != object.end() && entry->is_string() ? entry->get<std::string>() : std::string();
}

// Reads 0xRRGGBB; nothing if it is missing or no colour.
std::optional<Rgb> color_in(const json& object, const char* key) {
  const auto entry = object.find(key);
  if (entry == object.end() || !entry->is_number_integer()) return std::nullopt;
  const auto value = entry->get<std::int64_t>();
  if (value < 0 || value > 0xFFFFFF) return std::nullopt;
  return Rgb{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
             static_cast<std::uint8_t>(value)};
}

std::optional<PaperPlace> place_in(const json& object, const char* key) {
  return parse_place(text_in(object, key));
}

json to_json(const std::optional<PaperPlace>& place) {
  if (!place) return nullptr;
  return to_text(*place);
}

json to_json(const std::optional<Rgb>& color) {
  if (!color) return nullptr;
  return static_cast<unsigned>(color->r) << 16U | static_cast<unsigned>(color->g) << 8U |
         static_cast<unsigned>(color->b);
}

PanelChoice panels_from_json(const json& object, const PanelChoice& otherwise) {
  const auto names = object.find("panels");
  const auto pinned = object.find("pinned_panel");
  if (names == object.end() || !names->is_array() || pinned == object.end()) return otherwise;
  std::vector<PanelPage> open;
  for (const json& name : *names)
    if (const auto page = name.is_string() ? find_panel(name.get<std::string>()) : std::nullopt)
      open.push_back(*page);
  return {open, find_panel(text_in(object, "pinned_panel"))};
}

std::vector<std::string_view> names_of(std::span<const PanelPage> pages) {
  std::vector<std::string_view> out;
  for (const PanelPage page : pages) out.push_back(id_of(page));
  return out;
}

RecordSettings record_from_json(const json& object) {
  RecordSettings out;
  out.width = number_in(object, "width", 0, kLargestFrameSide, out.width);
  out.height = number_in(object, "height", 0, kLargestFrameSide, out.height);
  out.supersampling = number_in(object, "supersampling", 1, 4, out.supersampling);
  out.transparent = flag_in(object, "transparent", out.transparent);
  out.background = color_in(object, "background");
  out.with_panels = flag_in(object, "with_panels", out.with_panels);
  out.each_motion = flag_in(object, "each_motion", out.each_motion);
  out.fps = number_in(object, "fps", 1.0, 120.0, out.fps);
  out.real_time = flag_in(object, "real_time", out.real_time);
  out.with_source = flag_in(object, "with_source", out.with_source);
  out.all_panes = flag_in(object, "all_panes", out.all_panes);
  out.folder = text_in(object, "folder");
  // Values that fit their ranges may still not fit each other.
  if (!check(out)) {
    out.width = out.height = 0;
    out.supersampling = 1;
  }
  return out;
}

json to_json(const RecordSettings& record) {
  return {{"width", record.width},
          {"height", record.height},
          {"supersampling", record.supersampling},
          {"transparent", record.transparent},
          {"background", to_json(record.background)},
          {"with_panels", record.with_panels},
          {"each_motion", record.each_motion},
          {"fps", record.fps},
          {"real_time", record.real_time},
          {"with_source", record.with_source},
          {"all_panes", record.all_panes},
          {"folder", record.folder}};
}

// In the order of `FigureExtent` and `FigurePaper`.
constexpr std::array<std::string_view, 3> kExtents{"view", "everything", "ink"};
constexpr std::array<std::string_view, 3> kPapers{"white", "canvas", "transparent"};

template <class Choice>
void choice_in(const json& object, const char* key, std::span<const std::string_view> names, Choice& out) {
  const auto found = std::ranges::find(names, text_in(object, key));
  if (found != names.end()) out = static_cast<Choice>(found - names.begin());
}

FigureSettings figure_from_json(const json& object) {
  FigureSettings out;
  if (std::string extension = text_in(object, "extension"); !extension.empty()) out.extension = std::move(extension);
  out.width_mm = number_in(object, "width_mm", kLeastFigureSide, kMostFigureSide, out.width_mm);
  out.height_mm = number_in(object, "height_mm", 0.0, kMostFigureSide, out.height_mm);
  out.in_inches = flag_in(object, "in_inches", out.in_inches);
  choice_in(object, "extent", kExtents, out.extent);
  choice_in(object, "paper", kPapers, out.paper);
  out.as_on_screen = flag_in(object, "as_on_screen", out.as_on_screen);
  out.letters_pt = number_in(object, "letters_pt", kLeastLettersPt, kMostLettersPt, out.letters_pt);
  out.least_line_pt = number_in(object, "least_line_pt", 0.0, kMostLeastLinePt, out.least_line_pt);
  out.with_legend = flag_in(object, "with_legend", out.with_legend);
  out.with_key = flag_in(object, "with_key", out.with_key);
  out.with_annotations = flag_in(object, "with_annotations", out.with_annotations);
  out.all_panes = flag_in(object, "all_panes", out.all_panes);
  out.with_differences = flag_in(object, "with_differences", out.with_differences);
  out.marks.bar = flag_in(object, "with_scale_bar", out.marks.bar);
  out.marks.axes = flag_in(object, "with_axes", out.marks.axes);
  out.marks.grid = flag_in(object, "with_grid", out.marks.grid);
  out.with_source = flag_in(object, "with_source", out.with_source);
  out.dots_per_inch = number_in(object, "dots_per_inch", kLeastDotsPerInch, kMostDotsPerInch, out.dots_per_inch);
  return out;
}

json to_json(const FigureSettings& figure) {
  return {{"extension", figure.extension},
          {"width_mm", figure.width_mm},
          {"height_mm", figure.height_mm},
          {"in_inches", figure.in_inches},
          {"extent", kExtents[static_cast<std::size_t>(figure.extent)]},
          {"paper", kPapers[static_cast<std::size_t>(figure.paper)]},
          {"as_on_screen", figure.as_on_screen},
          {"letters_pt", figure.letters_pt},
          {"least_line_pt", figure.least_line_pt},
          {"with_legend", figure.with_legend},
          {"with_key", figure.with_key},
          {"with_annotations", figure.with_annotations},
          {"all_panes", figure.all_panes},
          {"with_differences", figure.with_differences},
          {"with_scale_bar", figure.marks.bar},
          {"with_axes", figure.marks.axes},
          {"with_grid", figure.marks.grid},
          {"with_source", figure.with_source},
          {"dots_per_inch", figure.dots_per_inch}};
}

void read_names(const json& object, const char* key, std::size_t most, std::vector<std::string>& to) {
  const auto names = object.find(key);
  if (names == object.end() || !names->is_array()) return;
  to.clear();
  for (const json& name : *names)
    if (name.is_string() && to.size() < most) to.push_back(name);
}

void remember(std::vector<std::string>& names, const fs::path& file) {
  std::error_code error;
  fs::path absolute = fs::weakly_canonical(file, error);
  if (error) absolute = fs::absolute(file, error);
  const std::string text = absolute.string();
  std::erase(names, text);
  names.insert(names.begin(), text);
  if (names.size() > kRecentFiles) names.resize(kRecentFiles);
}

/// Combines the names that this program has remembered with those that another one has added meanwhile.
std::vector<std::string> remembered_by_both(std::vector<std::string> ours, const std::vector<std::string>& at_start,
                                            const std::vector<std::string>& now) {
  for (const std::string& name : now)
    if (std::ranges::count(at_start, name) == 0 && std::ranges::count(ours, name) == 0) ours.push_back(name);
  if (ours.size() > kRecentFiles) ours.resize(kRecentFiles);
  return ours;
}

Settings from_json(const json& object) {
  Settings out;
  read_names(object, "recent_files", kRecentFiles, out.recent_files);
  read_names(object, "recent_experiments", kRecentFiles, out.recent_experiments);
  if (const auto compiler = object.find("compiler"); compiler != object.end() && compiler->is_string())
    out.compiler = *compiler;
  out.brush.radius_px = number_in(object, "brush_radius_px", 4.0, 200.0, out.brush.radius_px);
  out.spray_spacing_px = number_in(object, "spray_spacing_px", 2.0, 100.0, out.spray_spacing_px);
  out.interface_scale = number_in(object, "interface_scale", 0.5, 4.0, out.interface_scale);
  if (text_in(object, "theme") == kDark) out.theme = Theme::dark;
  out.for_projector = flag_in(object, "for_projector", out.for_projector);
  out.canvas_background = color_in(object, "canvas_background");
  out.window_width = number_in(object, "window_width", 320, 16384, out.window_width);
  out.window_height = number_in(object, "window_height", 240, 16384, out.window_height);
  out.panels = panels_from_json(object, out.panels);
  out.column_width = number_in(object, "column_width", 200.0, 1200.0, out.column_width);
  out.lower_panel_share = number_in(object, "lower_panel_share", 0.1, 0.9, out.lower_panel_share);
  out.diagram = {place_in(object, "diagram_at"), number_in(object, "diagram_width", 0.0, 16384.0, 0.0),
                 number_in(object, "diagram_height", 0.0, 16384.0, 0.0)};
  read_names(object, "favorite_layers", kMostListedLayers, out.favorite_layers);
  read_names(object, "unfolded_layers", kMostListedLayers, out.unfolded_layers);
  out.show_legend = flag_in(object, "show_legend", out.show_legend);
  out.show_key = flag_in(object, "show_key", out.show_key);
  out.show_annotations = flag_in(object, "show_annotations", out.show_annotations);
  out.show_differences = flag_in(object, "show_differences", out.show_differences);
  out.legend_at = place_in(object, "legend_at");
  out.marks.bar = flag_in(object, "show_scale_bar", out.marks.bar);
  out.marks.bar_at = place_in(object, "scale_bar_at");
  out.marks.axes = flag_in(object, "show_axes", out.marks.axes);
  out.marks.grid = flag_in(object, "show_grid", out.marks.grid);
  out.snap.is_on = flag_in(object, "snaps", out.snap.is_on);
  out.snap.samples = flag_in(object, "snaps_to_samples", out.snap.samples);
  out.snap.centers = flag_in(object, "snaps_to_centers", out.snap.centers);
  out.snap.vertices = flag_in(object, "snaps_to_vertices", out.snap.vertices);
  out.snap.circles = flag_in(object, "snaps_to_circles", out.snap.circles);
  out.snap.curves = flag_in(object, "snaps_to_curves", out.snap.curves);
  out.snap.grid = flag_in(object, "snaps_to_grid", out.snap.grid);
  out.snap.pixels = flag_in(object, "snaps_to_pixels", out.snap.pixels);
  out.show_handles = flag_in(object, "show_handles", out.show_handles);
  out.keep_degrees = flag_in(object, "keep_degrees", out.keep_degrees);
  out.show_insertion_preview = flag_in(object, "show_insertion_preview", out.show_insertion_preview);
  out.show_evolution = flag_in(object, "show_evolution", out.show_evolution);
  out.classic_keys = flag_in(object, "classic_keys", out.classic_keys);
  out.last_folder = text_in(object, "last_folder");
  if (const auto record = object.find("record"); record != object.end() && record->is_object())
    out.record = record_from_json(*record);
  if (const auto figure = object.find("figure"); figure != object.end() && figure->is_object())
    out.figure = figure_from_json(*figure);
  return out;
}

std::string set_aside(const fs::path& path, const std::string& why) {
  fs::path broken = path;
  broken += ".broken";
  std::error_code error;
  fs::rename(path, broken, error);
  if (error)
    return fmt::format("the settings in {} cannot be used ({}); started with the defaults", path.string(), why);
  return fmt::format("the settings could not be read ({}); they were set aside as {}", why, broken.string());
}

}  // namespace

void remember_file(Settings& settings, const fs::path& file) {
  remember(settings.recent_files, file);
}

void remember_experiment(Settings& settings, const fs::path& name) {
  remember(settings.recent_experiments, name);
}

fs::path default_settings_path() {
  const fs::path folder = config_folder();
  return folder.empty() ? folder : folder / "settings.json";
}

LoadedSettings load_settings(const fs::path& path) {
  if (path.empty()) return {};
  std::error_code error;
  if (!fs::exists(path, error) || error) return {};
  if (!fs::is_regular_file(path, error))
    return {Settings{}, path.string() + " is not a file; started with the defaults"};
  if (fs::file_size(path, error) > kLargestFile || error)
    return {Settings{}, set_aside(path, "too large for settings")};
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream) return {Settings{}, path.string() + " cannot be read; started with the defaults"};
  const json parsed = parse_json(bytes.str());
  if (parsed.is_discarded()) return {Settings{}, set_aside(path, "not JSON")};
  if (!parsed.is_object()) return {Settings{}, set_aside(path, "not a JSON object")};
  if (number_in(parsed, "schema", 0, 1'000'000, 0) != kSchema)
    return {Settings{}, set_aside(path, "another version")};
  return {from_json(parsed), {}};
}

namespace {

json to_json(const Settings& settings) {
  return {{"schema", kSchema},
          {"recent_files", settings.recent_files},
          {"recent_experiments", settings.recent_experiments},
          {"compiler", settings.compiler},
          {"spray_spacing_px", settings.spray_spacing_px},
          {"brush_radius_px", settings.brush.radius_px},
          {"interface_scale", settings.interface_scale},
          {"theme", settings.theme == Theme::dark ? kDark : kLight},
          {"for_projector", settings.for_projector},
          {"canvas_background", to_json(settings.canvas_background)},
          {"window_width", settings.window_width},
          {"window_height", settings.window_height},
          {"panels", names_of(settings.panels.all())},
          {"pinned_panel", settings.panels.pinned() ? id_of(*settings.panels.pinned()) : ""},
          {"column_width", settings.column_width},
          {"lower_panel_share", settings.lower_panel_share},
          {"diagram_at", to_json(settings.diagram.at)},
          {"diagram_width", settings.diagram.width},
          {"diagram_height", settings.diagram.height},
          {"favorite_layers", settings.favorite_layers},
          {"unfolded_layers", settings.unfolded_layers},
          {"show_legend", settings.show_legend},
          {"show_key", settings.show_key},
          {"show_annotations", settings.show_annotations},
          {"show_differences", settings.show_differences},
          {"legend_at", to_json(settings.legend_at)},
          {"show_scale_bar", settings.marks.bar},
          {"scale_bar_at", to_json(settings.marks.bar_at)},
          {"show_axes", settings.marks.axes},
          {"show_grid", settings.marks.grid},
          {"snaps", settings.snap.is_on},
          {"snaps_to_samples", settings.snap.samples},
          {"snaps_to_centers", settings.snap.centers},
          {"snaps_to_vertices", settings.snap.vertices},
          {"snaps_to_circles", settings.snap.circles},
          {"snaps_to_curves", settings.snap.curves},
          {"snaps_to_grid", settings.snap.grid},
          {"snaps_to_pixels", settings.snap.pixels},
          {"show_handles", settings.show_handles},
          {"show_insertion_preview", settings.show_insertion_preview},
          {"keep_degrees", settings.keep_degrees},
          {"show_evolution", settings.show_evolution},
          {"classic_keys", settings.classic_keys},
          {"last_folder", settings.last_folder},
          {"record", to_json(settings.record)},
          {"figure", to_json(settings.figure)}};
}

}  // namespace

Settings merged(const Settings& ours, const Settings& at_start, const Settings& now) {
  const json mine = to_json(ours);
  const json before = to_json(at_start);
  json out = to_json(now);
  for (const auto& [key, value] : mine.items())
    if (value != before[key]) out[key] = value;
  Settings result = from_json(out);
  result.recent_files = remembered_by_both(ours.recent_files, at_start.recent_files, now.recent_files);
  result.recent_experiments =
      remembered_by_both(ours.recent_experiments, at_start.recent_experiments, now.recent_experiments);
  return result;
}

Expected<void> save_settings(const Settings& settings, const fs::path& path) {
  if (path.empty()) return {};
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error)
    return std::unexpected(
        Error{ErrorCode::cannot_write, "cannot make the folder: " + error.message(), path.parent_path().string()});
  // Opening a pipe would block until it is read.
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
    return std::unexpected(Error{ErrorCode::cannot_write, "this is not a file", path.string()});
  // File names may contain any bytes; those that are not UTF-8 are replaced instead of refused.
  return write_file_atomically(path, json_text(to_json(settings), 2) + '\n');
}

}  // namespace mes
