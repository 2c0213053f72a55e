// SPDX-License-Identifier: GPL-3.0-or-later
// What a structure has to say about the trust its results deserve.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec2.h"

namespace mes {

/// Together the findings of all structures make the theorem light.
enum class FindingLevel : std::uint8_t {
  note,   ///< no colour: how something is drawn or sampled, which the theorem does not speak of
  doubt,  ///< yellow: exact, but the sample does not meet what the theorem asks for
  wrong,  ///< red: the chosen number type gave a wrong or inconsistent result
};

struct Finding {
  FindingLevel level = FindingLevel::doubt;
  std::string text;          ///< one line, no full stop, without the count
  std::int64_t count = 0;    ///< how many places there are
  std::vector<Vec2> places;  ///< some of them, at most `kMostPlaces`
  std::string summary;       ///< of a note that is to be seen at all times: what stands beside the light
  friend bool operator==(const Finding&, const Finding&) = default;
};
inline constexpr std::size_t kMostPlaces = 64;

}  // namespace mes
