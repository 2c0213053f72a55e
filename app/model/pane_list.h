// SPDX-License-Identifier: GPL-3.0-or-later
// Panes beside the main one, each of which shows the document otherwise: with another number type, another value of a
// parameter, the union of other balls, a bundle, in a state of an evolution, or as it was before the last edit.
//
// All panes show one view, the same part of the plane at the same scale, unless they have cameras of their own
// (pane_views.h). What they show is computed by the one engine
// as variants (core/draw/variant.h), so an edit shows in all at once, and what they share is computed once.
//
// Smallest use:
//     PaneList panes;
//     panes.add(Precision::exact);
//     const ShownPanes shown = shown_panes(registry, panes, layers, settings);
//     engine.post({.deltas = {}, .settings = settings, .demand = shown.demand, .beside = {shown.variants}});
//
// Cost: O(layers) a pane. Threads: none.
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
#include "core/document/computation_settings.h"
#include "core/document/pane_choice.h"
#include "core/draw/variant.h"
#include "core/engine/variant_request.h"
#include "core/evolutions/evolution.h"

namespace mes {

class Registry;

/// As in the window: "Exact", "Inner balls: scale 1.1", "Polar balls", the name of the bundle, "Step 10", "Before the
/// last edit".
std::string words_of(const PaneChoice& choice);

/// What grows with each change is `revision`.
class PaneList {
 public:
  static constexpr std::size_t kMost = kMostPanesBeside;

  bool is_empty() const { return panes_.empty(); }
  bool is_full() const { return panes_.size() == kMost; }
  std::span<const PaneChoice> panes() const { return panes_; }
  std::uint64_t revision() const { return revision_; }
  /// Of each pane a number that no other one had and that it keeps.
  std::span<const std::uint64_t> keys() const { return keys_; }
  /// Each pane has a view of its own.
  bool has_free_cameras() const { return has_free_cameras_; }
  void set_free_cameras(bool are_free);
  /// Parameters are those of the registry from now on, with values in their range. One that it lacks is kept.
  void resolve(const Registry& registry);

  /// Does nothing if the list is full.
  void add(PaneChoice choice);
  void change(std::size_t pane, PaneChoice choice);
  void close(std::size_t pane);
  void close_all();
  /// Shows these; those beyond `kMost` are left out.
  void set(std::vector<PaneChoice> panes);

 private:
  std::vector<PaneChoice> panes_;
  std::vector<std::uint64_t> keys_;  // of each
  std::uint64_t next_key_ = 0;
  bool has_free_cameras_ = false;
  std::uint64_t revision_ = 0;
};

/// What the main pane shows, as far as panes beside it can differ.
struct MainPane {
  const ComputationSettings& settings;
  FamilyKind family{};
  std::string bundle{};    ///< that is shown as it was saved; empty: none
  std::uint64_t step = 0;  ///< of the evolution, that the document is in
};
/// What each pane is about, the main one first: of that, what the first of the list has otherwise.
std::vector<std::string> words_of(const PaneList& list, const MainPane& main);

/// A choice that the list does not have yet: a number type that is not in use.
PaneChoice next_choice(const PaneList& list, const ComputationSettings& settings);

/// The evolution of the window.
struct PaneEvolution {
  EvolutionChoice choice{};
  double first = 0.0;  ///< in state 0, of the parameter that it moves, if it moves one
  friend bool operator==(const PaneEvolution&, const PaneEvolution&) = default;
};

/// The layers and variants that the list asks for.
struct ShownPanes {
  using Layers = std::vector<std::pair<VariantLayer, LayerStyle>>;  ///< bottom first
  std::vector<VariantRequest> variants;
  std::vector<std::optional<VersionChoice>> versions;  ///< of the variants that have documents of their own
  std::vector<Layers> panes;                           ///< beside the main one
  std::vector<VariantIndex> variant;                   ///< of each of these
  std::vector<VariantLayer> demand;                    ///< of all panes, the main one too
};
/// Those of the main pane.
ShownPanes::Layers visible_layers(const LayerStack& layers);
/// The layers are those of the registry. A state in which a parameter would leave its range is shown as the main pane is.
ShownPanes shown_panes(const Registry& registry, const PaneList& list, const LayerStack& layers,
                       const ComputationSettings& settings, const PaneEvolution& evolution = {});

}  // namespace mes
