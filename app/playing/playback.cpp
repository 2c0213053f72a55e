// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/playback.h"

#include <fmt/core.h>
#include <utility>

namespace mes {
namespace {

std::string_view name_of(const TimelineEntry& entry) {
  struct Name {
    std::string_view operator()(const TimelineEdit&) const { return "edit"; }
    std::string_view operator()(const GestureBegun&) const { return "begin"; }
    std::string_view operator()(const GestureEnded&) const { return "end"; }
    std::string_view operator()(const Undone&) const { return "undo"; }
    std::string_view operator()(const Redone&) const { return "redo"; }
    std::string_view operator()(const LayersChanged&) const { return "layers"; }
    std::string_view operator()(const SettingsChanged&) const { return "settings"; }
    std::string_view operator()(const ViewChanged&) const { return "view"; }
    std::string_view operator()(const Captioned&) const { return "caption"; }
  };
  return std::visit(Name{}, entry);
}

}  // namespace

std::vector<PlayStep> steps_of(const TimelineLog& entries) {
  std::vector<PlayStep> out;
  std::size_t first = 0;
  for (std::size_t at = 0; at < entries.size(); ++at) {
    const TimelineEntry entry = entries[at];
    if (out.empty() && (is_work(entry) || std::holds_alternative<GestureBegun>(entry))) {
      out.push_back({.first_entry = 0, .end_entry = at, .what = "open"});
      first = at;
    }
    if (out.empty() || !is_visible(entry)) continue;
    const auto* caption = std::get_if<Captioned>(&entry);
    out.push_back({first, at + 1, name_of(entry), caption == nullptr ? 0.0 : caption->seconds});
    first = at + 1;
  }
  if (out.empty()) out.push_back({.first_entry = 0, .end_entry = entries.size(), .what = "open"});
  return out;
}

PlayStart start_of(const Session& session) {
  const std::size_t end = steps_of(session.entries).front().end_entry;
  const auto begins_with = [&](auto is_kind) {
    for (std::size_t i = 0; i < end; ++i)
      if (is_kind(session.entries[i])) return true;
    return false;
  };
  PlayStart out;
  if (!begins_with([](const TimelineEntry& entry) { return std::holds_alternative<LayersChanged>(entry); }))
    out.layers = session.layers;
  if (!begins_with([](const TimelineEntry& entry) { return std::holds_alternative<SettingsChanged>(entry); }))
    out.settings = session.settings;
  if (!begins_with([](const TimelineEntry& entry) { return std::holds_alternative<ViewChanged>(entry); }))
    out.view = session.view;
  return out;
}

Expected<void> Playback::perform(const TimelineEntry& entry, Stage& stage) {
  if (const auto* layers = std::get_if<LayersChanged>(&entry)) {
    stage.change_layers(*layers);
  } else if (const auto* settings = std::get_if<SettingsChanged>(&entry)) {
    stage.change_settings(settings->settings);
  } else if (const auto* view = std::get_if<ViewChanged>(&entry)) {
    stage.look_at(view->visible);
  } else if (const auto* caption = std::get_if<Captioned>(&entry)) {
    caption_ = caption->text;
  } else {
    return stage.change_document(entry);
  }
  return {};
}

Expected<void> Playback::perform(const PlayStep& step, Stage& stage) {
  return perform(step.first_entry, step.end_entry, stage);
}

Expected<void> Playback::perform(std::size_t first, std::size_t end, Stage& stage) {
  for (std::size_t i = first; i < end; ++i) {
    auto done = perform(entries_[i], stage);
    if (!done) {
      done.error().text = fmt::format("entry {} of the timeline: {}", i + 1, done.error().text);
      return done;
    }
  }
  return {};
}

}  // namespace mes
