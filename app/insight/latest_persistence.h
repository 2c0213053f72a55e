// SPDX-License-Identifier: GPL-3.0-or-later
// The persistence table of the displayed document, and the chosen pair.
//
// Guarantees:
//  1. No call waits: the table is computed from scratch on a thread of its own. It belongs to one state of the
//     document; `is_current` says whether that is the one requested last.
//  2. Nothing is computed in frames in which nothing calls `follow`.
//  3. A pair stays chosen if the next table has one of the same dimension, position and edge.
//
// Smallest use, once a frame:
//     latest.follow(digest_of(document, latest.growth(), settings), input);
//     if (latest.table() != nullptr) draw(*latest.table());
//     latest.end_frame();
//
// Cost: triangulation and filtration from scratch, beside the window. Threads: the window's; `wake` is called from
// the other.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/insight/persistence_table.h"
#include "app/system/latest.h"
#include "core/document/commands.h"
#include "core/graph/live_registry.h"

namespace mes {

class LatestPersistence {
 public:
  LatestPersistence(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), latest_(std::move(wake)) {}

  /// The disks or balls that grow. The panels choose them.
  GrowthOf growth() const { return growth_; }
  void choose_growth(GrowthOf of) { growth_ = of; }
  /// Takes a finished table, and begins a missing one, by `digest_of`. Calls `input` when a computation begins.
  void follow(std::uint64_t digest, const std::function<PersistenceInput()>& input);
  /// The same for a document.
  void follow(const Document& document, const ComputationSettings& settings) {
    follow(digest_of(document, growth_, settings), [&] {
      return PersistenceInput{data_of(document), growth_, settings};
    });
  }
  /// True if `follow` was called since the last `end_frame`.
  bool is_followed() const { return latest_.is_followed(); }
  /// Call it once per frame after all possible calls of `follow`: if there was none, the computation is given up.
  void end_frame() { latest_.end_frame(); }

  /// The last table; null before the first.
  const PersistenceTable* table() const { return latest_.result().get(); }
  std::shared_ptr<const PersistenceTable> shared_table() const { return latest_.result(); }
  bool is_current() const { return latest_.is_current(); }
  /// The reason why the state followed last has no table; empty if it has one or is being computed.
  std::string problem() const { return latest_.problem(); }

  /// Chosen row of the table.
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> row) { chosen_ = row; }
  /// Chooses what `row_near` finds, or nothing. Returns false if the table does not match the displayed document.
  bool pick(Vec2 place, double reach);

 private:
  LiveRegistry registry_;
  Latest<std::uint64_t, PersistenceTable> latest_;
  GrowthOf growth_ = GrowthOf::samples;
  std::optional<std::size_t> chosen_;
};

}  // namespace mes
