// SPDX-License-Identifier: GPL-3.0-or-later
// The documents of panes that show another version than the main pane: a state of an evolution, or the document
// before the last edit.
//
// Guarantees:
//  1. Nothing waits: a separate thread computes states of an evolution, and a pane shows the state for an earlier
//     document until that for the present one is ready. While samples are dragged, states that are being computed are
//     finished and shown.
//  2. The engine gets only changes: if a version differs from the previous one in some samples and balls, only these.
//     The drawing is that of the version, whatever was shown before.
//
// Smallest use, once a frame:
//     documents.follow(shown.versions);
//     engine.post({..., .beside = {shown.variants, documents.take_deltas()}});
//
// Cost: O(n) per version that changes, beside the steps of the evolution. Threads: the window's; `wake` is called
// from others.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "app/panes/pane_list.h"
#include "app/playing/evolution_player.h"
#include "app/system/background_job.h"
#include "core/document/commands.h"
#include "core/engine/engine.h"
#include "core/evolutions/evolution_states.h"

namespace mes {

class PaneDocuments {
 public:
  /// Both arguments must outlive it.
  PaneDocuments(const Editor& editor, const EvolutionPlayer& evolution, Waker wake);

  /// Sets the versions that variants 1, 2, ... show, or none of their own. The engine replaces variants as `Graph`
  /// does. `is_held`: the engine does not know the present document yet, and the display waits for it.
  void follow(const std::vector<std::optional<VersionChoice>>& versions, bool is_held = false);
  /// The evolution was replaced by another one with its id: its states are computed again.
  void forget_states();
  /// The changes for the engine, given once.
  std::vector<VariantDelta> take_deltas() { return std::exchange(deltas_, {}); }
  /// True if all versions belong to the present document, or are impossible.
  bool is_complete() const;
  /// The reason why a version is impossible, given once.
  std::optional<Error> take_problem() { return std::exchange(problem_, std::nullopt); }

  /// The document of a variant as the engine has it, or as data with annotations; null: that of the main pane.
  const Document* document_of(VariantIndex variant) const;
  std::shared_ptr<const SampleData> data_of(VariantIndex variant) const;

 private:
  struct Version {
    std::vector<std::uint64_t> keys{};  ///< keys of the samples, increasing: equal in all versions of a document
    std::shared_ptr<const SampleData> data{};
  };
  struct Pane {
    VersionChoice choice;
    std::optional<std::uint64_t> origin{};  ///< source of the version; nothing: there is none yet
    Version version{};
    Document document{};
  };
  /// The data that determine the states of an evolution.
  struct Beginning {
    std::uint64_t revision = 0;  ///< revision of state 0
    std::uint64_t document = 0;  ///< revision of the document, which has the balls
    EvolutionChoice choice{};
    friend bool operator==(const Beginning&, const Beginning&) = default;
  };
  struct Found {
    Beginning beginning;
    Version document;  ///< as it was then
    std::shared_ptr<EvolutionStates> states;
    std::vector<std::uint64_t> steps;
    std::vector<EvolutionStates::Shared> found;  ///< states for these steps
    std::optional<Error> problem{};              ///< if set, there are fewer
  };
  void keep_kinds(const std::vector<std::optional<VersionChoice>>& versions);
  Beginning beginning() const;
  std::vector<std::uint64_t> steps_wanted() const;
  bool has_found(const Beginning& beginning, const std::vector<std::uint64_t>& steps) const {
    return found_ && found_->beginning == beginning && found_->steps == steps;
  }
  void follow_edit();
  void follow_evolution();
  void begin(const Beginning& beginning, std::vector<std::uint64_t> steps);
  void show_states();
  void take(Found found);
  void show(VariantIndex variant, Version version);
  bool change(Pane& pane, VariantIndex variant, const Version& to);
  bool post(Pane& pane, VariantIndex variant, const Expected<DocumentDelta>& delta);

  const Editor& editor_;
  const EvolutionPlayer& evolution_;
  std::vector<std::optional<Pane>> panes_;  // for variants 1, 2, ...
  std::vector<VariantDelta> deltas_;
  std::optional<Error> problem_;
  std::optional<Beginning> begun_;     // what is being computed
  std::vector<std::uint64_t> wanted_;  // its steps
  std::optional<Found> found_;         // last result
  std::uint64_t answers_ = 0;          // number of results so far
  BackgroundJob<Found> computing_;
};

}  // namespace mes
