// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/coordinate_range.h"
#include "core/io/json_layers.h"
#include "core/io/json_place.h"
#include "core/io/json_text.h"

namespace mes {
namespace {

using nlohmann::json;

constexpr int kSchema = 1;

/// Says where in a session something makes no sense; turned into an `Error` at the surface.
struct Nonsense {
  std::string text;
  std::vector<JsonStep> place{};  ///< of a number; empty: not known
};

[[noreturn]] void complain(const std::string& where, const std::string& what) {
  throw Nonsense{where + ": " + what};
}

// --- writing ---

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

json to_json(const SampleData& data) {
  return {{"samples", flat(data.positions)}, {"contours", to_json(data.contours)}, {"balls", flat(data.balls)}};
}

json to_json(const ComputationSettings& settings) {
  json parameters = json::object();
  for (std::size_t i = 0; i < kParameters; ++i)
    parameters[std::string(parameter_descriptors()[i].id)] = settings.values[i];
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
  add("remove", edit.removed);
  add("move", edit.moved);
  add("insert", edit.inserted);
  add("remove_balls", edit.removed_balls);
  add("change_balls", edit.changed_balls);
  add("insert_balls", edit.inserted_balls);
  if (edit.curve) out["contours"] = to_json(*edit.curve);
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
json to_json(const LayersChanged& change) {
  LayerConfiguration changed{change.changed, {}};
  if (change.image) changed.image = *change.image;
  json out = {{"changed", to_json(changed)}};
  if (!change.order.empty()) out["order"] = change.order;
  if (change.image) out["has_image"] = true;
  return {{"layers", std::move(out)}};
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
  return out;
}

// File names and titles may be any bytes; those that are not UTF-8 are replaced rather than refused.
std::string text_of(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

// Keys are sorted; the one that tells what this is comes first all the same.
std::string head_text(const Session& session) {
  return "{\"mesecina\":\"session\",\"schema\":" + std::to_string(kSchema) + ',' +
         text_of(head_of(session)).substr(1);
}

// --- reading ---

const json* find(const json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string text_at(const json& object, const char* key, const std::string& where) {
  const json* value = find(object, key);
  if (value == nullptr) return {};
  if (!value->is_string()) complain(where, std::string("\"") + key + "\" is not a text");
  return value->get<std::string>();
}

double number_of(const json& value, const std::string& where) {
  if (!value.is_number()) complain(where, "not a number");
  const double out = value.get<double>();
  if (!std::isfinite(out)) complain(where, "a number is too large");
  return out;
}

std::uint32_t count_of(const json& value, const std::string& where) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    complain(where, "not a whole number that counts something");
  return value.get<std::uint32_t>();
}

void take(const json* at, Vec2& out, const std::string& where) {
  out = {number_of(at[0], where), number_of(at[1], where)};
}
void take(const json* at, Disk& out, const std::string& where) {
  take(at, out.center, where);
  out.radius = number_of(at[2], where);
}
void take(const json* at, std::uint32_t& out, const std::string& where) {
  out = count_of(*at, where);
}
template <class Place>
void take(const json* at, std::pair<std::uint32_t, Place>& out, const std::string& where) {
  take(at, out.first, where);
  take(at + 1, out.second, where);
}
/// The first of the numbers that no document can hold, and why; counted within the thing.
struct BadNumber {
  std::size_t index = 0;
  std::string why;
};
std::optional<BadNumber> bad_number_of(std::uint32_t) {
  return std::nullopt;
}
template <class Place>
std::optional<BadNumber> bad_number_of(const Place& place) {
  std::optional<BadNumber> out;
  std::size_t index = 0;
  for_each_number(place, [&](double x) {
    if (const auto fault = range_fault_of(x); fault && !out) out = BadNumber{index, describe(*fault, x)};
    ++index;
  });
  return out;
}
template <class Place>
std::optional<BadNumber> bad_number_of(const std::pair<std::uint32_t, Place>& thing) {
  auto out = bad_number_of(thing.second);
  if (out) ++out->index;
  return out;
}

template <class T>
constexpr std::size_t kNumbersEach = 1;
template <>
constexpr std::size_t kNumbersEach<Vec2> = 2;
template <>
constexpr std::size_t kNumbersEach<Disk> = 3;
template <class Place>
constexpr std::size_t kNumbersEach<std::pair<std::uint32_t, Place>> = 1 + kNumbersEach<Place>;

template <class T>
void read_flat(const json& object, const char* key, std::vector<T>& out, const std::string& where) {
  const json* value = find(object, key);
  if (value == nullptr) return;
  const std::string here = where + " \"" + key + '"';
  constexpr std::size_t each = kNumbersEach<T>;
  if (!value->is_array()) complain(here, "not a list");
  const auto& numbers = value->get_ref<const json::array_t&>();
  if (numbers.size() % each != 0)
    complain(here, "the number of numbers is not a multiple of " + std::to_string(each));
  out.resize(numbers.size() / each);
  for (std::size_t i = 0; i < out.size(); ++i) {
    take(numbers.data() + each * i, out[i], here);
    if (const auto bad = bad_number_of(out[i]))
      throw Nonsense{here + ": " + bad->why, {JsonStep(key), JsonStep(each * i + bad->index)}};
  }
}

/// The same, within a part of the whole.
template <class Read>
auto within(const std::vector<JsonStep>& place, Read read) {
  try {
    return read();
  } catch (Nonsense& nonsense) {
    if (!nonsense.place.empty()) nonsense.place.insert(nonsense.place.begin(), place.begin(), place.end());
    throw;
  }
}

/// The numbers of all things fit with each other and with those seen before.
template <class T>
void require_together(const std::vector<T>& things, const char* key, const std::string& where, Magnitudes& seen) {
  std::size_t index = 0;
  for (const T& thing : things)
    for_each_number(thing, [&](double x) {
      if (const auto fault = seen.fault_of(x))
        throw Nonsense{where + " \"" + key + "\": " + describe(*fault, x, seen), {JsonStep(key), JsonStep(index)}};
      seen.add(x);
      ++index;
    });
}

std::vector<SampleData::Contour> contours_of(const json& list, const std::string& where) {
  if (!list.is_array()) complain(where, "not a list");
  std::vector<SampleData::Contour> out;
  for (const json& entry : list) {
    if (!entry.is_object()) complain(where, "a contour is not an object");
    SampleData::Contour& contour = out.emplace_back();
    if (const json* closed = find(entry, "closed"); closed != nullptr) {
      if (!closed->is_boolean()) complain(where, "\"closed\" is neither true nor false");
      contour.closed = closed->get<bool>();
    }
    read_flat(entry, "points", contour.points, where);
  }
  return out;
}

SampleData data_of(const json& object) {
  const std::string where = "data";
  if (!object.is_object()) complain(where, "not an object");
  SampleData out;
  read_flat(object, "samples", out.positions, where);
  if (const json* contours = find(object, "contours")) out.contours = contours_of(*contours, "contours");
  read_flat(object, "balls", out.balls, where);
  Magnitudes seen;
  require_together(out.positions, "samples", where, seen);
  require_together(out.balls, "balls", where, seen);
  return out;
}

// Values of a later version, which may allow more, are brought into range.
ComputationSettings settings_from(const json& object) {
  ComputationSettings out;
  if (const json* precision = find(object, "precision"); precision != nullptr && precision->is_string())
    for (const PrecisionDescriptor& descriptor : kPrecisionDescriptors)
      if (precision->get_ref<const std::string&>() == descriptor.id) out.precision = descriptor.precision;
  if (const json* parameters = find(object, "parameters")) {
    for (std::size_t i = 0; i < kParameters; ++i) {
      const ParameterDescriptor& descriptor = parameter_descriptors()[i];
      const json* value = find(*parameters, std::string(descriptor.id).c_str());
      if (value == nullptr || !value->is_number()) continue;
      const double number = std::clamp(value->get<double>(), descriptor.low, descriptor.high);
      out.values[i] = descriptor.is_whole ? std::round(number) : number;
    }
  }
  return out;
}

SessionEvolution evolution_from(const json& object) {
  const std::string where = "evolution";
  SessionEvolution out;
  out.id = text_at(object, "id", where);
  const auto count = [&](const char* key, std::uint64_t& to) {
    const json* value = find(object, key);
    if (value == nullptr) return;
    if (!value->is_number_unsigned()) complain(where, std::string("\"") + key + "\" is not a whole number");
    to = value->get<std::uint64_t>();
  };
  count("seed", out.seed);
  count("step", out.step);
  if (const json* parameters = find(object, "parameters"); parameters != nullptr && parameters->is_object())
    for (const auto& [id, value] : parameters->items()) out.parameters.emplace_back(id, number_of(value, where));
  return out;
}

LayerConfiguration layers_from(const json& value) {
  auto out = layer_configuration_from(value);
  if (!out) throw Nonsense{"layers: " + out.error().text};
  return std::move(*out);
}

Box2 view_from(const json& value) {
  // What is looked at may be any place, however small or far.
  if (!value.is_array() || value.size() != 4) complain("view", "not two corners");
  Box2 out;
  for (const std::size_t corner : {0U, 2U})
    out.add(Vec2{number_of(value[corner], "view"), number_of(value[corner + 1], "view")});
  return out;
}

TimelineEdit edit_from(const json& object) {
  const std::string where = "edit";
  if (!object.is_object()) complain(where, "not an object");
  TimelineEdit out;
  out.name = text_at(object, "name", where);
  if (const json* continues = find(object, "continues"); continues != nullptr && continues->is_boolean())
    out.continues = continues->get<bool>();
  if (const json* replaces = find(object, "replaces"); replaces != nullptr && replaces->is_boolean())
    out.replaces = replaces->get<bool>();
  read_flat(object, "remove", out.removed, where);
  read_flat(object, "move", out.moved, where);
  read_flat(object, "insert", out.inserted, where);
  read_flat(object, "remove_balls", out.removed_balls, where);
  read_flat(object, "change_balls", out.changed_balls, where);
  read_flat(object, "insert_balls", out.inserted_balls, where);
  if (const json* contours = find(object, "contours")) out.curve = contours_of(*contours, "contours");
  return out;
}

LayersChanged layers_changed_from(const json& object) {
  LayersChanged out;
  if (const json* changed = find(object, "changed")) {
    LayerConfiguration configuration = layers_from(*changed);
    out.changed = std::move(configuration.layers);
    if (find(object, "has_image") != nullptr) out.image = std::move(configuration.image);
  }
  if (const json* order = find(object, "order"); order != nullptr && order->is_array())
    for (const json& id : *order)
      if (id.is_string()) out.order.push_back(id.get<std::string>());
  return out;
}

/// Nothing for a kind that is not known.
std::optional<TimelineEntry> entry_from(const json& object) {
  if (!object.is_object()) complain("entry", "not an object");
  if (const json* edit = find(object, "edit")) return edit_from(*edit);
  if (find(object, "begin") != nullptr) return GestureBegun{text_at(object, "begin", "gesture")};
  if (find(object, "end") != nullptr) return GestureEnded{};
  if (find(object, "undo") != nullptr) return Undone{};
  if (find(object, "redo") != nullptr) return Redone{};
  if (const json* layers = find(object, "layers")) return layers_changed_from(*layers);
  if (const json* settings = find(object, "settings")) return SettingsChanged{settings_from(*settings)};
  if (const json* view = find(object, "view")) return ViewChanged{view_from(*view)};
  if (find(object, "caption") != nullptr) {
    constexpr double kLongest = 600.0;
    const json* seconds = find(object, "seconds");
    const double shown = seconds == nullptr ? 0.0 : number_of(*seconds, "caption");
    return Captioned{text_at(object, "caption", "caption"), std::clamp(shown, 0.0, kLongest)};
  }
  return std::nullopt;
}

std::string entry_name(std::size_t i) {
  return "entry " + std::to_string(i + 1) + " of the timeline";
}

Session session_from(const json& object) {
  if (text_at(object, "mesecina", "session") != "session") complain("session", "this is not one");
  const json* schema = find(object, "schema");
  if (schema == nullptr || !schema->is_number_integer()) complain("session", "it does not say its version");
  if (schema->get<std::int64_t>() > kSchema)
    complain("session", "written by a later version of the program, which this one does not understand");
  Session out;
  out.title = text_at(object, "title", "session");
  if (const json* data = find(object, "data"))
    out.data = std::make_shared<const SampleData>(within({"data"}, [&] { return data_of(*data); }));
  if (const json* layers = find(object, "layers")) out.layers = layers_from(*layers);
  if (const json* settings = find(object, "settings")) out.settings = settings_from(*settings);
  if (const json* evolution = find(object, "evolution")) out.evolution = evolution_from(*evolution);
  if (const json* view = find(object, "view")) out.view = view_from(*view);
  if (const json* timeline = find(object, "timeline")) {
    if (!timeline->is_array()) complain("timeline", "not a list");
    for (std::size_t i = 0; i < timeline->size(); ++i) {
      try {
        auto entry = within({"timeline", i, "edit"}, [&] { return entry_from((*timeline)[i]); });
        if (entry) out.entries.push_back(std::move(*entry));
      } catch (Nonsense& nonsense) {
        nonsense.text = entry_name(i) + ": " + nonsense.text;
        throw;
      }
    }
  }
  return out;
}

std::unexpected<Error> bad(const std::string& file, std::string text, std::uint64_t line = 0) {
  return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file, line, 0});
}

}  // namespace

std::string write_session(const Session& session) {
  // One entry a line: files of sessions are compared and kept under version control.
  std::string out = head_text(session);
  out.pop_back();
  out += ",\n\"timeline\":[";
  for (std::size_t i = 0; i < session.entries.size(); ++i) {
    out += i == 0 ? "\n" : ",\n";
    out += text_of(to_json(session.entries[i]));
  }
  return out + "\n]}\n";
}

Expected<Session> read_session(std::string_view text, const std::string& file) {
  const auto parsed = parse_json(text, file);
  if (!parsed) return std::unexpected(parsed.error());
  try {
    return session_from(*parsed);
  } catch (const Nonsense& nonsense) {
    if (nonsense.place.empty()) return bad(file, nonsense.text);
    return bad_json(text, offset_in_json(text, nonsense.place), nonsense.text, file);
  }
}

bool looks_like_session(std::string_view text) {
  constexpr std::size_t kLookAt = 4096;
  const std::string_view begin = text.substr(0, kLookAt);
  const std::size_t brace = begin.find_first_not_of(" \t\r\n");
  if (brace == std::string_view::npos || begin[brace] != '{') return false;
  const std::size_t key = begin.find("\"mesecina\"");
  if (key == std::string_view::npos) return false;
  const std::size_t value = begin.find_first_not_of(" \t\r\n:", key + std::string_view("\"mesecina\"").size());
  return value != std::string_view::npos && begin.substr(value).starts_with("\"session\"");
}

Expected<void> replay_session(const Session& session, DocumentReplay& replay, const std::string& file) {
  if (auto begun = replay.begin(*session.data); !begun) return bad(file, begun.error().text);
  for (std::size_t i = 0; i < session.entries.size(); ++i)
    if (const auto done = replay.apply(session.entries[i]); !done)
      return bad(file, entry_name(i) + ": " + done.error().text);
  replay.finish();
  return {};
}

std::string write_journal_head(const Session& session) {
  return head_text(session) + '\n';
}

std::string write_journal_line(const TimelineEntry& entry) {
  return text_of(to_json(entry)) + '\n';
}

std::string write_journal_saved() {
  return "{\"saved\":true}\n";
}

Expected<Journaled> read_journal(std::string_view text, const std::string& file) {
  Journaled out;
  bool is_first = true;
  DocumentReplay replay;
  for (std::uint64_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      out.is_torn = true;
      break;
    }
    const std::string_view this_line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (is_first) {
      auto session = read_session(this_line, file);
      if (!session) return std::unexpected(session.error());
      out.session = std::move(*session);
      if (auto begun = replay.begin(*out.session.data); !begun) return bad(file, begun.error().text, line);
      is_first = false;
      continue;
    }
    const auto stop = [&](const std::string& why) { out.complaint = file + ':' + std::to_string(line) + ": " + why; };
    const auto parsed = parse_json(this_line, file);
    if (!parsed) {
      stop(parsed.error().text);
      break;
    }
    try {
      if (find(*parsed, "saved") != nullptr) out.unsaved_edits = 0;
      auto entry = entry_from(*parsed);
      if (!entry) continue;
      out.unsaved_edits += changes_document(*entry) ? 1U : 0U;
      if (const auto done = replay.apply(*entry); !done) {
        stop(done.error().text);
        break;
      }
      out.session.entries.push_back(std::move(*entry));
    } catch (const Nonsense& nonsense) {
      stop(nonsense.text);
      break;
    }
  }
  if (is_first) return bad(file, "the first line is missing");
  for (const TimelineEntry& entry : out.session.entries) {
    if (const auto* layers = std::get_if<LayersChanged>(&entry)) apply(*layers, out.session.layers);
    if (const auto* settings = std::get_if<SettingsChanged>(&entry)) out.session.settings = settings->settings;
    if (const auto* view = std::get_if<ViewChanged>(&entry)) out.session.view = view->visible;
  }
  return out;
}

}  // namespace mes
