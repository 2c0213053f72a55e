// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/player.h"

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

// Layers of a later version cannot be shown, and would only make each change of the others longer.
LayerFold known_layers(LayerConfiguration configuration) {
  return LayerFold(std::move(configuration), [](std::string_view layer) { return find_layer(layer) != kNoSlot; });
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

Player::Player(const Session& session, OnPatch on_patch)
    : session_(session),
      steps_(steps_of(session_.entries)),
      on_patch_(std::move(on_patch)),
      layers_(layer_descriptors()),
      layer_fold_(known_layers({})),
      engine_({}),
      replay_({}, [this](const DocumentDelta& delta) {
        deltas_.push_back(std::make_shared<const DocumentDelta>(delta));
      }) {
  // A timeline that does not begin with them was made by other hands: what was there last will do.
  const auto begins_with = [this](auto is_kind) {
    for (std::size_t i = 0; i < steps_.front().end_entry; ++i)
      if (is_kind(session_.entries[i])) return true;
    return false;
  };
  if (!begins_with([](const TimelineEntry& entry) { return std::holds_alternative<LayersChanged>(entry); }))
    layer_fold_ = known_layers(session_.layers);
  if (!begins_with([](const TimelineEntry& entry) { return std::holds_alternative<SettingsChanged>(entry); }))
    settings_ = session_.settings;
  if (!begins_with([](const TimelineEntry& entry) { return std::holds_alternative<ViewChanged>(entry); }))
    view_ = session_.view;
  if (!layer_fold_.configuration().layers.empty()) layers_.set_configuration(layer_fold_.configuration());
}

Expected<void> Player::apply(const TimelineEntry& entry) {
  if (const auto* layers = std::get_if<LayersChanged>(&entry)) {
    layer_fold_.apply(*layers);
    layers_.set_configuration(layer_fold_.configuration());
  } else if (const auto* settings = std::get_if<SettingsChanged>(&entry)) {
    settings_ = settings->settings;
  } else if (const auto* view = std::get_if<ViewChanged>(&entry)) {
    view_ = view->visible;
  } else if (const auto* caption = std::get_if<Captioned>(&entry)) {
    caption_ = caption->text;
  } else {
    return replay_.apply(entry);
  }
  return {};
}

Expected<void> Player::apply(const PlayStep& step) {
  if (!std::exchange(has_begun_, true))
    if (auto begun = replay_.begin(*session_.data); !begun) return begun;
  for (std::size_t i = step.first_entry; i < step.end_entry; ++i) {
    auto done = apply(session_.entries[i]);
    if (!done) {
      done.error().text = "entry " + std::to_string(i + 1) + " of the timeline: " + done.error().text;
      return done;
    }
  }
  return {};
}

std::string Player::complete() {
  // In one piece: some layers show what the last run changed, so runs must not depend on how fast the engine is.
  engine_.post({.deltas = std::exchange(deltas_, {}), .settings = settings_, .demand = layers_.visible_layers()});
  std::string failure;
  while (auto patch = engine_.sync()) {
    failure.clear();
    for (const NodeReport& node : patch->nodes)
      if (node.state == NodeState::failed) failure = node.structure + ": " + node.reason;
    if (on_patch_) on_patch_(*patch);
    engine_.recycle(std::move(patch));
  }
  return failure;
}

}  // namespace mes
