// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/curve_sampler.h"

#include <fmt/core.h>
#include <algorithm>
#include <new>
#include <numbers>
#include <vector>

#include "core/base/jobs/job_control.h"

namespace mes {
namespace {

constexpr const char* kStep = "Take samples of curves";
constexpr const char* kNoMemory = "there is not enough memory to take samples";

}  // namespace

void CurveSampler::want(const SamplingRequest& request) {
  if (!source() || request == this->request()) return;
  if (!is_held_) ++hold_;
  is_wish_new_ = true;
  wanted_ = request;
  if (!job_.is_under_way()) begin();
}

void CurveSampler::begin() {
  begun_ = std::exchange(wanted_, std::nullopt);
  begun_of_ = editor_.document().source();
  begun_hold_ = hold_;
  kept_.reset();
  job_.begin([curves = begun_of_->curves, request = *begun_](const std::stop_token& stop) {
    JobControl job(stop);
    const auto refused = [](ErrorCode code, std::string text) {
      return std::make_shared<const Taken>(std::unexpected(Error{code, std::move(text)}));
    };
    try {
      return std::make_shared<const Taken>(take_samples(curves, request, job));
    } catch (const GeometryError& problem) {
      return refused(ErrorCode::cannot_compute, problem.what());
    } catch (const std::bad_alloc&) {
      return refused(ErrorCode::out_of_memory, kNoMemory);
    }
  });
}

void CurveSampler::want_curves_of_samples() {
  const Document& document = editor_.document();
  if (document.sample_count() < 2) return;
  std::vector<Vec2> positions;
  positions.reserve(document.sample_count());
  for (const SampleSlot slot : document.slots_in_input_order()) positions.push_back(document.position(slot));
  curves_wished_at_ = document.revision();
  curves_job_.begin([positions = std::move(positions)](const std::stop_token& stop) {
    JobControl job(stop);
    return std::make_shared<const CurveSet>(curves_through(positions, job));
  });
}

Expected<void> CurveSampler::take_curves() {
  auto found = curves_job_.poll();
  if (!found) return {};
  const Document& document = editor_.document();
  if (document.revision() != curves_wished_at_) {
    notice_ = "The samples were edited meanwhile, so no curves were laid through them";
    return {};
  }
  const auto count = document.next_id().value - document.first_id().value;
  const std::size_t curves = (*found)->curves.size();
  TimelineEdit edit{.name = "Take curves through samples"};
  edit.source =
      SourceEdit{.curves = *std::move(found), .sampling = {.count = kUsualSamples}, .first = 0, .count = count};
  remark_.clear();
  auto done = editor_.perform(edit);
  if (done)
    notice_ = fmt::format("{} {} laid through the samples; others can be taken on the page Curves", curves,
                          curves == 1 ? "curve was" : "curves were");
  return done;
}

void CurveSampler::drop() {
  job_.give_up();
  begun_.reset();
  wanted_.reset();
  kept_.reset();
}

Expected<void> CurveSampler::follow(bool is_held) try {
  // A request that came with the press belongs to it.
  if (is_held && !is_held_ && !is_wish_new_) ++hold_;
  is_held_ = is_held;
  is_wish_new_ = false;
  if (editor_.in_gesture()) return {};
  if (auto done = take_curves(); !done) return done;
  if (begun_ && editor_.document().source() != begun_of_) drop();
  if (!begun_) return {};
  if (kept_ && !is_held) return show(*std::exchange(kept_, nullptr));
  auto taken = job_.poll();
  if (!taken) return {};
  const bool is_last = !wanted_;
  if (is_held && is_last && **taken && (**taken)->data.positions.size() > kMostLive) {
    kept_ = *std::move(taken);
    return {};
  }
  auto done = show(**taken);
  if (!is_last && source()) begin();
  return done;
} catch (const GeometryError& problem) {
  drop();
  return std::unexpected(Error{ErrorCode::cannot_compute, problem.what()});
} catch (const std::bad_alloc&) {
  drop();
  return std::unexpected(Error{ErrorCode::out_of_memory, kNoMemory});
}

Expected<void> CurveSampler::show(const Taken& taken) {
  const SamplingRequest request = *std::exchange(begun_, std::nullopt);
  if (!taken) {
    remark_.clear();
    return std::unexpected(taken.error());
  }
  const bool is_large = taken->data.positions.size() > kMostLive;
  if (is_large && wanted_) return {};
  const bool was_edited = begun_hold_ != shown_hold_ && has_edited_samples();
  auto done = editor_.resample(taken->data, kStep, begun_hold_ == shown_hold_);
  if (!done) return done;
  shown_hold_ = begun_hold_;
  taken_source_ = editor_.document().source();
  taken_positions_ = positions_on_curves();
  if (was_edited)
    notice_ = "Samples were taken again, and your edits of samples of the curves are gone (Undo brings them back)";
  remark_ = remark_of(*taken, request);
  remark_at_ = editor_.document().revision();
  return {};
}

std::vector<Vec2> CurveSampler::positions_on_curves() const {
  const Document& document = editor_.document();
  std::vector<Vec2> out;
  for (const SampleId id : document.samples_of_source()) out.push_back(document.position(document.slot_of(id)));
  return out;
}

bool CurveSampler::has_edited_samples() const {
  const Document& document = editor_.document();
  if (!source() || document.samples_of_source().size() != source()->count) return source() != nullptr;
  return document.source() == taken_source_ && positions_on_curves() != taken_positions_;
}

std::string CurveSampler::samples_text() {
  const Document& document = editor_.document();
  if (std::exchange(counted_at_, document.revision()) != document.revision())
    sample_count_ = document.samples_of_source().size();
  const std::size_t all = document.sample_count();
  const char* const noun = all == 1 ? "sample" : "samples";
  if (sample_count_ == all) return fmt::format("{} {}", all, noun);
  return fmt::format("{} of {} {} {} of the curves", sample_count_, all, noun, sample_count_ == 1 ? "is" : "are");
}

std::string CurveSampler::remark() const {
  return remark_at_ == editor_.document().revision() ? remark_ : std::string();
}

const std::vector<CurveCorner>& CurveSampler::corners() {
  if (!source()) {
    corners_.clear();
    corners_of_.reset();
  } else if (corners_of_ != source()->curves || corner_angle_ != source()->sampling.corner_angle) {
    corners_of_ = source()->curves;
    corner_angle_ = source()->sampling.corner_angle;
    corners_ = corners_of(*corners_of_, corner_angle_);
  }
  return corners_;
}

Expected<void> CurveSampler::mark_corners() {
  constexpr Vec2 kShift{14.0, -14.0};  // logical pixels
  Annotations annotations = *editor_.document().annotations();
  for (const CurveCorner& corner : corners()) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const std::vector<Anchor> anchors{{.at = corner.place}};
    if (std::ranges::find(annotations, anchors, &Annotation::anchors) != annotations.end()) continue;
    annotations.push_back({.kind = AnnotationKind::leader,
                           .text = fmt::format("{:.0f}\u00b0", kDegrees * corner.angle),
                           .anchors = anchors,
                           .shift = kShift});
  }
  return editor_.annotate(std::move(annotations), "Mark corners");
}

}  // namespace mes
