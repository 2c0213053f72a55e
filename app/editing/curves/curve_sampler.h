// SPDX-License-Identifier: GPL-3.0-or-later
// The curves from which the document's samples were taken, and the taking of new samples.
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

/// Guarantees:
///  1. A separate thread takes the samples; nothing waits. Of several requests the last counts, but each one that was
///     begun is shown, so that the drawing follows a dragged slider.
///  2. All requests made while a control is held are one step of undo. Samples set by hand stay; those taken from the
///     curves before are removed, moved or not.
///  3. While a control is held, more than `kMostLive` samples are shown only after its release.
///     A notice tells of samples that were edited by hand since they were taken, and are gone.
///  4. Another document, other curves in it, and undo or redo of a sampling cancel the work under way.
///
/// Smallest use:
///     sampler.want(request);
///     ... once a turn: sampler.follow(a_control_is_held);
///
/// Threads: the window's; `wake` is called from the other.
class CurveSampler {
 public:
  static constexpr std::size_t kMostLive = 20'000;

  CurveSampler(Editor& editor, Waker wake) : editor_(editor), job_(wake), curves_job_(std::move(wake)) {}

  /// Null if the samples were not taken from curves.
  const CurveSource* source() const { return editor_.document().source().get(); }
  /// The present or pending sampling; there must be curves.
  const SamplingRequest& request() const { return wanted_ ? *wanted_ : begun_ ? *begun_ : source()->sampling; }
  void want(const SamplingRequest& request);
  /// Requests smooth curves along the one-step crust, with the present samples as vertices. They become the source of
  /// the samples, which do not move.
  void want_curves_of_samples();

  bool is_busy() const { return job_.is_under_way() || curves_job_.is_under_way(); }
  /// Shows finished samples. Error: they cannot be taken, perhaps for lack of memory; the document stays as it was.
  Expected<void> follow(bool is_held);
  /// A message about an effect that may be invisible, given once.
  std::optional<std::string> take_notice() { return std::exchange(notice_, std::nullopt); }

  /// A remark on the samples; empty if there is none, or the document has changed since.
  std::string remark() const;
  /// "40 samples" while all were taken from the curves and are left; otherwise "30 of 37 samples are of the curves".
  std::string samples_text();
  /// The corners of the curves, found once per set of curves; empty if there are no curves.
  const std::vector<CurveCorner>& corners();
  /// Writes the angle beside each corner that has none yet, as one step of undo. Error: too many annotations.
  Expected<void> mark_corners();

 private:
  using Taken = Expected<TakenSamples>;
  void begin();
  void drop();
  Expected<void> show(const Taken& taken);
  Expected<void> take_curves();
  /// Whether samples of the curves were removed since they were taken, or also moved since this took them.
  bool has_edited_samples() const;
  std::vector<Vec2> positions_on_curves() const;

  Editor& editor_;
  BackgroundJob<std::shared_ptr<const Taken>> job_;
  BackgroundJob<std::shared_ptr<const CurveSet>> curves_job_;
  std::uint64_t curves_wished_at_ = 0;     // revision of the document
  std::optional<SamplingRequest> wanted_;  // not begun yet
  std::optional<SamplingRequest> begun_;
  std::shared_ptr<const CurveSource> begun_of_;
  std::shared_ptr<const Taken> kept_;  // shown after the release of the control
  // A number for each time that a control is held, and for each request without one: equal numbers are one step of
  // undo.
  std::uint64_t hold_ = 1;
  std::uint64_t begun_hold_ = 0;
  std::uint64_t shown_hold_ = 0;
  bool is_held_ = false;
  bool is_wish_new_ = false;  // true since the last `follow`
  std::optional<std::string> notice_;
  std::shared_ptr<const CurveSource> taken_source_;  // of the samples that were shown last
  std::vector<Vec2> taken_positions_;
  std::size_t sample_count_ = 0;
  std::uint64_t counted_at_ = ~std::uint64_t{0};  // revision of the document
  std::string remark_;
  std::uint64_t remark_at_ = ~std::uint64_t{0};  // revision of the document
  std::vector<CurveCorner> corners_;
  std::shared_ptr<const CurveSet> corners_of_;
  double corner_angle_ = 0.0;
};

}  // namespace mes
