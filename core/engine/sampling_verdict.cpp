// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/sampling_verdict.h"

namespace mes {

std::string SamplingVerdict::text() const {
  const std::string light_words(sentence_of(light));
  return epsilon ? epsilon->text() + "; " + light_words : light_words;
}

SamplingVerdict sampling_verdict(std::span<const NodeReport> nodes) {
  SamplingVerdict out{.light = light_of(nodes)};
  for (const NodeReport& node : nodes)
    for (const Finding& finding : node.findings)
      if (finding.epsilon && !out.epsilon) {
        out.epsilon = finding.epsilon;
        if (!finding.places.empty()) out.sparsest = finding.places.front();
      }
  return out;
}

}  // namespace mes
