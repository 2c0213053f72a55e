// SPDX-License-Identifier: GPL-3.0-or-later
// A structure's report on how far its results can be trusted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry/sampling_epsilon.h"
#include "core/base/geometry/vec2.h"

namespace mes {

/// The findings of all structures together determine the theorem light.
enum class FindingLevel : std::uint8_t {
  note,   ///< no colour: concerns drawing or sampling, which the theorem does not cover
  doubt,  ///< yellow: the result is exact, but the sample does not meet the assumptions of the theorem
  wrong,  ///< red: the chosen number type gave a wrong or inconsistent result
};

struct Finding {
  FindingLevel level = FindingLevel::doubt;
  std::string text;                          ///< one line, no full stop, without the count
  std::int64_t count = 0;                    ///< number of places
  std::vector<Vec2> places;                  ///< some of these places, at most `kMostPlaces`
  std::optional<SamplingEpsilon> epsilon{};  ///< said beside the light; at most one structure gives it
  friend bool operator==(const Finding&, const Finding&) = default;
};
inline constexpr std::size_t kMostPlaces = 64;

}  // namespace mes
