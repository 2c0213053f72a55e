// SPDX-License-Identifier: GPL-3.0-or-later
// Reads sessions from text.
#include <fmt/core.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "core/document/timeline/layer_fold.h"
#include "core/io/session/json_annotations.h"
#include "core/io/session/json_curves.h"
#include "core/io/session/json_layers.h"
#include "core/io/session/json_panes.h"
#include "core/io/session/json_text.h"
#include "core/io/session/json_view.h"
#include "core/io/session/session.h"
#include "core/io/session/session_values.h"
#include "core/io/text/read_job.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

// Drops contours without points.
std::vector<SampleData::Contour> contours_of(JsonView list, const std::string& where) {
  if (!list.is_list()) complain(where, "not a list");
  const auto read = [&where](JsonView entry) {
    if (!entry.is_object()) complain(where, "a contour is not an object");
    const auto [closed, points] = entry.pick<2>({"closed", "points"});
    SampleData::Contour contour;
    if (closed && !closed.is_flag()) complain(where, "\"closed\" is neither true nor false");
    if (closed) contour.closed = closed.flag();
    read_flat(points, "points", contour.points, where);
    return contour;
  };
  std::size_t count = 0;
  for (const JsonView entry : list.elements()) count += entry.find("points").size() != 0 ? 1U : 0U;
  std::vector<SampleData::Contour> out;
  out.reserve(count);
  for (const JsonView entry : list.elements())
    if (SampleData::Contour contour = read(entry); !contour.points.empty()) out.push_back(std::move(contour));
  return out;
}

Annotations annotations_of(JsonView list) {
  auto out = annotations_from(list);
  if (!out) throw Nonsense{"annotations: " + out.error().text};
  return std::move(*out);
}

template <class Read>
auto of_source(JsonView value, Read read) {
  auto out = read(value);
  if (!out) throw Nonsense{std::move(out.error().text), value};
  return *std::move(out);
}

SourceEdit source_from(JsonView object) {
  const std::string where = "source";
  if (!object.is_object()) return {.has_curves = false};
  const auto [drawing, sampling, first, count] = object.pick<4>({"drawing", "sampling", "first", "count"});
  SourceEdit out;
  if (drawing) out.curves = std::make_shared<const CurveSet>(of_source(drawing, curves_from));
  out.sampling = of_source(sampling, sampling_from);
  out.first = count_of(first, where);
  out.count = count_of(count, where);
  return out;
}

/// A text that can stand in one line of other files.
std::string line_from(JsonView value, const char* key, const std::string& where) {
  constexpr std::size_t kLongest = 1U << 16U;
  std::string out = short_text_from(value, key, kLongest, where);
  if (printable(out) != out) throw Nonsense{fmt::format("{}: \"{}\" is not a printable line", where, key), value};
  return out;
}

MapPlane map_from(JsonView object) {
  const std::string where = "map";
  if (!object.is_object()) throw Nonsense{"map: not an object", object};
  const auto [degrees, projection, longitude, latitude, system, unit, page] =
      object.pick<7>({"degrees", "projection", "longitude", "latitude", "system", "unit", "page"});
  MapPlane out;
  if (projection) {
    const auto name = std::ranges::find(kMapProjections, text_from(projection, "projection", where));
    if (name == kMapProjections.end()) throw Nonsense{"map: there is no such projection", projection};
    out.projection = static_cast<MapProjection>(name - kMapProjections.begin());
  } else {
    const std::string kind = text_from(degrees, "degrees", where);
    if (kind != "kept" && kind != "projected") throw Nonsense{"map: degrees are neither projected nor kept", degrees};
    if (kind == "projected") out.projection = MapProjection::equirectangular;
  }
  if (system) out.system = line_from(system, "system", where);
  if (out.projection == MapProjection::none) {
    if (unit) out.unit = line_from(unit, "unit", where);
    if (page) {
      const std::vector<Vec2> size = places_of(page, where);
      if (size.size() != 1 || !(size[0].x > 0.0 && size[0].y > 0.0) || !out.is_of_drawing())
        throw Nonsense{"map: this is no page of a drawing", page};
      out.page = size[0];
    }
    return out;
  }
  out.longitude = number_of(longitude, where);
  out.latitude = number_of(latitude, where);
  if (!is_origin_of_map(out.longitude, 0.0, out)) throw Nonsense{"map: there is no such longitude", longitude};
  if (!is_origin_of_map(0.0, out.latitude, out)) throw Nonsense{"map: there is no such latitude", latitude};
  return out;
}

SampleData data_of(JsonView object) {
  const std::string where = "data";
  if (!object.is_object()) complain(where, "not an object");
  const auto [samples, contours, balls, annotations, source, map] =
      object.pick<6>({"samples", "contours", "balls", "annotations", "source", "map"});
  SampleData out;
  read_flat(samples, "samples", out.positions, where);
  if (contours) out.contours = contours_of(contours, "contours");
  read_flat(balls, "balls", out.balls, where);
  Magnitudes seen;
  require_together(out.positions, samples, "samples", where, seen);
  require_together(out.balls, balls, "balls", where, seen);
  if (annotations) out.annotations = annotations_of(annotations);
  if (map) out.map = map_from(map);
  if (source) {
    SourceEdit read = source_from(source);
    if (!read.curves) throw Nonsense{"data: a source without curves", source};
    out.source = std::make_shared<const CurveSource>(
        CurveSource{std::move(read.curves), read.sampling, read.first, read.count});
  }
  return out;
}

// Clamps values of a later version, which may allow more, and keeps unknown parameters.
ComputationSettings settings_from(JsonView object) {
  const auto [precision, parameters] = object.pick<2>({"precision", "parameters"});
  ComputationSettings out;
  if (precision.is_text())
    for (const PrecisionDescriptor& descriptor : kPrecisionDescriptors)
      if (precision.text() == descriptor.id) out.precision = descriptor.precision;
  std::size_t unknown = 0;
  for (const auto& [id, value] : parameters.members()) {
    if (!value.is_number()) continue;
    const std::string name = id.text();
    const bool is_known =
        std::ranges::find(computation_parameters(), name, &Parameter::id) != computation_parameters().end();
    if (!is_known && ++unknown <= kMostSessionParameters) out.values.keep(name, value.number());
  }
  for (const Parameter& parameter : computation_parameters())
    if (const JsonView value = parameters.find(parameter.id); value.is_number())
      out[parameter] = within(parameter, value.number());
  return out;
}

SessionEvolution evolution_from(JsonView object) {
  const std::string where = "evolution";
  SessionEvolution out;
  out.id = text_from(object.find("id"), "id", where);
  const auto count = [&](const char* key, std::uint64_t& to) {
    const JsonView value = object.find(key);
    if (!value) return;
    const auto number = value.is_number() ? value.count() : std::nullopt;
    if (!number) complain(where, fmt::format("\"{}\" is not a whole number", key));
    to = *number;
  };
  count("seed", out.seed);
  count("step", out.step);
  std::map<std::string, double> parameters;
  for (const auto& [id, value] : object.find("parameters").members()) {
    parameters[id.text()] = number_of(value, where);
    if (parameters.size() > kMostSessionParameters) complain(where, "more than a thousand parameters");
  }
  out.parameters.assign(parameters.begin(), parameters.end());
  return out;
}

LayerConfiguration layers_from(JsonView value) {
  auto out = layer_configuration_from(value);
  if (!out) throw Nonsense{"layers: " + out.error().text};
  return std::move(*out);
}

// A view may be anywhere, however small or far away.
Box2 view_from(JsonView value) {
  if (value.size() != 4) complain("view", "not two corners");
  Box2 out;
  for (const Vec2 corner : places_of(value, "view")) out.add(corner);
  return out;
}

TimelineEdit edit_from(JsonView object) {
  const std::string where = "edit";
  if (!object.is_object()) complain(where, "not an object");
  const auto [name, continues, replaces, state, remove, move, insert, remove_balls, change_balls, insert_balls,
              contours, annotations, source] =
      object.pick<13>({"name", "continues", "replaces", "state", "remove", "move", "insert", "remove_balls",
                       "change_balls", "insert_balls", "contours", "annotations", "source"});
  TimelineEdit out;
  out.name = text_from(name, "name", where);
  out.continues = continues.is_flag() && continues.flag();
  out.replaces = replaces.is_flag() && replaces.flag();
  out.is_state = state.is_flag() && state.flag();
  read_flat(remove, "remove", out.removed, where);
  read_flat(move, "move", out.moved, where);
  read_flat(insert, "insert", out.inserted, where);
  read_flat(remove_balls, "remove_balls", out.removed_balls, where);
  read_flat(change_balls, "change_balls", out.changed_balls, where);
  read_flat(insert_balls, "insert_balls", out.inserted_balls, where);
  if (contours) out.curve = contours_of(contours, "contours");
  if (annotations) out.annotations = annotations_of(annotations);
  if (source) out.source = source_from(source);
  return out;
}

LayersChanged layers_changed_from(JsonView object) {
  const auto [changed, order, has_image] = object.pick<3>({"changed", "order", "has_image"});
  LayersChanged out;
  if (changed) {
    LayerConfiguration configuration = layers_from(changed);
    out.changed = std::move(configuration.layers);
    if (has_image) out.image = std::move(configuration.image);
  }
  for (const JsonView id : order.elements()) {
    if (!id.is_text()) continue;
    if (out.order.size() == kMostLayers) complain("layers", fmt::format("more than {}", kMostLayers));
    out.order.push_back(id.text());
  }
  return out;
}

LayersChanged layers_entry_from(JsonView object, JsonView layers) {
  using Role = LayersChanged::Role;
  LayersChanged out = layers_changed_from(layers);
  const auto [step, joins, undoes, redoes, back] = object.pick<5>({"step", "joins", "undoes", "redoes", "back"});
  if (step) out.name = text_from(step, "step", "layers");
  out.role = step ? Role::step : joins ? Role::joined : undoes ? Role::undone : redoes ? Role::redone : Role::noted;
  if (back) out.back.push_back(layers_changed_from(back));
  return out;
}

/// Nothing for an unknown kind.
std::optional<TimelineEntry> entry_from(JsonView object) {
  if (!object.is_object()) complain("entry", "not an object");
  const auto [edit, begin, end, undo, redo, layers, settings, view, caption, seconds] =
      object.pick<10>({"edit", "begin", "end", "undo", "redo", "layers", "settings", "view", "caption", "seconds"});
  if (edit) return edit_from(edit);
  if (begin) return GestureBegun{text_from(begin, "begin", "gesture")};
  if (end) return GestureEnded{};
  if (undo) return Undone{};
  if (redo) return Redone{};
  if (layers) return layers_entry_from(object, layers);
  if (settings) return SettingsChanged{settings_from(settings)};
  if (view) return ViewChanged{view_from(view)};
  if (caption) {
    constexpr double kLongest = 600.0;
    const double shown = seconds ? number_of(seconds, "caption") : 0.0;
    // A clamp would keep a negative zero, but entries are compared by their bytes.
    return Captioned{text_from(caption, "caption", "caption"), shown > 0.0 ? std::min(shown, kLongest) : 0.0};
  }
  return std::nullopt;
}

std::string entry_name(std::size_t i) {
  return fmt::format("entry {} of the timeline", i + 1);
}

/// A position on the timeline as written, and the variable to store it in.
struct WrittenPosition {
  std::uint64_t entries = 0;
  JsonView number{};
  std::size_t* to = nullptr;
};

// Unknown entries do not count: positions refer to the kept entries.
void read_timeline(JsonView timeline, std::vector<WrittenPosition> positions, TimelineLog& out) {
  if (timeline && !timeline.is_list()) complain("timeline", "not a list");
  std::ranges::sort(positions, {}, &WrittenPosition::entries);
  auto next = positions.begin();
  const auto arrive_at = [&](std::size_t entries) {
    for (; next != positions.end() && next->entries == entries; ++next) *next->to = out.size();
  };
  std::size_t number = 0;
  for (const JsonView object : timeline.elements()) {
    arrive_at(number);
    try {
      if (const auto entry = entry_from(object)) out.push_back(*entry);
    } catch (Nonsense& nonsense) {
      nonsense.text = entry_name(number) + ": " + nonsense.text;
      throw;
    }
    ++number;
  }
  arrive_at(number);
  if (next != positions.end())
    throw Nonsense{fmt::format("lesson: position {} on a timeline of {} {}", next->entries, number,
                               number == 1 ? "entry" : "entries"),
                   next->number};
}

LessonStep lesson_step_from(JsonView object, const std::string& where, WrittenPosition& position) {
  if (!object.is_object()) throw Nonsense{where + ": not an object", object};
  const auto [caption, entries, layers, settings, view, seconds] =
      object.pick<6>({"caption", "position", "layers", "settings", "view", "seconds"});
  LessonStep out;
  out.caption = short_text_from(caption, "caption", kLongestLessonCaption, where);
  if (entries) {
    const auto count = entries.is_number() ? entries.count() : std::nullopt;
    if (!count) throw Nonsense{where + ": \"position\" is not a whole number that counts entries", entries};
    position = {*count, entries, nullptr};
  }
  if (layers) out.layers = read_at(layers, where, layers_from);
  if (settings) {
    if (!settings.is_object()) throw Nonsense{where + ": \"settings\" is not an object", settings};
    out.settings = settings_from(settings);
  }
  if (view) out.view = read_at(view, where, view_from);
  if (seconds) {
    if (!seconds.is_number()) throw Nonsense{where + ": \"seconds\" is not a number", seconds};
    // A clamp would keep a negative zero.
    out.seconds = seconds.number() > 0.0 ? std::min(seconds.number(), kLongestLessonStep) : 0.0;
  }
  return out;
}

// The positions of the steps are set later.
std::vector<WrittenPosition> read_lesson(JsonView object, Lesson& out) {
  if (!object) return {};
  if (!object.is_object()) throw Nonsense{"lesson: not an object", object};
  const auto [title, steps] = object.pick<2>({"title", "steps"});
  out.title = short_text_from(title, "title", kLongestLessonTitle, "lesson");
  if (steps && !steps.is_list()) throw Nonsense{"lesson: \"steps\" is not a list", steps};
  const std::size_t count = steps.size();
  if (count > kMostLessonSteps)
    throw Nonsense{fmt::format("lesson: {} steps, more than {}", count, kMostLessonSteps), steps};
  out.steps.reserve(count);
  std::vector<WrittenPosition> positions(count);
  for (const JsonView step : steps.elements()) {
    const std::size_t i = out.steps.size();
    out.steps.push_back(lesson_step_from(step, fmt::format("step {} of the lesson", i + 1), positions[i]));
    positions[i].to = &out.steps[i].position;
  }
  return positions;
}

bool is_of_a_later_version(JsonView schema) {
  if (schema.is_whole()) {
    const auto version = schema.count();
    return version && *version > kSessionSchema;
  }
  complain("session", "it does not say its version");
}

/// The entries of a journal follow the session on separate lines.
enum class Timelines : std::uint8_t { within, following };

Session session_from(JsonView object, Timelines where) {
  const auto [what, schema, title, data, layers, settings, evolution, view, panes, lesson, timeline] =
      object.pick<11>({"mesecina", "schema", "title", "data", "layers", "settings", "evolution", "view", "panes",
                       "lesson", "timeline"});
  if (text_from(what, "mesecina", "session") != "session") complain("session", "this is not one");
  if (is_of_a_later_version(schema))
    complain("session", "written by a later version of the program, which this one does not understand");
  Session out;
  out.title = text_from(title, "title", "session");
  if (data) out.data = std::make_shared<const SampleData>(data_of(data));
  if (layers) out.layers = layers_from(layers);
  if (settings) out.settings = settings_from(settings);
  if (evolution) out.evolution = evolution_from(evolution);
  if (view) out.view = view_from(view);
  if (panes) {
    auto read = panes_from(panes);
    if (!read) throw Nonsense{std::move(read.error().text), read.error().at};
    out.panes = std::move(read->panes);
    out.pane_views = std::move(read->views);
  }
  std::vector<WrittenPosition> positions = read_lesson(lesson, out.lesson);
  if (where == Timelines::following)
    for (const WrittenPosition& position : std::exchange(positions, {})) *position.to = position.entries;
  read_timeline(timeline, std::move(positions), out.entries);
  return out;
}

std::unexpected<Error> bad_session(const std::string& file, std::string text, std::uint64_t line = 0) {
  return std::unexpected(Error{ErrorCode::bad_input, std::move(text), file, line, 0});
}

Expected<Session> parsed_session(std::string_view text, Timelines where, const std::string& file, JobControl* control,
                                 double done) {
  ReadJob job(control, done);
  job.begin(text);
  if (auto good = check_json(text, file, &job); !good) return std::unexpected(std::move(good.error()));
  try {
    return session_from(JsonView::whole(text), where);
  } catch (const Nonsense& nonsense) {
    if (!nonsense.at) return bad_session(file, nonsense.text);
    return bad_json(text, nonsense.at.offset_in(text), nonsense.text, file);
  }
}

SourceFile source_file_from(JsonView kept) {
  const auto [file, hash, size] = kept.pick<3>({"file", "hash", "size"});
  SourceFile out{text_from(file, "file", "kept_in"), {}};
  const std::string digits = text_from(hash, "hash", "kept_in");
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), out.fingerprint.hash).ptr;
  const auto bytes = size.count();
  if (end != digits.data() + digits.size() || !bytes) throw Nonsense{"kept_in: expected a size and a hash"};
  out.fingerprint.size = *bytes;
  return out;
}

}  // namespace

Expected<Session> read_session(std::string_view text, const std::string& file, JobControl* job, double done) {
  return parsed_session(text, Timelines::within, file, job, done);
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

Expected<void> replay_session(const Session& session, DocumentReplay& replay, const std::string& file,
                              JobControl* job) {
  if (job != nullptr) job->checkpoint();
  if (auto begun = replay.begin(*session.data); !begun) return bad_session(file, begun.error().text);
  for (std::size_t i = 0; i < session.entries.size(); ++i) {
    if (job != nullptr) job->checkpoint(i, session.entries.size());
    if (const auto done = replay.apply(session.entries[i]); !done)
      return bad_session(file, entry_name(i) + ": " + done.error().text);
  }
  replay.finish();
  return {};
}

Expected<Journaled> read_journal(std::string_view text, const std::string& file, JobControl* job) {
  Journaled out;
  bool is_first = true;
  bool has_unsaved_lesson = false;
  DocumentReplay replay;
  for (std::uint64_t line = 1; !text.empty(); ++line) {
    if (job != nullptr) job->checkpoint();
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      out.is_torn = true;
      break;
    }
    const std::string_view this_line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (is_first) {
      auto session = parsed_session(this_line, Timelines::following, file, job, 0.0);
      if (!session) return std::unexpected(session.error());
      out.session = std::move(*session);
      has_unsaved_lesson = !out.session.lesson.steps.empty();
      if (auto begun = replay.begin(*out.session.data); !begun) return bad_session(file, begun.error().text, line);
      is_first = false;
      continue;
    }
    const auto stop = [&](const std::string& why) { out.complaint = fmt::format("{}:{}: {}", file, line, why); };
    if (const auto good = check_json(this_line, file); !good) {
      stop(good.error().text);
      break;
    }
    try {
      const JsonView object = JsonView::whole(this_line);
      if (const JsonView saved = object.find("saved")) {
        out.unsaved_edits = 0;
        has_unsaved_lesson = has_unsaved_lesson && !saved.is_flag();
      }
      if (const JsonView kept = object.find("kept_in")) out.file = source_file_from(kept);
      const auto entry = entry_from(object);
      if (!entry) continue;
      out.unsaved_edits += is_work(*entry) ? 1U : 0U;
      if (const auto done = replay.apply(*entry); !done) {
        stop(done.error().text);
        break;
      }
      out.session.entries.push_back(*entry);
    } catch (const Nonsense& nonsense) {
      stop(nonsense.text);
      break;
    }
  }
  if (is_first) return bad_session(file, "the first line is missing");
  if (has_unsaved_lesson && out.unsaved_edits == 0) out.unsaved_edits = 1;
  LayerFold layers_now(std::move(out.session.layers));
  for (const TimelineEntry& entry : out.session.entries) {
    if (const auto* layers = std::get_if<LayersChanged>(&entry)) layers_now.apply(*layers);
    if (const auto* settings = std::get_if<SettingsChanged>(&entry)) out.session.settings = settings->settings;
    if (const auto* view = std::get_if<ViewChanged>(&entry)) out.session.view = view->visible;
  }
  out.session.layers = std::move(layers_now).take();
  // Entries that a lesson refers to may be torn off.
  for (LessonStep& step : out.session.lesson.steps)
    step.position = std::min(step.position, out.session.entries.size());
  return out;
}

}  // namespace mes
