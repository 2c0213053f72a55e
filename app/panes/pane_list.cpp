// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panes/pane_list.h"

#include <fmt/core.h>
#include <algorithm>
#include <optional>

#include "app/layers/words/parameter_words.h"
#include "core/base/assert.h"
#include "core/draw/variant.h"
#include "core/graph/registry.h"

namespace mes {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

/// The settings of a pane.
ComputationSettings settings_of(const Registry& registry, const PaneChoice& choice, const ComputationSettings& main,
                                const PaneEvolution& evolution) {
  ComputationSettings out = main;
  if (const Precision* const precision = std::get_if<Precision>(&choice)) out.precision = *precision;
  if (const auto* const parameter = std::get_if<ParameterChoice>(&choice))
    // An unknown parameter would only start a second computation with equal results. A session may name one by id
    // alone.
    if (const Parameter* const known = registry.find_parameter(parameter->parameter.id))
      out[*known] = parameter->value;
  const ParameterMove* const move = evolution.choice.moved_parameter();
  if (const auto* const evolved = std::get_if<EvolvedChoice>(&choice); evolved != nullptr && move != nullptr)
    out[move->parameter] =
        moved_value(*move, evolution.first, evolved->step, evolution.choice.values).value_or(main[move->parameter]);
  return out;
}

/// The version of the document that a pane shows; nothing: that of the main pane.
std::optional<VersionChoice> version_of(const PaneChoice& choice, const PaneEvolution& evolution) {
  if (const auto* const before = std::get_if<BeforeLastEdit>(&choice)) return *before;
  const auto* const evolved = std::get_if<EvolvedChoice>(&choice);
  const bool moves_samples = evolution.choice.moved_parameter() == nullptr;
  return evolved != nullptr && moves_samples ? std::optional<VersionChoice>(*evolved) : std::nullopt;
}

/// The visible layers when a stack takes the configuration.
ShownPanes::Layers visible_in(const LayerConfiguration& configuration, const LayerStack& layers) {
  LayerStack stack = layers;
  stack.set_configuration(configuration);
  return visible_layers(stack);
}

ShownPanes::Layers layers_of(const PaneChoice& choice, const LayerStack& layers) {
  if (const FamilyKind* const family = std::get_if<FamilyKind>(&choice))
    return visible_in(in_family(layers.descriptors(), layers.configuration(), *family), layers);
  if (const Bundle* const bundle = std::get_if<Bundle>(&choice)) return visible_in(bundle->layers, layers);
  return visible_layers(layers);
}

}  // namespace

ShownPanes::Layers visible_layers(const LayerStack& layers) {
  ShownPanes::Layers out;
  for (const LayerIndex layer : layers.visible_layers()) out.emplace_back(layer, layers.style(layer));
  return out;
}

std::string words_of(const PaneChoice& choice) {
  return std::visit(Overloaded{[](Precision precision) {
                                 return std::string(kPrecisionDescriptors[static_cast<std::size_t>(precision)].name);
                               },
                               [](const ParameterChoice& parameter) {
                                 return fmt::format("{} {:.4g}", title_of(parameter.parameter), parameter.value);
                               },
                               [](FamilyKind family) { return std::string(title_of(group_of(family))); },
                               [](const Bundle& bundle) { return bundle.name; },
                               [](const EvolvedChoice& evolved) { return fmt::format("Step {}", evolved.step); },
                               [](const BeforeLastEdit&) { return std::string("Before the last edit"); }},
                    choice);
}

void PaneList::add(PaneChoice choice) {
  if (is_full()) return;
  panes_.push_back(std::move(choice));
  keys_.push_back(next_key_++);
  ++revision_;
}

void PaneList::change(std::size_t pane, PaneChoice choice) {
  MES_ASSERT(pane < panes_.size());
  if (panes_[pane] == choice) return;
  panes_[pane] = std::move(choice);
  ++revision_;
}

void PaneList::close(std::size_t pane) {
  MES_ASSERT(pane < panes_.size());
  panes_.erase(panes_.begin() + static_cast<std::ptrdiff_t>(pane));
  keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(pane));
  ++revision_;
}

void PaneList::close_all() {
  if (panes_.empty()) return;
  panes_.clear();
  keys_.clear();
  ++revision_;
}

void PaneList::set(std::vector<PaneChoice> panes) {
  panes.resize(std::min(panes.size(), kMost));
  if (panes_ == panes) return;
  panes_ = std::move(panes);
  keys_.clear();
  while (keys_.size() < panes_.size()) keys_.push_back(next_key_++);
  ++revision_;
}

void PaneList::resolve(const Registry& registry) {
  for (PaneChoice& pane : panes_) {
    auto* const choice = std::get_if<ParameterChoice>(&pane);
    const Parameter* const known = choice != nullptr ? registry.find_parameter(choice->parameter.id) : nullptr;
    if (known == nullptr) continue;
    choice->parameter = *known;
    const double value = within(*known, choice->value);
    if (choice->value == value) continue;
    choice->value = value;
    ++revision_;
  }
}

void PaneList::set_free_cameras(bool are_free) {
  if (has_free_cameras_ == are_free) return;
  has_free_cameras_ = are_free;
  ++revision_;
}

std::vector<std::string> words_of(const PaneList& list, const MainPane& main) {
  std::vector<std::string> out;
  if (list.is_empty()) return {{}};
  out.push_back(
      std::visit(Overloaded{[&](Precision) { return words_of(main.settings.precision); },
                            [&](const ParameterChoice& other) {
                              return words_of(ParameterChoice{other.parameter, main.settings[other.parameter]});
                            },
                            [&](FamilyKind) { return words_of(main.family); },
                            [&](const Bundle&) { return main.bundle.empty() ? "Layers of the list" : main.bundle; },
                            [&](const EvolvedChoice&) { return words_of(EvolvedChoice{main.step}); },
                            [](const BeforeLastEdit&) { return std::string("Now"); }},
                 list.panes().front()));
  for (const PaneChoice& choice : list.panes()) out.push_back(words_of(choice));
  return out;
}

PaneChoice next_choice(const PaneList& list, const ComputationSettings& settings) {
  for (const Precision precision : {Precision::exact, Precision::naive, Precision::fast, Precision::exact_roots}) {
    const bool is_used = precision == settings.precision ||
                         std::ranges::find(list.panes(), PaneChoice(precision)) != list.panes().end();
    if (!is_used) return precision;
  }
  return settings.precision;
}

ShownPanes shown_panes(const Registry& registry, const PaneList& list, const LayerStack& layers,
                       const ComputationSettings& settings, const PaneEvolution& evolution) {
  ShownPanes out;
  out.demand = main_layers(layers.visible_layers());
  for (const PaneChoice& choice : list.panes()) {
    VariantIndex variant = kMainVariant;
    const ComputationSettings own = settings_of(registry, choice, settings, evolution);
    const std::optional<VersionChoice> version = version_of(choice, evolution);
    if (own != settings || version) {
      std::size_t found = 0;
      while (found < out.variants.size() && (out.variants[found].settings != own || out.versions[found] != version))
        ++found;
      variant = static_cast<VariantIndex>(found) + 1;
      if (found == out.variants.size()) {
        out.variants.push_back({.settings = own, .has_document = version.has_value()});
        out.versions.push_back(version);
      }
    }
    ShownPanes::Layers shown = layers_of(choice, layers);
    for (auto& [layer, style] : shown) {
      layer = registry.layer_in(variant, version.has_value(), layer.layer);
      out.demand.push_back(layer);
    }
    out.panes.push_back(std::move(shown));
    out.variant.push_back(variant);
  }
  std::ranges::sort(out.demand);
  const auto [first, last] = std::ranges::unique(out.demand);
  out.demand.erase(first, last);
  return out;
}

}  // namespace mes
