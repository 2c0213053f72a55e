// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/sampling_request.h"

#include <fmt/core.h>

#include "app/cli/requests/names.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {

Expected<double> parse_real(std::string_view option, const std::string& text) {
  if (const auto value = parse_number(text)) return *value;
  return std::unexpected(
      Error{ErrorCode::usage, fmt::format("{} expects a number, not {}", option, in_quotes(text)), {}, 0, 0});
}

Expected<ShapeSampling> parse_sampling(const std::string& samples, const std::string& spacing,
                                       const std::string& jitter, const std::string& seed) {
  ShapeSampling out;
  if (!samples.empty()) {
    const auto count = whole_number("--samples", samples, 1, kMostShapeSamples);
    if (!count) return std::unexpected(count.error());
    out.samples = static_cast<std::size_t>(*count);
  }
  if (!spacing.empty()) {
    const auto distance = parse_real("--spacing", spacing);
    if (!distance) return std::unexpected(distance.error());
    out.spacing = *distance;
  }
  const auto moved = parse_real("--jitter", jitter);
  if (!moved) return std::unexpected(moved.error());
  out.jitter = *moved;
  const auto begin = whole_number("--seed", seed);
  if (!begin) return std::unexpected(begin.error());
  out.seed = *begin;
  return out;
}

}  // namespace mes::cli
