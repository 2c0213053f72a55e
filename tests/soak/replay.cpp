// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/replay.h"

#include <algorithm>
#include <exception>
#include <iterator>

#include "app/layers/layer_stack.h"
#include "tests/soak/picture_check.h"
#include "tests/support/builtin_layers.h"

namespace mes::test {

std::string trouble_of(const Session& session) {
  Consumer consumer;
  LayerStack layers(layer_descriptors());
  LayerConfiguration configuration = session.layers;
  ComputationSettings settings = session.settings;
  DocumentReplay replay(
      {}, [&](const DocumentDelta& delta) { consumer.graph.post(std::make_shared<const DocumentDelta>(delta)); });
  try {
    if (!replay.begin(*session.data)) return {};
    layers.set_configuration(configuration);
    consumer.graph.set_demand(layers.visible_layers());
    for (const TimelineEntry& entry : session.entries) {
      if (const auto* changed = std::get_if<LayersChanged>(&entry)) {
        apply(*changed, configuration);
        layers.set_configuration(configuration);
        consumer.graph.set_demand(layers.visible_layers());
      } else if (const auto* chosen = std::get_if<SettingsChanged>(&entry)) {
        settings = chosen->settings;
        consumer.graph.post_settings(settings);
      } else if (!replay.apply(entry)) {
        return {};
      }
      if (is_visible(entry)) consumer.run();
    }
    consumer.graph.post_settings(settings);
    consumer.run();
    return difference_from_fresh(consumer, replay.document(), settings, layers.visible_layers());
  } catch (const std::exception& error) {
    return error.what();
  }
}

Session shortened(Session session, int most) {
  if (trouble_of(session).empty()) return session;
  for (std::size_t length = (session.entries.size() + 1) / 2; length != 0; length /= 2) {
    for (std::size_t first = 0; first + length <= session.entries.size() && most > 0;) {
      std::vector<TimelineEntry> left = session.entries.between(0, first);
      std::ranges::move(session.entries.between(first + length, session.entries.size()), std::back_inserter(left));
      Session candidate = session;
      candidate.entries = TimelineLog(left.begin(), left.end());
      --most;
      if (trouble_of(candidate).empty())
        first += length;
      else
        session = std::move(candidate);
    }
  }
  return session;
}

}  // namespace mes::test
