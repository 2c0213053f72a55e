// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/timeline/layer_fold.h"

#include <algorithm>
#include <utility>

namespace mes {

LayerFold::LayerFold(LayerConfiguration begin, Keeps keeps)
    : configuration_(std::move(begin)), keeps_(std::move(keeps)) {
  if (keeps_)
    std::erase_if(configuration_.layers,
                  [this](const LayerConfiguration::Entry& entry) { return !keeps_(entry.layer); });
  note_places();
}

void LayerFold::apply(const LayersChanged& change) {
  for (const LayerConfiguration::Entry& entry : change.changed) {
    if (keeps_ && !keeps_(entry.layer)) continue;
    const auto [at, is_new] = place_.try_emplace(entry.layer, configuration_.layers.size());
    if (is_new)
      configuration_.layers.push_back(entry);
    else
      configuration_.layers[at->second] = entry;
  }
  if (!change.order.empty()) put_in_order(change.order);
  if (change.image) configuration_.image = *change.image;
}

void LayerFold::put_in_order(const std::vector<std::string>& order) {
  std::unordered_map<std::string_view, std::size_t> rank_of;
  for (const std::string& layer : order) rank_of.try_emplace(layer, rank_of.size());
  std::vector<std::pair<std::size_t, LayerConfiguration::Entry>> ranked;
  for (LayerConfiguration::Entry& entry : configuration_.layers)
    if (const auto rank = rank_of.find(entry.layer); rank != rank_of.end())
      ranked.emplace_back(rank->second, std::move(entry));
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, LayerConfiguration::Entry>::first);
  configuration_.layers.clear();
  for (auto& [rank, entry] : ranked) configuration_.layers.push_back(std::move(entry));
  note_places();
}

void LayerFold::note_places() {
  place_.clear();
  for (std::size_t i = 0; i < configuration_.layers.size(); ++i)
    place_.try_emplace(configuration_.layers[i].layer, i);
}

}  // namespace mes
