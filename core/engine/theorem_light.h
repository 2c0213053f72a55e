// SPDX-License-Identifier: GPL-3.0-or-later
// The theorem light says whether the one-step axis may be called the medial axis.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "core/draw/patch.h"
#include "core/engine/memory_lack.h"

namespace mes {

enum class TheoremLight : std::uint8_t {
  none,    ///< the union has no inside, or the judges are not up to date
  green,   ///< the one-step axis is the medial axis of the union of the inner balls: proved for this input
  yellow,  ///< exact, but the assumptions of the theorem do not hold everywhere
  red,     ///< the chosen number type gave a wrong or inconsistent result
};

constexpr std::string_view name_of(TheoremLight light) {
  switch (light) {
    case TheoremLight::green: return "green";
    case TheoremLight::yellow: return "yellow";
    case TheoremLight::red: return "red";
    case TheoremLight::none: break;
  }
  return "none";
}

/// The sentence about samples with this light, used everywhere; no full stop.
constexpr std::string_view sentence_of(TheoremLight light) {
  switch (light) {
    case TheoremLight::green: return "the theorem is proved for these samples";
    case TheoremLight::yellow: return "the theorem is not proved for these samples";
    case TheoremLight::red: return "the number type gave a wrong result";
    case TheoremLight::none: break;
  }
  return "there is nothing to prove";
}

/// The lowest light level that a finding of this level allows.
constexpr TheoremLight light_of(FindingLevel level) {
  switch (level) {
    case FindingLevel::doubt: return TheoremLight::yellow;
    case FindingLevel::wrong: return TheoremLight::red;
    case FindingLevel::note: break;
  }
  return TheoremLight::none;
}

/// Light from the reports of a run with findings. Lack of memory and refused sizes say nothing about the result, and
/// where no structure judges there is nothing to doubt.
inline TheoremLight light_of(std::span<const NodeReport> nodes) {
  TheoremLight light = TheoremLight::none;
  for (const NodeReport& node : nodes) {
    if (node.state == NodeState::failed && node.reason != kOutOfMemory && !node.is_refused) light = TheoremLight::red;
    if (node.state == NodeState::up_to_date && node.is_judging) light = std::max(light, TheoremLight::green);
  }
  const bool is_judged = light != TheoremLight::none;
  for (const NodeReport& node : nodes)
    for (const Finding& finding : node.findings)
      if (is_judged || finding.level == FindingLevel::wrong) light = std::max(light, light_of(finding.level));
  return light;
}

}  // namespace mes
