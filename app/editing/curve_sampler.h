// SPDX-License-Identifier: GPL-3.0-or-later
// The curves that the document's samples were taken from, and taking others.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/editing/editor.h"
#include "app/system/background_job.h"
#include "core/resampling/resampling.h"

namespace mes {

/// What it guarantees:
///  1. Samples are taken on a thread of its own; nothing waits. Of several wishes the last counts, but each that was
///     begun is shown, so that a slider that is dragged is followed.
///  2. What is wished for while a control is held is one step of undo. Samples that were set by hand stay; those that
///     were taken from the curves before go, moved or not.
///  3. While a control is held, more than `kMostLive` samples are shown only when it is left.
///  4. Another document, other curves in it, and undo or redo of a sampling drop what is under way.
///
/// Smallest use:
///     sampler.want(request);
///     ... once a turn: sampler.follow(a_control_is_held);
///
/// Threads: the window's; `wake` is called from the other.
class CurveSampler {
 public:
  static constexpr std::size_t kMostLive = 20'000;

  CurveSampler(Editor& editor, Waker wake)
      : editor_(editor), job_(wake), curves_job_(std::move(wake)) {}

  /// Null: the samples were not taken from curves.
  const CurveSource* source() const { return editor_.document().source().get(); }
  /// How they are or will be taken; there are curves.
  const SamplingRequest& request() const { return wanted_ ? *wanted_ : begun_ ? *begun_ : source()->sampling; }
  void want(const SamplingRequest& request);
  /// Curves through the samples that there are: the one-step crust as smooth curves, whose vertices they are. They become
  /// the source of the samples; nothing moves.
  void want_curves_of_samples();

  bool is_busy() const { return job_.is_under_way() || curves_job_.is_under_way(); }
  /// Shows what is ready. Error: what cannot be taken, also for lack of memory; it stays as it was.
  Expected<void> follow(bool is_held);
  /// What was done that may not be seen, once.
  std::optional<std::string> take_notice() { return std::exchange(notice_, std::nullopt); }

  /// What is known of the samples; empty: nothing, or the document has changed since.
  std::string remark() const;
  /// How many of the samples that were taken are left.
  std::size_t sample_count();
  /// Corners of the curves, found once for each; no curves: none.
  const std::vector<CurveCorner>& corners();
  /// Writes its angle beside each corner that has none yet: one step of undo. Error: more annotations than there may be.
  Expected<void> mark_corners();

 private:
  using Taken = Expected<TakenSamples>;
  void begin();
  void drop();
  Expected<void> show(const Taken& taken);
  Expected<void> take_curves();

  Editor& editor_;
  BackgroundJob<std::shared_ptr<const Taken>> job_;
  BackgroundJob<std::shared_ptr<const CurveSet>> curves_job_;
  std::uint64_t curves_wished_at_ = 0;     // revision of the document
  std::optional<SamplingRequest> wanted_;  // not begun yet
  std::optional<SamplingRequest> begun_;
  std::shared_ptr<const CurveSource> begun_of_;
  std::shared_ptr<const Taken> kept_;  // until the control is left
  // A number for each time that a control is held, and for each wish without one: what has the same number is one step.
  std::uint64_t hold_ = 1;
  std::uint64_t begun_hold_ = 0;
  std::uint64_t shown_hold_ = 0;
  bool is_held_ = false;
  bool is_wish_new_ = false;  // since the last `follow`
  std::optional<std::string> notice_;
  std::size_t sample_count_ = 0;
  std::uint64_t counted_at_ = ~std::uint64_t{0};  // revision of the document
  std::string remark_;
  std::uint64_t remark_at_ = ~std::uint64_t{0};  // revision of the document
  std::vector<CurveCorner> corners_;
  std::shared_ptr<const CurveSet> corners_of_;
  double corner_angle_ = 0.0;
};

}  // namespace mes
