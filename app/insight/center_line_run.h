// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines of the shapes of a file, from scratch.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"
#include "core/structures/filters/center_lines.h"
#include "core/workbench/workbench.h"

namespace mes {

struct CenterLineWish {
  SmoothingTolerance tolerance = kUsualSmoothing;
  bool is_extended = false;   ///< free ends reach the curve
  bool is_exact = false;      ///< lines of the exact axis of the outlines, without samples
  double lambda_limit = 0.0;  ///< least lambda of the axis that the lines are made of; 0: all of it
  CenterLineRequest request{};
};

/// The lines of the layer `center-lines` at these settings, in data with these annotations.
CenterLineWish wish_of(const ComputationSettings& settings, const Annotations& annotations);

/// Most samples of all outlines. They are enough for one that is 30,000 times as long as it is wide, and take some 15 s
/// on one core. A digit too many in a coordinate easily asks for more.
inline constexpr std::size_t kMostOutlineSamples = 250'000;

/// The data that centre lines are computed from.
enum class CenterLineBasis : std::uint8_t {
  own_samples,  ///< the samples of the data
  new_samples,  ///< samples of the curves by local feature size, since the axis of corners alone says little
  outlines,     ///< the curves themselves
};

struct CenterLineInput {
  SampleData data{};
  bool is_exact = false;  ///< the lines are to be those of the exact axis of the outlines
  std::vector<std::string>
      remarks{};  ///< a sentence each, on what was chosen, left out, or is wrong with the outlines
};

/// Data without curves are samples already, unless they have contours that these do not stand for, as where a table has
/// only the corners of a ring. If there are closed curves, open ones and points are left out, and so are
/// outlines without a width. Instead of new samples the outlines themselves are chosen if these cross, or if the rule
/// cannot sample them, or would need more samples than `kMostOutlineSamples`. Error: `bad_input`, if no outline remains.
/// Throws `Cancelled`.
Expected<CenterLineInput> input_for_center_lines(const SampleData& data, CenterLineBasis basis, JobControl& job);

/// Computes centre lines of one set of samples or outlines after the other. Structures are made once: for an outline with
/// few sides this takes longer than its lines.
///
/// Threads: one at a time.
class CenterLineFinder {
 public:
  /// The registry must outlive the finder.
  explicit CenterLineFinder(const Registry& registry) : bench_(registry, {.keeps_document = false}) {}

  /// Error: `usage` if the wish names ends and no line joins any; `cannot_compute` if a structure failed, or there is no
  /// line, with the reason. Throws `Cancelled`. `on_task` is called with the id of each structure before it begins.
  Expected<CenterLines> find(const SampleData& data, const CenterLineWish& wish, JobControl& job,
                             const std::function<void(std::string_view)>& on_task = {});

 private:
  Workbench bench_;
};

}  // namespace mes
