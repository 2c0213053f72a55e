// SPDX-License-Identifier: GPL-3.0-or-later
// Contours joined, cut, closed, opened, turned around. Pure functions from a document and a wish to its new contours.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/document/document.h"

namespace mes {

enum class ContourChange : std::uint8_t {
  join,     ///< a link between two samples, each of which is the end of an open contour or on none
  cut,      ///< no link between any two of the samples that are neighbours
  close,    ///< open contours with such a sample, and three samples or more, are closed
  open,     ///< closed ones are opened: at the links between such samples, or before the first of them on the contour
  reverse,  ///< contours with such a sample are turned around
  forget,   ///< contours with such a sample are gone; the samples stay
};
inline constexpr std::size_t kContourChanges = 6;

/// Contours that change are without samples that are no longer alive; all others stay as they are. Pieces of a single
/// sample are no contours. Error: `bad_input`, where there is nothing for the change to do; the text says what to select.
/// Cost: O(samples on contours).
Expected<CurveOrder> changed_contours(const Document& document, ContourChange change,
                                      std::span<const SampleId> samples);

/// `chains` as contours, in the place of all contours that share a sample with one of them.
CurveOrder with_contours(const Document& document, std::vector<CurveOrder::Contour> chains);

}  // namespace mes
