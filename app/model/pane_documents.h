// SPDX-License-Identifier: GPL-3.0-or-later
// The documents of panes that show another version of the document than the main pane: a state of an evolution, or what
// there was before the last edit.
//
// What it guarantees:
//  1. Nothing waits: states of an evolution are computed on a thread of their own, and a pane shows that of an earlier
//     document until the one of the present document is there. While samples are dragged, states that are being
//     computed are finished and shown.
//  2. The engine is given what changes: where a version differs from the one before in some samples and balls, these
//     alone; what is drawn is that of the version, whatever was shown before.
//
// Smallest use, once a frame:
//     documents.follow(shown.versions);
//     engine.post({..., .beside = {shown.variants, documents.take_deltas()}});
//
// Cost: O(n) a version that changes, beside the steps of the evolution. Threads: the window's; `wake` is called from
// others.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "app/model/pane_list.h"
#include "app/playing/evolution_player.h"
#include "app/system/background_job.h"
#include "core/document/commands.h"
#include "core/engine/engine.h"
#include "core/evolutions/evolution_states.h"

namespace mes {

class PaneDocuments {
 public:
  /// Both outlive it.
  PaneDocuments(const Editor& editor, const EvolutionPlayer& evolution, Waker wake);

  /// Variants 1, 2, ... show these versions, or none of their own. The engine makes variants anew as `Graph` does.
  /// `is_held`: the engine does not know the present document yet, and what is shown waits for it.
  void follow(const std::vector<std::optional<VersionChoice>>& versions, bool is_held = false);
  /// The evolution was replaced by another one of its id: its states are computed again.
  void forget_states();
  /// What has changed, for the engine, once.
  std::vector<VariantDelta> take_deltas() { return std::exchange(deltas_, {}); }
  /// All versions are of the present document, or could not be had.
  bool is_complete() const;
  /// Why a version cannot be had, once.
  std::optional<Error> take_problem() { return std::exchange(problem_, std::nullopt); }

  /// What a variant shows, as the engine has it, and as data with its annotations; null: that of the main pane.
  const Document* document_of(VariantIndex variant) const;
  std::shared_ptr<const SampleData> data_of(VariantIndex variant) const;

 private:
  struct Version {
    std::vector<std::uint64_t> keys{};  ///< of the samples, increasing: in all versions of a document the same
    std::shared_ptr<const SampleData> data{};
  };
  struct Pane {
    VersionChoice choice;
    std::optional<std::uint64_t> origin{};  ///< what the version was made of; none: of nothing yet
    Version version{};
    Document document{};
  };
  /// What states of an evolution follow from.
  struct Beginning {
    std::uint64_t revision = 0;  ///< of state 0
    std::uint64_t document = 0;  ///< of the document, which has the balls
    EvolutionChoice choice{};
    friend bool operator==(const Beginning&, const Beginning&) = default;
  };
  struct Found {
    Beginning beginning;
    Version document;  ///< as it was then
    std::shared_ptr<EvolutionStates> states;
    std::vector<std::uint64_t> steps;
    std::vector<EvolutionStates::Shared> found;  ///< of these
    std::optional<Error> problem{};              ///< then there are fewer
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
  std::vector<std::optional<Pane>> panes_;  // of variants 1, 2, ...
  std::vector<VariantDelta> deltas_;
  std::optional<Error> problem_;
  std::optional<Beginning> begun_;     // of what is being computed
  std::vector<std::uint64_t> wanted_;  // its steps
  std::optional<Found> found_;         // what was computed last
  std::uint64_t answers_ = 0;          // how often something was
  BackgroundJob<Found> computing_;
};

}  // namespace mes
