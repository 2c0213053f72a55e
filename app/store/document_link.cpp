// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/document_link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/io/session/json_text.h"

namespace mes {
namespace {

using Json = nlohmann::json;

std::unexpected<Error> refusal(std::string text) {
  return std::unexpected(Error{.code = ErrorCode::bad_input, .text = std::move(text)});
}

/// The numbers of one array; nothing unless it has exactly `N` finite numbers.
template <std::size_t N>
std::optional<std::array<double, N>> numbers_of(const Json& values) {
  if (!values.is_array() || values.size() != N) return {};
  std::array<double, N> out{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!values[i].is_number()) return {};
    out[i] = values[i].get<double>();
    if (!std::isfinite(out[i])) return {};
  }
  return out;
}

std::optional<std::size_t> place_of(const Json& value, std::size_t count) {
  if (!value.is_number_unsigned()) return {};
  const auto place = value.get<std::uint64_t>();
  if (place >= count) return {};
  return static_cast<std::size_t>(place);
}

template <std::size_t N>
bool read_moved(const Json& lists, const char* key, std::size_t count,
                std::vector<std::pair<std::size_t, std::array<double, N>>>& out) {
  if (!lists.contains(key)) return true;
  for (const Json& one : lists[key]) {
    const auto all = numbers_of<N + 1>(one);
    const auto place = all ? place_of(one[0], count) : std::nullopt;
    if (!place) return false;
    std::array<double, N> values{};
    std::copy(all->begin() + 1, all->end(), values.begin());
    out.emplace_back(*place, values);
  }
  return true;
}

bool read_places(const Json& lists, const char* key, std::size_t count, std::vector<std::size_t>& out) {
  if (!lists.contains(key)) return true;
  for (const Json& one : lists[key]) {
    const auto place = place_of(one, count);
    if (!place) return false;
    out.push_back(*place);
  }
  std::ranges::sort(out);
  return std::ranges::adjacent_find(out) == out.end();
}

template <std::size_t N>
bool read_inserted(const Json& lists, const char* key, std::vector<std::array<double, N>>& out) {
  if (!lists.contains(key)) return true;
  for (const Json& one : lists[key]) {
    const auto values = numbers_of<N>(one);
    if (!values) return false;
    out.push_back(*values);
  }
  return true;
}

template <class T>
void remove_places(std::vector<T>& from, const std::vector<std::size_t>& places) {
  if (places.empty()) return;
  std::size_t kept = 0, next = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (next < places.size() && places[next] == i)
      ++next;
    else
      from[kept++] = from[i];
  }
  from.resize(kept);
}

Json as_json(Vec2 p) {
  return {p.x, p.y};
}
Json as_json(const Disk& d) {
  return {d.center.x, d.center.y, d.radius};
}

/// Writes the changes that turn the old list into the new one. New elements have ids that the old list lacks.
template <class Id, class Value>
void write_difference(const std::vector<Id>& old_ids, const std::vector<Value>& old_values,
                      const std::vector<Id>& ids, const std::vector<Value>& values, const std::string& suffix,
                      Json& to) {
  std::unordered_map<std::uint32_t, std::size_t> place;
  for (std::size_t i = 0; i < ids.size(); ++i) place.emplace(ids[i].value, i);
  Json moved = Json::array(), removed = Json::array(), inserted = Json::array();
  std::vector<bool> is_known(ids.size());
  for (std::size_t i = 0; i < old_ids.size(); ++i) {
    const auto now = place.find(old_ids[i].value);
    if (now == place.end()) {
      removed.push_back(i);
      continue;
    }
    is_known[now->second] = true;
    if (values[now->second] == old_values[i]) continue;
    Json one = as_json(values[now->second]);
    one.insert(one.begin(), i);
    moved.push_back(std::move(one));
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (!is_known[i]) inserted.push_back(as_json(values[i]));
  if (!moved.empty()) to["moved" + suffix] = std::move(moved);
  if (!removed.empty()) to["removed" + suffix] = std::move(removed);
  if (!inserted.empty()) to["inserted" + suffix] = std::move(inserted);
}

/// Orders the elements as the other side has them: the remaining old ones in their order, then the new ones.
template <class Id, class Value>
void put_in_agreed_order(const std::vector<Id>& old_ids, std::vector<Id>& ids, std::vector<Value>& values) {
  std::unordered_map<std::uint32_t, std::size_t> place;
  for (std::size_t i = 0; i < ids.size(); ++i) place.emplace(ids[i].value, i);
  std::vector<std::size_t> order;
  order.reserve(ids.size());
  std::vector<bool> is_known(ids.size());
  for (const Id id : old_ids)
    if (const auto now = place.find(id.value); now != place.end()) {
      order.push_back(now->second);
      is_known[now->second] = true;
    }
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (!is_known[i]) order.push_back(i);
  std::vector<Id> new_ids;
  std::vector<Value> new_values;
  for (const std::size_t i : order) {
    new_ids.push_back(ids[i]);
    new_values.push_back(values[i]);
  }
  ids = std::move(new_ids);
  values = std::move(new_values);
}

/// Writes contours as indices of samples.
Json as_json(const std::vector<CurveOrder::Contour>& contours, const std::vector<SampleId>& samples) {
  std::unordered_map<std::uint32_t, std::size_t> place;
  for (std::size_t i = 0; i < samples.size(); ++i) place.emplace(samples[i].value, i);
  Json out = Json::array();
  for (const CurveOrder::Contour& contour : contours) {
    Json places = Json::array();
    for (const SampleId id : contour.samples) places.push_back(place.at(id.value));
    out.push_back({contour.closed, std::move(places)});
  }
  return out;
}

using LinkedContours = std::vector<std::pair<bool, std::vector<std::size_t>>>;

/// Reads contours, whose indices must be below the count.
bool read_contours(const Json& lists, std::size_t count, std::optional<LinkedContours>& out) {
  if (!lists.contains("contours")) return true;
  out.emplace();
  for (const Json& one : lists["contours"]) {
    if (!one.is_array() || one.size() != 2 || !one[0].is_boolean() || !one[1].is_array()) return false;
    auto& [is_closed, places] = out->emplace_back(one[0].get<bool>(), std::vector<std::size_t>());
    for (const Json& value : one[1]) {
      const auto place = place_of(value, count);
      if (!place) return false;
      places.push_back(*place);
    }
  }
  return true;
}

bool read_settings(const Json& lists, DocumentLink::Settings& out) {
  if (!lists.contains("settings")) return true;
  if (!lists["settings"].is_object()) return false;
  for (const auto& [id, value] : lists["settings"].items()) {
    if (id == "precision" && value.is_string())
      out.precision = value.get<std::string>();
    else if (id != "precision" && value.is_number() && std::isfinite(value.get<double>()))
      out.parameters[id] = value.get<double>();
    else
      return false;
  }
  return true;
}

Json as_json(const DocumentLink::Settings& settings, const DocumentLink::Settings& known) {
  Json out = Json::object();
  if (settings.precision != known.precision) out["precision"] = settings.precision;
  for (const auto& [id, value] : settings.parameters) {
    const auto found = known.parameters.find(id);
    if (found == known.parameters.end() || found->second != value) out[id] = value;
  }
  return out;
}

void take_over(const DocumentLink::Settings& from, DocumentLink::Settings& to) {
  if (!from.precision.empty()) to.precision = from.precision;
  for (const auto& [id, value] : from.parameters) to.parameters[id] = value;
}

/// Removes the samples for which `is_gone` holds, and contours left empty.
template <class IsGone>
void remove_from(std::vector<CurveOrder::Contour>& contours, IsGone is_gone) {
  for (CurveOrder::Contour& contour : contours) std::erase_if(contour.samples, is_gone);
  std::erase_if(contours, [](const CurveOrder::Contour& contour) { return contour.samples.empty(); });
}

}  // namespace

struct DocumentLink::Change {
  std::vector<std::pair<std::size_t, std::array<double, 2>>> moved;
  std::vector<std::size_t> removed;
  std::vector<std::array<double, 2>> inserted;
  std::vector<std::pair<std::size_t, std::array<double, 3>>> moved_balls;
  std::vector<std::size_t> removed_balls;
  std::vector<std::array<double, 3>> inserted_balls;
  std::optional<LinkedContours> contours;
  Settings settings;
};

Expected<Session> DocumentLink::begun_by(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("session") || !json["session"].is_string())
    return refusal("the first line of a link holds no session");
  return read_session(json["session"].get_ref<const std::string&>(), "link");
}

DocumentLink::Lists DocumentLink::lists_of(const Document& document, const Settings& settings) {
  Lists out{.contours = document.curve_order()->contours, .settings = settings};
  remove_from(out.contours, [&](SampleId id) { return document.slot_of(id) == kNoSlot; });
  for (const SampleSlot slot : document.slots_in_input_order()) {
    out.samples.push_back(document.id(slot));
    out.positions.push_back(document.position(slot));
  }
  for (const BallSlot slot : document.ball_slots_in_input_order()) {
    out.balls.push_back(document.ball_id(slot));
    out.disks.push_back(document.disk(slot));
  }
  return out;
}

void DocumentLink::begin(const Document& document, const Settings& settings) {
  agreed_ = lists_of(document, settings);
  compared_ = document.revision();
  compared_settings_ = settings;
  has_begun_ = true;
}

Expected<std::string> DocumentLink::take(std::string_view line, Editor& editor, Settings& settings) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return refusal("a line of the link is no object");
  if (json.contains("accepted")) {
    if (!proposed_ || json["accepted"] != number_ + 1) return refusal("the link accepts what was not proposed");
    agreed_ = *std::exchange(proposed_, {});
    ++number_;
    return std::string();
  }
  Change change;
  if (!json.contains("number") || (json.contains("name") && !json["name"].is_string()) ||
      json["number"] != number_ + 1 || !read_moved(json, "moved", agreed_.samples.size(), change.moved) ||
      !read_places(json, "removed", agreed_.samples.size(), change.removed) ||
      !read_inserted(json, "inserted", change.inserted) ||
      !read_moved(json, "moved_balls", agreed_.balls.size(), change.moved_balls) ||
      !read_places(json, "removed_balls", agreed_.balls.size(), change.removed_balls) ||
      !read_inserted(json, "inserted_balls", change.inserted_balls) ||
      !read_contours(json, agreed_.samples.size() - change.removed.size() + change.inserted.size(),
                     change.contours) ||
      !read_settings(json, change.settings))
    return refusal("a line of the link makes no sense");
  // Another change came first. Remaining differences are proposed again.
  proposed_.reset();
  compared_ = ~std::uint64_t{0};
  ++number_;
  make(change, json.value("name", std::string("Edit")), editor);
  take_over(change.settings, agreed_.settings);
  take_over(change.settings, settings);
  return json_text(Json{{"made", number_}});
}

// Indices of elements that were removed here meanwhile are skipped.
void DocumentLink::make(const Change& change, const std::string& name, Editor& editor) {
  const Document& document = editor.document();
  std::vector<std::pair<SampleId, Vec2>> moved;
  std::vector<std::pair<BallId, Disk>> moved_balls;
  std::vector<SampleId> removed;
  std::vector<BallId> removed_balls;
  for (const auto& [place, to] : change.moved) {
    agreed_.positions[place] = {to[0], to[1]};
    if (document.slot_of(agreed_.samples[place]) != kNoSlot)
      moved.emplace_back(agreed_.samples[place], agreed_.positions[place]);
  }
  for (const auto& [place, to] : change.moved_balls) {
    agreed_.disks[place] = {{to[0], to[1]}, to[2]};
    if (document.ball_slot_of(agreed_.balls[place]) != kNoSlot)
      moved_balls.emplace_back(agreed_.balls[place], agreed_.disks[place]);
  }
  for (const std::size_t place : change.removed)
    if (document.slot_of(agreed_.samples[place]) != kNoSlot) removed.push_back(agreed_.samples[place]);
  for (const std::size_t place : change.removed_balls)
    if (document.ball_slot_of(agreed_.balls[place]) != kNoSlot) removed_balls.push_back(agreed_.balls[place]);
  std::unordered_set<std::uint32_t> gone;
  for (const std::size_t place : change.removed) gone.insert(agreed_.samples[place].value);
  if (!gone.empty()) remove_from(agreed_.contours, [&](SampleId id) { return gone.contains(id.value); });
  remove_places(agreed_.samples, change.removed);
  remove_places(agreed_.positions, change.removed);
  remove_places(agreed_.balls, change.removed_balls);
  remove_places(agreed_.disks, change.removed_balls);

  std::vector<Vec2> inserted;
  std::vector<Disk> inserted_balls;
  for (const auto& p : change.inserted) inserted.push_back({p[0], p[1]});
  for (const auto& d : change.inserted_balls) inserted_balls.push_back({{d[0], d[1]}, d[2]});
  // The other side has checked the numbers. If the editor still refuses some, they are proposed as a difference.
  editor.begin_gesture(name);
  if (!removed.empty() || !removed_balls.empty()) static_cast<void>(editor.remove(removed, removed_balls, name));
  if (!moved.empty() || !moved_balls.empty()) static_cast<void>(editor.move(moved, moved_balls, name));
  if (!inserted.empty())
    if (const auto slots = editor.insert(inserted, name))
      for (std::size_t i = 0; i < slots->size(); ++i) {
        agreed_.samples.push_back(document.id((*slots)[i]));
        agreed_.positions.push_back(inserted[i]);
      }
  if (!inserted_balls.empty())
    if (const auto slots = editor.insert_balls(inserted_balls, name))
      for (std::size_t i = 0; i < slots->size(); ++i) {
        agreed_.balls.push_back(document.ball_id((*slots)[i]));
        agreed_.disks.push_back(inserted_balls[i]);
      }
  if (change.contours) {
    agreed_.contours.clear();
    for (const auto& [is_closed, places] : *change.contours) {
      CurveOrder::Contour& contour = agreed_.contours.emplace_back(CurveOrder::Contour{is_closed, {}});
      for (const std::size_t place : places)
        if (place < agreed_.samples.size()) contour.samples.push_back(agreed_.samples[place]);
    }
    static_cast<void>(editor.set_contours({agreed_.contours}, name));
  }
  editor.end_gesture();
}

std::optional<std::string> DocumentLink::propose(const Editor& editor, const Settings& settings) {
  const Document& document = editor.document();
  if (!may_propose(editor, settings)) return {};
  Lists now = lists_of(document, settings);
  Json change = Json::object();
  write_difference(agreed_.samples, agreed_.positions, now.samples, now.positions, "", change);
  write_difference(agreed_.balls, agreed_.disks, now.balls, now.disks, "_balls", change);
  put_in_agreed_order(agreed_.samples, now.samples, now.positions);
  std::vector<CurveOrder::Contour> expected = agreed_.contours;
  remove_from(expected, [&](SampleId id) { return document.slot_of(id) == kNoSlot; });
  if (expected != now.contours) change["contours"] = as_json(now.contours, now.samples);
  if (Json changed = as_json(settings, agreed_.settings); !changed.empty()) change["settings"] = std::move(changed);
  compared_ = document.revision();
  compared_settings_ = settings;
  if (change.empty()) return {};
  change["number"] = number_ + 1;
  change["name"] = editor.can_undo() ? editor.undo_name() : "Edit";
  put_in_agreed_order(agreed_.balls, now.balls, now.disks);
  proposed_ = std::move(now);
  return json_text(change);
}

}  // namespace mes
