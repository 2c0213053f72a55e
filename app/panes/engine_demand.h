// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which layers the engine is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "app/layers/layer_stack.h"
#include "app/panes/pane_documents.h"
#include "app/panes/pane_list.h"
#include "core/engine/engine.h"

namespace mes {

/// Guarantees: the engine is asked for the visible layers of all panes and for what panels need, and asked again
/// whenever either changes. After a picture was lost for lack of memory, the demand is empty until the document or
/// the demand has changed; then it is repeated. If all layers are needed again completely, the demand is empty first,
/// and repeated as soon as the engine is idle. Threads: the window's.
class EngineDemand {
 public:
  /// The demand, with the revisions that tell when it changes.
  struct Wanted {
    const Registry& registry;
    const LayerStack& layers;
    const PaneList& panes;
    const ComputationSettings& settings;
    std::uint64_t document_revision = 0;
    PaneEvolution evolution{};
    bool is_held = false;  ///< the engine does not know the present document yet; panes must not show later versions
    bool with_density = false;  ///< the density of the samples is used, even if no layer shows it
  };
  /// Call it once per frame. Returns true if the demand has changed. Changes in the documents of panes are posted,
  /// too.
  bool follow(Engine& engine, const Wanted& wanted, bool picture_is_lost, PaneDocuments* documents = nullptr);
  /// Requests all layers again completely.
  void ask_again() { asks_again_ = true; }
  /// True if the engine has been asked for what is visible now.
  bool is_told(const Wanted& wanted) const { return !asks_again_ && seen_ == asked_of(wanted); }
  /// The contents of the panes beside the main one: layers as last demanded, styles as they are now.
  const ShownPanes& shown() const { return shown_; }

 private:
  /// The state on which the demand depends. Settings and evolution matter only if there are panes.
  struct Asked {
    std::uint64_t layers = 0;
    std::uint64_t panes = 0;
    std::optional<ComputationSettings> settings;
    std::optional<PaneEvolution> evolution;
    bool with_density = false;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  using State = std::pair<std::uint64_t, std::uint64_t>;
  static Asked asked_of(const Wanted& wanted);
  bool waits_for_room(Engine& engine, const State& now);
  bool waits_to_ask_again(Engine& engine);

  Asked seen_;
  ShownPanes shown_;
  std::uint64_t styled_ = 0;  // revision of the layers for the styles shown
  bool asks_for_nothing_ = false;
  bool asks_again_ = false;
  State lost_at_{};  // revisions of demand and document at the loss
};

}  // namespace mes
