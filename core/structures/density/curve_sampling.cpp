// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/curve_sampling.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/structures/density/feature_size.h"
#include "core/structures/density/sample_sizes.h"

namespace mes {
namespace {

/// Curves that need more positions than this are not measured in passing.
constexpr std::size_t kMostPlacesOfCurves = 100'000;

void add_place(Finding& finding, Vec2 place) {
  ++finding.count;
  if (finding.places.size() < kMostPlaces) finding.places.push_back(place);
}

}  // namespace

std::vector<Finding> findings_of(const CurveStanding& standing, std::span<const SampleSlot> slots,
                                 const Delaunay& delaunay, const OneStepCrust& crust) {
  std::vector<Finding> out;
  if (standing.off_curve != 0) {
    Finding& note = out.emplace_back();
    note.level = FindingLevel::note;
    note.text = "samples off the curves that they were taken from: how well they stand for these is not said";
    note.count = static_cast<std::int64_t>(standing.off_curve);
    return out;
  }
  if (standing.epsilon > 0.0) {
    Finding& note = out.emplace_back();
    note.level = FindingLevel::note;
    note.epsilon = {.value = standing.epsilon, .corners = standing.exempt};
    note.text = fmt::format(
        "interval of the curves that has the fewest samples for its feature size: {}, by the curves' own axis; up to "
        "{} smooth curves have the axis that the theorem promises",
        note.epsilon->text(), kDenseEpsilon);
    add_place(note, standing.place);
  }
  if (!standing.sparse.empty()) {
    Finding& doubt = out.emplace_back();
    doubt.text = "intervals of the curves with too few samples to stand for them, epsilon above 1";
    for (const Vec2 place : standing.sparse) add_place(doubt, place);
  }
  Finding unjoined;
  unjoined.text = "pairs of neighbours along the curves that the crust does not join";
  for (const auto& [a, b] : standing.neighbours) {
    const SiteSlot from = delaunay.site_of_sample(slots[a]);
    const SiteSlot to = delaunay.site_of_sample(slots[b]);
    bool is_joined = from == to;
    if (!is_joined)
      delaunay.for_each_edge_at(from, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
        is_joined = is_joined || (other == to && crust.is_crust(edge));
      });
    if (!is_joined) add_place(unjoined, 0.5 * (delaunay.site_position(from) + delaunay.site_position(to)));
  }
  if (unjoined.count != 0) out.push_back(std::move(unjoined));
  return out;
}

CurveSampling::CurveSampling(CurveSourceInput& source, Samples& samples, Delaunay& delaunay, OneStepCrust& crust)
    : Structure("curve-sampling", {&source, &samples, &delaunay, &crust}),
      source_(source),
      samples_(samples),
      delaunay_(delaunay),
      crust_(crust) {}

void CurveSampling::measure(JobControl& job) {
  const std::shared_ptr<const CurveSource>& source = source_.current();
  if (!source) {
    curves_.reset();
    field_.reset();
    no_field_.clear();
    return;
  }
  SamplingRequest request = source->sampling;
  if (request.count == 0) request.count = kUsualSamples;
  // These settings say where samples lie, not what the curves are.
  request.rule = SamplingRule::feature_size;
  request.epsilon = kDenseEpsilon;
  request.jitter = request.spacing = 0.0;
  if (curves_ == source->curves && request_ == request) return;
  curves_.reset();
  field_.reset();
  no_field_.clear();
  SampleSizes sizes(job);
  auto field = FeatureField::of(
      *source->curves, request, [&sizes](std::span<const Vec2> positions) { return sizes.of(positions); }, &job,
      kMostPlacesOfCurves);
  if (field)
    field_ = *std::move(field);
  else
    no_field_ = field.error().text;
  curves_ = source->curves;
  request_ = request;
}

void CurveSampling::judge(JobControl& job) {
  standing_.reset();
  findings_.clear();
  is_changed_ = true;
  if (!field_) return;
  if (off_ != 0) {
    findings_ = findings_of({.off_curve = off_}, {}, delaunay_, crust_);
    Finding& note = findings_.front();
    for (const SampleSlot slot : is_off_.rows())
      if (is_off_[slot] != 0 && note.places.size() < kMostPlaces) note.places.push_back(samples_.position(slot));
    return;
  }
  std::vector<Vec2> positions;
  std::vector<SampleSlot> slots;
  for (std::size_t i = 0; i < samples_.row_count(); ++i)
    if (const SampleSlot slot(i); samples_.is_alive(slot)) {
      positions.push_back(samples_.position(slot));
      slots.push_back(slot);
    }
  standing_ = field_->standing(positions, &job);
  findings_ = findings_of(*standing_, slots, delaunay_, crust_);
}

void CurveSampling::rebuild(JobControl& job) {
  measure(job);
  off_ = 0;
  is_off_.assign(field_ ? samples_.row_count() : 0, 0);
  for (const SampleSlot slot : is_off_.rows()) {
    constexpr std::size_t kOften = 4096;
    if (slot.index() % kOften == 0) job.checkpoint();
    if (!samples_.is_alive(slot) || field_->is_on_curves(samples_.position(slot))) continue;
    is_off_[slot] = 1;
    ++off_;
  }
  judge(job);
}

bool CurveSampling::update(JobControl& job) {
  if (source_.touched() != 0) return false;
  if (!field_) return true;
  const auto& changes = samples_.changes();
  if (changes.size() == 0) return true;
  is_off_.resize(samples_.row_count(), 0);
  for (const auto* slots : {&changes.removed, &changes.touched})
    for (const SampleSlot slot : *slots) {
      off_ -= is_off_[slot];
      is_off_[slot] = samples_.is_alive(slot) && !field_->is_on_curves(samples_.position(slot)) ? 1 : 0;
      off_ += is_off_[slot];
    }
  judge(job);
  return true;
}

StatList CurveSampling::statistics() const {
  StatList out;
  if (!source_.current()) {
    out.push_back({"nothing_because", std::string("the samples were not taken from curves")});
  } else if (!field_) {
    out.push_back({"nothing_because", no_field_});
  } else if (!standing_) {
    out.push_back({"off_curve", static_cast<std::int64_t>(off_)});
    out.push_back({"nothing_because", std::string("some samples lie off the curves that they were taken from")});
  } else {
    out.push_back({"epsilon", standing_->epsilon});
    out.push_back({"exempt", static_cast<std::int64_t>(standing_->exempt)});
    out.push_back({"sparse_intervals", static_cast<std::int64_t>(standing_->sparse.size())});
  }
  return out;
}

void CurveSampling::find(std::vector<Finding>& out) const {
  out.insert(out.end(), findings_.begin(), findings_.end());
}

}  // namespace mes
