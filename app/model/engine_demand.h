// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers the engine is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "app/layers/layer_stack.h"
#include "app/model/pane_documents.h"
#include "app/model/pane_list.h"
#include "core/engine/engine.h"

namespace mes {

/// What it guarantees: the engine is asked for the visible layers of all panes, and for what panels look at, anew when
/// they change. After a picture was lost for lack of memory it is asked for none, and for all of them again once the
/// document or the demand has changed. Where all layers are needed once more as a whole, it is asked for none, and for all
/// of them as soon as it has nothing to do. Threads: the window's.
class EngineDemand {
 public:
  /// What is wanted, with the revisions that say when it changes.
  struct Wanted {
    const Registry& registry;
    const LayerStack& layers;
    const PaneList& panes;
    const ComputationSettings& settings;
    std::uint64_t document_revision = 0;
    PaneEvolution evolution{};
    bool is_held = false;  ///< the engine does not know the present document yet; panes show no later version either
    bool with_density = false;  ///< how dense the samples are is looked at, though no layer may show it
  };
  /// Once a frame. True when the engine was asked for other layers. What is new in the documents of panes goes to it too.
  bool follow(Engine& engine, const Wanted& wanted, bool picture_is_lost, PaneDocuments* documents = nullptr);
  /// All layers are to be sent whole once more.
  void ask_again() { asks_again_ = true; }
  /// The engine has been asked for what is visible now.
  bool is_told(const Wanted& wanted) const { return !asks_again_ && seen_ == asked_of(wanted); }
  /// What the panes beside the main one show, as the engine was asked last and styles are now.
  const ShownPanes& shown() const { return shown_; }

 private:
  /// What the demand depends on. Settings and evolution only count while there are panes.
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
  std::uint64_t styled_ = 0;  // revision of the layers whose styles are shown
  bool asks_for_nothing_ = false;
  bool asks_again_ = false;
  State lost_at_{};  // revisions of demand and document
};

}  // namespace mes
