// SPDX-License-Identifier: GPL-3.0-or-later
// Births and deaths of what is shown, and the class that is chosen.
//
// What it guarantees:
//  1. Nothing waits: the table is computed afresh on a thread of its own. It is of one state of the document;
//     `is_current` says whether that is the one asked for last.
//  2. In frames in which nothing follows it, nothing is computed.
//  3. A class stays chosen in the next table if one there has the same dimension, place and edge.
//
// Smallest use, once a frame:
//     desk.follow(digest_of(document, desk.growth(), settings), input);
//     if (desk.table() != nullptr) draw(*desk.table());
//     desk.end_frame();
//
// Cost: of the triangulation and its filtration from scratch, beside the window. Threads: the window's; `wake` is called
// from the other.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/insight/persistence_table.h"
#include "app/system/latest.h"
#include "core/graph/live_registry.h"

namespace mes {

class PersistenceDesk {
 public:
  PersistenceDesk(LiveRegistry registry, Waker wake) : registry_(std::move(registry)), latest_(std::move(wake)) {}

  /// What grows. The panels choose it.
  GrowthOf growth() const { return growth_; }
  void choose_growth(GrowthOf of) { growth_ = of; }
  /// Takes what is ready, and begins what is missing, by `digest_of`. `input` is called when a computation begins.
  void follow(std::uint64_t digest, const std::function<PersistenceInput()>& input);
  /// Those of a document.
  void follow(const Document& document, const ComputationSettings& settings) {
    follow(digest_of(document, growth_, settings), [&] {
      return PersistenceInput{data_of(document), growth_, settings};
    });
  }
  /// Since the last `end_frame`.
  bool is_followed() const { return latest_.is_followed(); }
  /// Once a frame, after those who may follow: what nothing followed is given up.
  void end_frame() { latest_.end_frame(); }

  /// The last one; null before the first.
  const PersistenceTable* table() const { return latest_.result().get(); }
  std::shared_ptr<const PersistenceTable> shared_table() const { return latest_.result(); }
  bool is_current() const { return latest_.is_current(); }
  /// Why there is no table of the state followed last; empty: there is one, or it is being computed.
  std::string problem() const { return latest_.problem(); }

  /// Row of the table.
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> row) { chosen_ = row; }
  /// Chooses what `row_near` finds, or nothing. False while the table is not that of what is shown.
  bool pick(Vec2 place, double reach);

 private:
  LiveRegistry registry_;
  Latest<std::uint64_t, PersistenceTable> latest_;
  GrowthOf growth_ = GrowthOf::samples;
  std::optional<std::size_t> chosen_;
};

}  // namespace mes
