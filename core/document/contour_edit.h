// SPDX-License-Identifier: GPL-3.0-or-later
// Joins, cuts, closes, opens and reverses contours. Pure functions from a document and a requested change to contours.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"

namespace mes {

enum class ContourChange : std::uint8_t {
  join,     ///< links two samples, each of which is an end of an open contour or on no contour
  cut,      ///< removes links between neighbours that are both selected
  close,    ///< closes open contours with a selected sample and at least three samples
  open,     ///< opens closed contours: at links between selected samples, or before the first one on the contour
  reverse,  ///< reverses contours with a selected sample
  forget,   ///< removes contours with a selected sample; the samples stay
};
inline constexpr std::size_t kContourChanges = 6;

/// Changed contours drop samples that are no longer alive; all others stay unchanged. Pieces of a single sample are not
/// kept. Error: `bad_input` if there is nothing to change; the text says what to select.
/// Cost: O(samples on contours).
Expected<CurveOrder> changed_contours(const Document& document, ContourChange change,
                                      std::span<const SampleId> samples);

/// All contours, with `chains` replacing those that share a sample with one of them.
CurveOrder with_contours(const Document& document, std::vector<CurveOrder::Contour> chains);

}  // namespace mes
