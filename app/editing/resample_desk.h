// SPDX-License-Identifier: GPL-3.0-or-later
// The sampling of the document, repaired or decimated beside the window.
//
// What it guarantees:
//  1. Nothing waits: what is to be done is found on a thread of its own, and then done as one step of undo.
//  2. Samples that were edited meanwhile are left as they are, and that is said.
//
// Smallest use, once a turn:
//     if (auto report = desk.follow()) say(report->sentences);
//
// Threads: the window's; `wake` is called from the other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "app/system/background_job.h"
#include "core/graph/live_registry.h"
#include "core/resampling/decimate.h"
#include "core/resampling/repair.h"

namespace mes {

class ResampleDesk {
 public:
  ResampleDesk(LiveRegistry registry, Editor& editor, Waker wake)
      : registry_(std::move(registry)), editor_(editor), job_(std::move(wake)) {}

  enum class Wish : std::uint8_t { repair, decimate };
  void begin(Wish wish);
  bool is_under_way() const { return job_.is_under_way(); }
  /// Another document takes the place of this one.
  void forget() {
    job_.give_up();
    last_ = {};
  }

  /// What was done, and what could not be.
  struct Report {
    bool is_problem = false;             ///< nothing was done
    std::vector<std::string> sentences;  ///< without a full stop
    std::vector<SampledCorner> corners{};
    std::vector<Vec2> places{};  ///< where the samples are still too few, or the curve ends
  };
  /// Takes what was found, and does it; within a gesture it waits for its end.
  std::optional<Report> follow();
  /// Of the last that was done; empty at first, and when the document has changed since.
  Report last() const { return editor_.document().revision() == reported_at_ ? last_ : Report(); }

  /// What samples are to be, above 0 and at most 1.
  double epsilon = 0.25;

 private:
  struct Found {
    Wish wish = Wish::repair;
    std::optional<Repair> repaired;
    std::optional<Decimation> decimated;
    std::string problem;
  };
  Expected<void> apply(const Repair& repaired);
  Expected<void> apply(const Decimation& decimated);
  Report report_of(const Found& found);

  LiveRegistry registry_;
  Editor& editor_;
  BackgroundJob<Found> job_;
  std::uint64_t begun_at_ = 0;  // revision of the document
  Report last_;
  std::uint64_t reported_at_ = ~std::uint64_t{0};
};

}  // namespace mes
