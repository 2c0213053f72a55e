// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/live_corners.h"

namespace mes {

std::vector<SampleId> live_corners(const Document& document, const CurveOrder::Contour& contour) {
  std::vector<SampleId> out;
  out.reserve(contour.samples.size());
  for (const SampleId id : contour.samples)
    if (document.slot_of(id) != kNoSlot && (out.empty() || out.back() != id)) out.push_back(id);
  if (contour.closed && out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

}  // namespace mes
