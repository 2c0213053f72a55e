// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: moments of a timeline, each with a caption and display settings. Plain data.
//
// A step names a number of timeline entries; its document is the replay of these, with all edits, undo, evolutions and
// annotations among them. Steps may go forwards and backwards.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/document/settings/computation_settings.h"
#include "core/document/settings/layer_configuration.h"

namespace mes {

/// Limits that readers enforce; larger `seconds` are clamped.
inline constexpr std::size_t kMostLessonSteps = 1000;
inline constexpr std::size_t kLongestLessonTitle = 1000;      ///< bytes
inline constexpr std::size_t kLongestLessonCaption = 10'000;  ///< bytes
inline constexpr double kLongestLessonStep = 600.0;           ///< seconds

struct LessonStep {
  std::string
      caption{};  ///< headings, paragraphs, lists, **bold**, *italics*, $...$ (app/picture/paper/caption_text.h)
  std::size_t position = 0;                       ///< number of timeline entries that are applied
  LayerConfiguration layers{};                    ///< empty: as in the timeline at this position
  std::optional<ComputationSettings> settings{};  ///< unset: as in the timeline at this position
  Box2 view{};                                    ///< document units; empty: as in the timeline at this position
  double seconds = 0.0;                           ///< duration in a video; 0: depends on the length of the caption
  friend bool operator==(const LessonStep&, const LessonStep&) = default;
};

struct Lesson {
  std::string title{};  ///< empty: the title of the session
  std::vector<LessonStep> steps{};
  friend bool operator==(const Lesson&, const Lesson&) = default;
};

}  // namespace mes
