// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines of the shapes of a file, from scratch.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/document/commands.h"
#include "core/structures/filters/center_lines.h"

namespace mes {

class Registry;

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

/// Samples of the curves of the data by local feature size, since the axis of corners alone says little. Data without
/// curves are samples already. If there are closed curves, open ones and points are left out, and so are outlines that
/// lie in a strip and would need more than `kMostOutlineSamples` to show their width. Nothing if the rule cannot sample
/// the curves, or would need more samples than that: their exact axis can be taken instead. `remark` has a sentence for
/// each of these cases. Error: `bad_input`, if no outline remains. Throws `Cancelled`.
Expected<std::optional<SampleData>> samples_for_center_lines(const SampleData& data, JobControl& job,
                                                             std::string& remark);

/// A sentence on how the outlines of the data run over themselves and each other; empty if they do not, or are curved.
/// Throws `Cancelled`.
std::string remark_on_outlines(const SampleData& data, JobControl& job);

/// Error: `usage` if the wish names ends and no line joins any; `cannot_compute` if a structure failed, or there is no
/// line, with the reason. Throws `Cancelled`. `on_task` is called with the id of each structure before it begins.
Expected<CenterLines> compute_center_lines(const Registry& registry, const SampleData& data,
                                           const CenterLineWish& wish, JobControl& job,
                                           const std::function<void(std::string_view)>& on_task = {});

}  // namespace mes
