// SPDX-License-Identifier: GPL-3.0-or-later
// Writes sessions as text.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/carried_session.h"
#include "core/base/zlib.h"
#include "core/io/session/json_annotations.h"
#include "core/io/session/json_curves.h"
#include "core/io/session/json_layers.h"
#include "core/io/session/json_panes.h"
#include "core/io/session/json_text.h"
#include "core/io/session/session.h"

namespace mes {
namespace {

using nlohmann::json;

void put(json& out, Vec2 p) {
  out.push_back(p.x);
  out.push_back(p.y);
}
void put(json& out, const Disk& disk) {
  put(out, disk.center);
  out.push_back(disk.radius);
}
void put(json& out, std::uint32_t number) {
  out.push_back(number);
}
template <class Place>
void put(json& out, const std::pair<std::uint32_t, Place>& thing) {
  out.push_back(thing.first);
  put(out, thing.second);
}

/// All numbers of all things in one array.
template <class Things>
json flat(const Things& things) {
  json out = json::array();
  for (const auto& thing : things) put(out, thing);
  return out;
}

json to_json(const Box2& box) {
  return flat(std::array{box.low, box.high});
}

json to_json(const std::vector<SampleData::Contour>& contours) {
  json out = json::array();
  for (const SampleData::Contour& contour : contours)
    out.push_back({{"closed", contour.closed}, {"points", flat(contour.points)}});
  return out;
}

/// The previous curves apply if `curves` is null.
json source_to_json(const CurveSet* curves, const SamplingRequest& sampling, std::uint32_t first,
                    std::uint32_t count) {
  json out = {{"sampling", to_json(sampling)}, {"first", first}, {"count", count}};
  if (curves != nullptr) out["drawing"] = to_json(*curves);
  return out;
}

/// True if the first schema can hold it: longitude and latitude on WGS 84, kept or projected equirectangularly.
bool is_old_plane(const MapPlane& map) {
  return map.system.empty() && map.projection != MapProjection::azimuthal &&
         (map.projection != MapProjection::none || map.unit == "degree");
}

json to_json(const MapPlane& map) {
  const bool is_projected = map.projection != MapProjection::none;
  json out;
  if (is_old_plane(map))
    out["degrees"] = is_projected ? "projected" : "kept";
  else
    out["projection"] = kMapProjections[static_cast<std::size_t>(map.projection)];
  if (is_projected) {
    out["longitude"] = map.longitude;
    out["latitude"] = map.latitude;
  }
  if (!map.system.empty()) out["system"] = map.system;
  if (!is_old_plane(map) && !is_projected) out["unit"] = map.unit;
  if (map.page != Vec2{}) out["page"] = json::array({map.page.x, map.page.y});
  return out;
}

json to_json(const SampleData& data) {
  json out = {{"samples", flat(data.positions)}, {"contours", to_json(data.contours)}, {"balls", flat(data.balls)}};
  if (data.map) out["map"] = to_json(*data.map);
  if (!data.annotations.empty()) out["annotations"] = to_json(data.annotations);
  if (data.source) {
    const CurveSource& source = *data.source;
    out["source"] = source_to_json(source.curves.get(), source.sampling, source.first, source.count);
  }
  return out;
}

json to_json(const ComputationSettings& settings) {
  json parameters = json::object();
  for (const ParameterValues::Entry& entry : settings.values.changed()) parameters[entry.id] = entry.value;
  for (const Parameter& parameter : computation_parameters()) parameters[parameter.id] = settings[parameter];
  return {{"precision", id_of(settings.precision)}, {"parameters", std::move(parameters)}};
}

json to_json(const SessionEvolution& evolution) {
  json parameters = json::object();
  for (const auto& [id, value] : evolution.parameters) parameters[id] = value;
  return {{"id", evolution.id},
          {"seed", evolution.seed},
          {"step", evolution.step},
          {"parameters", std::move(parameters)}};
}

json to_json(const TimelineEdit& edit) {
  json out = json::object();
  const auto add = [&out](const char* key, const auto& things) {
    if (!things.empty()) out[key] = flat(things);
  };
  if (!edit.name.empty()) out["name"] = edit.name;
  if (edit.continues) out["continues"] = true;
  if (edit.replaces) out["replaces"] = true;
  if (edit.is_state) out["state"] = true;
  add("remove", edit.removed);
  add("move", edit.moved);
  add("insert", edit.inserted);
  add("remove_balls", edit.removed_balls);
  add("change_balls", edit.changed_balls);
  add("insert_balls", edit.inserted_balls);
  if (edit.curve) out["contours"] = to_json(*edit.curve);
  if (edit.annotations) out["annotations"] = to_json(*edit.annotations);
  if (edit.source) {
    const SourceEdit& source = *edit.source;
    out["source"] = source.has_curves
                        ? source_to_json(source.curves.get(), source.sampling, source.first, source.count)
                        : json(nullptr);
  }
  return {{"edit", std::move(out)}};
}
json to_json(const GestureBegun& begun) {
  return {{"begin", begun.name}};
}
json to_json(const GestureEnded& /*entry*/) {
  return {{"end", true}};
}
json to_json(const Undone& /*entry*/) {
  return {{"undo", true}};
}
json to_json(const Redone& /*entry*/) {
  return {{"redo", true}};
}
json difference_to_json(const LayersChanged& change) {
  LayerConfiguration changed{change.changed, {}};
  if (change.image) changed.image = *change.image;
  json out = {{"changed", to_json(changed)}};
  if (!change.order.empty()) out["order"] = change.order;
  if (change.image) out["has_image"] = true;
  return out;
}
json to_json(const LayersChanged& change) {
  json out = {{"layers", difference_to_json(change)}};
  switch (change.role) {
    case LayersChanged::Role::noted: return out;
    case LayersChanged::Role::step: out["step"] = change.name; break;
    case LayersChanged::Role::joined: out["joins"] = true; break;
    case LayersChanged::Role::undone: out["undoes"] = true; break;
    case LayersChanged::Role::redone: out["redoes"] = true; break;
  }
  if (!change.back.empty()) out["back"] = difference_to_json(change.back.front());
  return out;
}
json to_json(const SettingsChanged& change) {
  return {{"settings", to_json(change.settings)}};
}
json to_json(const ViewChanged& change) {
  return {{"view", to_json(change.visible)}};
}
json to_json(const Captioned& caption) {
  json out = {{"caption", caption.text}};
  if (caption.seconds > 0.0) out["seconds"] = caption.seconds;
  return out;
}
json to_json(const LessonStep& step) {
  json out = {{"caption", step.caption}};
  if (step.position != 0) out["position"] = step.position;
  if (step.layers != LayerConfiguration{}) out["layers"] = to_json(step.layers);
  if (step.settings) out["settings"] = to_json(*step.settings);
  if (!step.view.is_empty()) out["view"] = to_json(step.view);
  if (step.seconds > 0.0) out["seconds"] = step.seconds;
  return out;
}

json to_json(const TimelineEntry& entry) {
  return std::visit([](const auto& kind) { return to_json(kind); }, entry);
}

json head_of(const Session& session) {
  json out = {{"version", MESECINA_VERSION},
              {"title", session.title},
              {"data", to_json(*session.data)},
              {"layers", to_json(session.layers)},
              {"settings", to_json(session.settings)}};
  if (!session.evolution.id.empty()) out["evolution"] = to_json(session.evolution);
  if (!session.view.is_empty()) out["view"] = to_json(session.view);
  if (!session.panes.empty()) out["panes"] = panes_to_json(session.panes, session.pane_views);
  return out;
}

// One step a line if `is_spread`; empty without a lesson. Begins with a comma because it follows another key.
std::string lesson_text(const Lesson& lesson, bool is_spread) {
  if (lesson == Lesson{}) return {};
  const std::string_view line = is_spread ? "\n" : "";
  std::string out = fmt::format(",{}\"lesson\":{{", line);
  if (!lesson.title.empty()) out += "\"title\":" + json_text(json(lesson.title)) + ',';
  out += "\"steps\":[";
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (i != 0) out += ',';
    out += line;
    out += json_text(to_json(lesson.steps[i]));
  }
  return out + "]}";
}

// Other keys are sorted; the identifying key is first nevertheless.
constexpr std::string_view kHeadBegin = R"({"mesecina":"session","schema":)";
std::string head_text(const Session& session, std::uint64_t schema) {
  return fmt::format("{}{},", kHeadBegin, schema) + json_text(head_of(session)).substr(1);
}

std::uint64_t entry_schema(const TimelineEntry& entry) {
  const auto* const edit = std::get_if<TimelineEdit>(&entry);
  return edit != nullptr && edit->annotations ? schema_of(*edit->annotations) : 1;
}

}  // namespace

std::string write_session(const Session& session) {
  // One entry a line, because session files are compared and kept under version control.
  constexpr std::uint64_t kSchemaOfSystems = 3;
  const std::optional<MapPlane>& map = session.data->map;
  std::uint64_t schema = schema_of(session.data->annotations);
  if (map && !is_old_plane(*map)) schema = std::max(schema, kSchemaOfSystems);
  std::string out = head_text(session, 0);
  out.pop_back();
  out += lesson_text(session.lesson, true);
  out += ",\n\"timeline\":[";
  for (std::size_t i = 0; i < session.entries.size(); ++i) {
    const TimelineEntry entry = session.entries[i];
    schema = std::max(schema, entry_schema(entry));
    out += i == 0 ? "\n" : ",\n";
    out += json_text(to_json(entry));
  }
  // The schema is known only now; it is one digit, like the zero that it replaces.
  static_assert(kSessionSchema < 10);
  out[kHeadBegin.size()] = static_cast<char>('0' + schema);
  return out + "\n]}\n";
}

std::optional<std::string> packed_session(const Session& session) {
  const std::string text = write_session(session);
  if (text.size() > kMostCarriedBytes) return std::nullopt;
  // A longer search would compress digits hardly better, and the user waits for a snapshot.
  return zlib_compressed(text, ZlibEffort::fast);
}

std::string write_journal_head(const Session& session) {
  std::string out = head_text(session, kSessionSchema);
  out.pop_back();
  return out + lesson_text(session.lesson, false) + "}\n";
}

std::string write_journal_line(const TimelineEntry& entry) {
  return json_text(to_json(entry)) + '\n';
}

std::string write_journal_saved(const std::optional<SourceFile>& file) {
  return "{\"saved\":true}\n" + (file ? write_journal_file(*file) : std::string());
}

std::string write_journal_edits_saved() {
  return "{\"saved\":\"edits\"}\n";
}

// The hash is text: numbers of JSON are doubles in many readers. A name that is not UTF-8 cannot be written as JSON.
std::string write_journal_file(const SourceFile& file) {
  constexpr std::string_view kReplaced = "\xEF\xBF\xBD";
  json line;
  json& kept = line["kept_in"];
  kept["file"] = file.path.string();
  kept["hash"] = std::to_string(file.fingerprint.hash);
  kept["size"] = file.fingerprint.size;
  const std::string text = json_text(line) + '\n';
  return text.contains(kReplaced) ? std::string() : text;
}

}  // namespace mes
