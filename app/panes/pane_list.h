// SPDX-License-Identifier: GPL-3.0-or-later
// Panes beside the main one. Each shows the document in another way: with another number type or value of a
// parameter, the union of other balls, a bundle, a state of an evolution, or as it was before the last edit.
//
// All panes show one view, the same part of the plane at the same scale, unless they have cameras of their own
// (pane_views.h). The one engine computes their contents as variants (core/draw/variant.h), so that an edit appears
// in all at once, and shared results are computed once.
//
// Smallest use:
//     PaneList panes;
//     panes.add(Precision::exact);
//     const ShownPanes shown = shown_panes(registry, panes, layers, settings);
//     engine.post({.deltas = {}, .settings = settings, .demand = shown.demand, .beside = {shown.variants}});
//
// Cost: O(layers) per pane. Threads: none.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/layers/ball_families.h"
#include "app/layers/layer_stack.h"
#include "core/document/settings/computation_settings.h"
#include "core/document/settings/pane_choice.h"
#include "core/draw/variant.h"
#include "core/engine/variant_request.h"
#include "core/evolutions/evolution.h"

namespace mes {

class Registry;

/// The name in the window: "Exact", "Inner balls: scale 1.1", "Polar balls", the name of the bundle, "Step 10",
/// "Before the last edit".
std::string words_of(const PaneChoice& choice);

/// The list of panes; `revision` grows with each change.
class PaneList {
 public:
  static constexpr std::size_t kMost = kMostPanesBeside;

  bool is_empty() const { return panes_.empty(); }
  bool is_full() const { return panes_.size() == kMost; }
  std::span<const PaneChoice> panes() const { return panes_; }
  std::uint64_t revision() const { return revision_; }
  /// For each pane a permanent number that no other pane has had.
  std::span<const std::uint64_t> keys() const { return keys_; }
  /// True if each pane has its own view.
  bool has_free_cameras() const { return has_free_cameras_; }
  void set_free_cameras(bool are_free);
  /// Replaces parameters by those of the registry, with values clamped to their range. Unknown parameters are kept.
  void resolve(const Registry& registry);

  /// Does nothing if the list is full.
  void add(PaneChoice choice);
  void change(std::size_t pane, PaneChoice choice);
  void close(std::size_t pane);
  void close_all();
  /// Replaces the list; panes beyond `kMost` are left out.
  void set(std::vector<PaneChoice> panes);

 private:
  std::vector<PaneChoice> panes_;
  std::vector<std::uint64_t> keys_;  // one per pane
  std::uint64_t next_key_ = 0;
  bool has_free_cameras_ = false;
  std::uint64_t revision_ = 0;
};

/// The properties of the main pane in which the others can differ.
struct MainPane {
  const ComputationSettings& settings;
  FamilyKind family{};
  std::string bundle{};    ///< the bundle that is shown unchanged; empty: none
  std::uint64_t step = 0;  ///< step of the evolution that the document shows
};
/// A description of each pane, the main one first; that names the property in which the first pane of the list
/// differs.
std::vector<std::string> words_of(const PaneList& list, const MainPane& main);

/// A choice that is not in the list yet: a number type that is not in use.
PaneChoice next_choice(const PaneList& list, const ComputationSettings& settings);

/// The evolution of the window.
struct PaneEvolution {
  EvolutionChoice choice{};
  double first = 0.0;  ///< value in state 0 of the parameter that it moves, if any
  friend bool operator==(const PaneEvolution&, const PaneEvolution&) = default;
};

/// The layers and variants that the list requires.
struct ShownPanes {
  using Layers = std::vector<std::pair<VariantLayer, LayerStyle>>;  ///< bottom first
  std::vector<VariantRequest> variants;
  std::vector<std::optional<VersionChoice>> versions;  ///< for variants that have documents of their own
  std::vector<Layers> panes;                           ///< for the panes beside the main one
  std::vector<VariantIndex> variant;                   ///< one per pane in `panes`
  std::vector<VariantLayer> demand;                    ///< for all panes, including the main one
};
/// The visible layers of the main pane.
ShownPanes::Layers visible_layers(const LayerStack& layers);
/// The layers are those of the registry. If a state would move a parameter out of its range, its pane equals the main
/// one.
ShownPanes shown_panes(const Registry& registry, const PaneList& list, const LayerStack& layers,
                       const ComputationSettings& settings, const PaneEvolution& evolution = {});

}  // namespace mes
