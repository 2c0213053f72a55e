// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/curve_sampler.h"

#include <fmt/core.h>
#include <numbers>
#include <vector>

#include "core/base/job_control.h"

namespace mes {
namespace {

constexpr const char* kStep = "Take samples of curves";

}  // namespace

void CurveSampler::want(const SamplingRequest& request) {
  if (!source() || request == this->request()) return;
  wanted_ = request;
  if (!job_.is_under_way()) begin();
}

void CurveSampler::begin() {
  begun_ = std::exchange(wanted_, std::nullopt);
  begun_of_ = source()->curves;
  kept_.reset();
  job_.begin([curves = begun_of_, request = *begun_](const std::stop_token& stop) -> std::shared_ptr<const Taken> {
    JobControl job(stop);
    try {
      return std::make_shared<const Taken>(take_samples(curves, request, job));
    } catch (const GeometryError& problem) {
      return std::make_shared<const Taken>(std::unexpected(Error{ErrorCode::cannot_compute, problem.what()}));
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
  const Document& document = editor_.document();
  if (!found || document.revision() != curves_wished_at_) return {};
  const auto count = document.next_id().value - document.first_id().value;
  TimelineEdit edit{.name = "Take curves through samples"};
  edit.source =
      SourceEdit{.curves = *std::move(found), .sampling = {.count = kUsualSamples}, .first = 0, .count = count};
  remark_.clear();
  return editor_.perform(edit);
}

Expected<void> CurveSampler::follow(bool is_held) try {
  if (!is_held) {
    if (!was_held_ && !job_.is_under_way()) continues_ = false;
    was_held_ = false;
  } else if (!was_held_) {
    was_held_ = true;
    continues_ = false;
  }
  if (editor_.in_gesture()) return {};
  if (auto done = take_curves(); !done) return done;
  if (begun_ && (!source() || source()->curves != begun_of_)) {
    job_.give_up();
    begun_.reset();
    wanted_.reset();
    kept_.reset();
    return {};
  }
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
  return std::unexpected(Error{ErrorCode::cannot_compute, problem.what()});
}

Expected<void> CurveSampler::show(const Taken& taken) {
  const SamplingRequest request = *std::exchange(begun_, std::nullopt);
  if (!taken) {
    remark_.clear();
    return std::unexpected(taken.error());
  }
  const bool is_large = taken->data.positions.size() > kMostLive;
  if (is_large && wanted_) return {};
  auto done = editor_.resample(taken->data, kStep, continues_);
  if (!done) return done;
  continues_ = true;
  remark_ = remark_of(*taken, request);
  remark_at_ = editor_.document().revision();
  return {};
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
    annotations.push_back({.kind = AnnotationKind::leader,
                           .text = fmt::format("{:.0f}\u00b0", kDegrees * corner.angle),
                           .anchors = {{.at = corner.place}},
                           .shift = kShift});
  }
  return editor_.annotate(std::move(annotations), "Mark corners");
}

}  // namespace mes
