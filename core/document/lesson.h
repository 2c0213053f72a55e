// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: moments of a timeline, each with a caption and how it is to be seen. Plain data.
//
// A step names how much of the timeline is done, so its document is the replay up to there, with everything that
// edits, undo, evolutions and annotations made of it. Steps may go back and forth.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/box2.h"
#include "core/document/computation_settings.h"
#include "core/document/layer_configuration.h"

namespace mes {

/// Bounds of what readers accept; `seconds` beyond its bound is brought to it.
inline constexpr std::size_t kMostLessonSteps = 1000;
inline constexpr std::size_t kLongestLessonTitle = 1000;      ///< bytes
inline constexpr std::size_t kLongestLessonCaption = 10'000;  ///< bytes
inline constexpr double kLongestLessonStep = 600.0;           ///< seconds

struct LessonStep {
  std::string caption{};     ///< headings, paragraphs, lists, **bold**, *italics*, $...$ (app/picture/caption_text.h)
  std::size_t position = 0;  ///< so many entries of the timeline are done
  LayerConfiguration layers{};                    ///< no layers: as the timeline has them there
  std::optional<ComputationSettings> settings{};  ///< none: as the timeline has them there
  Box2 view{};                                    ///< document units; empty: as the timeline has it there
  double seconds = 0.0;  ///< how long it stays in a video; 0: as its caption needs to be read
  friend bool operator==(const LessonStep&, const LessonStep&) = default;
};

struct Lesson {
  std::string title{};  ///< empty: that of the session
  std::vector<LessonStep> steps{};
  friend bool operator==(const Lesson&, const Lesson&) = default;
};

}  // namespace mes
