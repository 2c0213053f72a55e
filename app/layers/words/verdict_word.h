// SPDX-License-Identifier: GPL-3.0-or-later
// The theorem light and its findings in words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/geometry/finding.h"
#include "core/engine/engine.h"
#include "core/engine/sampling_verdict.h"

namespace mes {

/// Whether the light refers to the document as it is now.
enum class Checking : std::uint8_t { done, under_way, cancelled };
/// Progress of shorter work would only flicker; until then the previous display stays.
inline constexpr double kShownAfterMs = 100.0;
/// `is_outdated`: the results are those of another document.
Checking checking_of(const EngineStatus& status, bool is_outdated);

struct VerdictWord {
  enum class Mood : std::uint8_t { good, doubtful, wrong, warning, quiet };
  Mood mood = Mood::quiet;
  std::string_view word;     ///< for the status bar
  std::string_view meaning;  ///< one sentence, no full stop
  std::string text{};        ///< the verdict as commands and messages give it; the meaning while there is none
};
/// The mood of a finding in the list below the light.
VerdictWord::Mood mood_of(FindingLevel level);
VerdictWord verdict_word(const SamplingVerdict& verdict, bool lacks_memory, Checking checking);

/// The text of a structure's finding with its count: "207 triangles misjudged by rounding ..., of the inner balls".
std::string text_of(const Finding& finding, std::string_view structure);

/// The name of a structure's result, by its public id: "the Delaunay triangulation"; an unknown id gets spaces for
/// hyphens.
std::string structure_name(std::string_view id);
/// The task while this structure, or "layers", is at work: "Checking the theorem", "Computing the crust".
std::string task_text(std::string_view task);

}  // namespace mes
