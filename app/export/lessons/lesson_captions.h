// SPDX-License-Identifier: GPL-3.0-or-later
// The captions of a lesson, timed for its video.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/document/timeline/lesson.h"

namespace mes {

/// WebVTT (W3C Candidate Recommendation, 2019): one cue per step with a caption, each block of the caption on a line,
/// the steps one after the other from time 0.
std::string web_vtt_of(const Lesson& lesson, std::span<const std::size_t> steps);

}  // namespace mes
