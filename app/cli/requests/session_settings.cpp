// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/session_settings.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "app/cli/console/messages.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/names.h"
#include "app/playing/session_evolution.h"
#include "core/base/counted.h"
#include "core/graph/registry.h"

namespace mes::cli {

Expected<SourceInput> read_source(const Registry& registry, const Source& source) {
  auto file = read_input(registry, source.file, source.from, source.reading);
  if (!file) return std::unexpected(file.error());
  const auto settings =
      settings_of(registry, source, file->session ? file->session->settings : ComputationSettings());
  if (!settings) return std::unexpected(settings.error());
  return SourceInput{std::move(*file), *settings};
}

Expected<std::vector<LayerIndex>> shown_layers(const Registry& registry, const std::string& ids,
                                               const Session* session) {
  if (!ids.empty() || session == nullptr || session->layers.layers.empty()) return select_layers(registry, ids);
  std::vector<LayerIndex> out;
  std::size_t unknown = 0;
  for (const LayerConfiguration::Entry& entry : session->layers.layers) {
    const LayerIndex layer = registry.find_layer(entry.layer);
    if (layer == kNoLayer)
      ++unknown;
    else if (entry.visible && std::ranges::find(out, layer) == out.end())
      out.push_back(layer);
  }
  say_unknown_layers(unknown, "the session");
  return out;
}

std::optional<EvolutionChoice> evolution_in(const Registry& registry, const Session* session) {
  if (session == nullptr || !registry.evolutions().find(session->evolution.id)) return std::nullopt;
  return choice_of(registry, session->evolution);
}

SessionEvolution evolution_without_history(const Registry& registry, const Session& session) {
  SessionEvolution out = session.evolution;
  const auto evolution = registry.evolutions().find(out.id);
  if (!evolution || evolution->moved_parameter() == nullptr) out.step = 0;
  return out;
}

void say_unknown_layers(std::size_t count, const std::string& what) {
  if (count != 0) say(fmt::format("{}: {} not available here", what, counted(count, "layer is", "layers are")));
}

}  // namespace mes::cli
