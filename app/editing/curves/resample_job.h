// SPDX-License-Identifier: GPL-3.0-or-later
// Repairs or decimates the sampling of the document beside the window.
//
// Guarantees:
//  1. Nothing waits: a separate thread finds the change, which is then made as one step of undo.
//  2. If the samples are edited meanwhile, they are left as they are, and the report says so.
//
// Smallest use, once a turn:
//     if (auto report = job.follow()) say(report->sentences);
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

class ResampleJob {
 public:
  ResampleJob(LiveRegistry registry, Editor& editor, Waker wake)
      : registry_(std::move(registry)), editor_(editor), job_(std::move(wake)) {}

  enum class Wish : std::uint8_t { repair, decimate };
  void begin(Wish wish);
  bool is_under_way() const { return job_.is_under_way(); }
  /// Another document replaces this one.
  void forget() {
    job_.give_up();
    last_ = {};
  }

  /// A report on the change, and on the places where it failed.
  struct Report {
    bool is_problem = false;             ///< true if nothing was changed
    std::vector<std::string> sentences;  ///< without a full stop
    std::vector<SampledCorner> corners{};
    std::vector<Vec2> places{};  ///< places where samples are still too few, or where the curve ends
  };
  /// Takes a finished change and makes it; within a gesture it waits for the end.
  std::optional<Report> follow();
  /// The report on the last change; empty at first, and when the document has changed since.
  Report last() const { return editor_.document().revision() == reported_at_ ? last_ : Report(); }

  /// Target epsilon of the samples, above 0 and at most 1.
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
