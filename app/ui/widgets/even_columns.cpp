// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/even_columns.h"

#include <algorithm>
#include <numeric>

namespace mes {
namespace {

// Where a column may end within a group: not after its first line, nor before its last.
std::size_t end_of_block(const std::vector<float>& lines, std::size_t first, bool begins) {
  const std::size_t end = std::min(first + (begins ? 2U : 1U), lines.size());
  return end + 1 == lines.size() ? lines.size() : end;
}

EvenColumns filled_columns(const std::vector<std::vector<float>>& groups, float heading, float height) {
  EvenColumns out(1);
  float filled = 0.0F;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const std::vector<float>& lines = groups[group];
    bool begins = true;
    for (std::size_t first = 0; first < lines.size();) {
      const auto height_to = [&](std::size_t end) {
        return std::accumulate(lines.begin() + static_cast<std::ptrdiff_t>(first),
                               lines.begin() + static_cast<std::ptrdiff_t>(end), begins ? heading : 0.0F);
      };
      std::size_t end = end_of_block(lines, first, begins);
      if (filled > 0.0F && filled + height_to(end) > height) {
        out.emplace_back();
        filled = 0.0F;
        begins = true;
        end = end_of_block(lines, first, begins);
      }
      filled += height_to(end);
      if (begins) out.back().push_back({group, first, first});
      out.back().back().end = end;
      begins = false;
      first = end;
    }
  }
  return out;
}

}  // namespace

EvenColumns even_columns(const std::vector<std::vector<float>>& groups, float heading, std::size_t most) {
  float high = 0.0F;
  for (const std::vector<float>& lines : groups) high += std::accumulate(lines.begin(), lines.end(), heading);
  float low = 0.0F;
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const float middle = 0.5F * (low + high);
    (filled_columns(groups, heading, middle).size() <= most ? high : low) = middle;
  }
  return filled_columns(groups, heading, high);
}

}  // namespace mes
