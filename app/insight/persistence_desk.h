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
#include "app/system/background_job.h"
#include "core/graph/live_registry.h"

namespace mes {

class PersistenceDesk {
 public:
  PersistenceDesk(LiveRegistry registry, std::function<void()> wake)
      : registry_(std::move(registry)), job_(std::move(wake)) {}

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
  bool is_followed() const { return is_followed_; }
  /// Once a frame, after those who may follow: what nothing followed is given up.
  void end_frame() {
    if (!std::exchange(is_followed_, false)) job_.give_up();
  }

  /// The last one; null before the first.
  const PersistenceTable* table() const { return table_.get(); }
  std::shared_ptr<const PersistenceTable> shared_table() const { return table_; }
  bool is_current() const { return table_ != nullptr && state_ == wanted_; }
  bool is_under_way() const { return job_.is_under_way(); }
  /// Why the computation of the table failed; empty if it did not.
  const std::string& problem() const { return problem_; }

  /// Row of the table.
  std::optional<std::size_t> chosen() const { return chosen_; }
  void choose(std::optional<std::size_t> row) { chosen_ = row; }
  /// Chooses what `row_near` finds, or nothing. False while the table is not that of what is shown.
  bool pick(Vec2 place, double reach);

 private:
  struct Done {
    std::uint64_t document = 0;
    std::shared_ptr<const PersistenceTable> table;
    std::string problem;
  };
  void take(Done done);

  LiveRegistry registry_;
  BackgroundJob<Done> job_;
  GrowthOf growth_ = GrowthOf::samples;
  bool is_followed_ = false;
  std::uint64_t wanted_ = 0;
  std::uint64_t state_ = 0;
  std::optional<std::uint64_t> failed_;
  std::shared_ptr<const PersistenceTable> table_;
  std::string problem_;
  std::optional<std::size_t> chosen_;
};

}  // namespace mes
