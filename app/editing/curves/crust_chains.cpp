// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/curves/crust_chains.h"

#include "core/base/jobs/job_control.h"
#include "core/evolutions/moving_curve.h"

namespace mes {

const CrustChains::Curve* CrustChains::now() const {
  return curve_of_ == editor_.document().revision() ? curve_.get() : nullptr;
}

bool CrustChains::find() {
  const Document& document = editor_.document();
  if (job_.is_under_way() && wanted_of_ == document.revision()) return false;
  wanted_of_ = document.revision();
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  std::vector<Vec2> positions;
  positions.reserve(slots.size());
  for (const SampleSlot slot : slots) positions.push_back(document.position(slot));
  job_.begin([slots, positions = std::move(positions)](const std::stop_token& stop) -> std::shared_ptr<const Curve> {
    JobControl job(stop);
    const MovingCurve found = crust_curve(positions, job);
    auto out = std::make_shared<Curve>();
    for (const MovingCurve::Chain& chain : found.chains) {
      Curve::Chain& rows = out->chains.emplace_back();
      rows.closed = chain.closed;
      for (const std::uint32_t place : chain.points) rows.samples.push_back(slots[place]);
    }
    for (const auto& [follower, other] : found.followers) out->followers.emplace_back(slots[follower], slots[other]);
    return out;
  });
  return true;
}

Expected<bool> CrustChains::follow() try {
  auto found = job_.poll();
  if (!found) return false;
  curve_ = *std::move(found);
  curve_of_ = wanted_of_;
  return true;
} catch (const GeometryError& problem) {
  return std::unexpected(Error{ErrorCode::cannot_compute, problem.what()});
}

}  // namespace mes
