// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playing/player.h"

#include <utility>

#include "core/graph/registry.h"

namespace mes {
namespace {

// Layers of a later version cannot be shown, and would only slow down changes of the others.
LayerFold known_layers(const Registry& registry, LayerConfiguration configuration) {
  return LayerFold(std::move(configuration),
                   [&registry](std::string_view layer) { return registry.find_layer(layer) != kNoLayer; });
}

}  // namespace

Player::Player(const Registry& registry, const Session& session, OnPatch on_patch)
    : data_(session.data),
      playback_(session.entries),
      on_patch_(std::move(on_patch)),
      layers_(registry.layers()),
      layer_fold_(known_layers(registry, {})),
      engine_(registry, {}),
      replay_({}, [this](const DocumentDelta& delta) {
        deltas_.push_back(std::make_shared<const DocumentDelta>(delta));
      }) {
  PlayStart start = start_of(session);
  layer_fold_ = known_layers(registry, std::move(start.layers));
  settings_ = start.settings;
  view_ = start.view;
  if (!layer_fold_.configuration().layers.empty()) layers_.set_configuration(layer_fold_.configuration());
}

Expected<void> Player::change_document(const TimelineEntry& entry) {
  return replay_.apply(entry);
}

void Player::change_layers(const LayersChanged& change) {
  layer_fold_.apply(change);
  layers_.set_configuration(layer_fold_.configuration());
}

Expected<void> Player::apply(const PlayStep& step) {
  if (!std::exchange(has_begun_, true))
    if (auto begun = replay_.begin(*data_); !begun) return begun;
  return playback_.perform(step, *this);
}

std::string Player::complete() {
  // Posts everything at once: some layers show the changes of the last run, so runs must not depend on the engine's
  // speed.
  engine_.post(
      {.deltas = std::exchange(deltas_, {}), .settings = settings_, .demand = main_layers(layers_.visible_layers())});
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
