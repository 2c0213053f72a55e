// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/page_size.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/io/text/text_numbers.h"
#include "render/figure/figure.h"

namespace mes {
namespace {

struct Unit {
  std::string_view name;
  double points;
};
constexpr double kMillimeter = figure::kPointsPerInch / figure::kMillimetersPerInch;
constexpr std::array kUnits{Unit{"mm", kMillimeter}, Unit{"cm", 10.0 * kMillimeter},
                            Unit{"in", figure::kPointsPerInch}, Unit{"pt", 1.0}, Unit{"px", figure::kPointsPerPixel}};

// The column widths of common journals, and a slide of 16:9 as presentation programs have it.
constexpr std::array kPresets{PagePreset{"one-column", "84mm"}, PagePreset{"two-columns", "174mm"},
                              PagePreset{"slide", "960ptx540pt", 2.0}, PagePreset{"square", "84mmx84mm"}};

// The largest page of PDF is 200 inches wide.
constexpr double kLeast = kMillimeter;
constexpr double kLargestPage = 5080.0 * kMillimeter;

std::unexpected<Error> usage_error(std::string text) {
  return std::unexpected(Error{ErrorCode::usage, std::move(text), {}, 0, 0});
}

std::unexpected<Error> refused(const std::string& text) {
  std::string presets;
  for (const PagePreset& preset : kPresets) presets += ", " + std::string(preset.name);
  return usage_error("expects WxH or a width, with units mm, cm, in, pt or px, as in 84mmx60mm, or one of " +
                     presets.substr(2) + ", not " + in_quotes(text));
}

}  // namespace

std::span<const PagePreset> page_presets() {
  return kPresets;
}

std::optional<double> parse_length(std::string_view text) {
  for (const Unit& unit : kUnits) {
    if (!text.ends_with(unit.name)) continue;
    const auto value = parse_number(text.substr(0, text.size() - unit.name.size()));
    return value ? std::optional(*value * unit.points) : std::nullopt;
  }
  return std::nullopt;
}

Expected<PageSize> parse_page_size(const std::string& text) {
  const auto preset = std::ranges::find(kPresets, text, &PagePreset::name);
  const std::string_view size = preset != kPresets.end() ? preset->size : std::string_view(text);
  PageSize out;
  if (preset != kPresets.end()) out.lettering = preset->lettering;
  // Finds the x between two sides, not that of px.
  std::size_t cross = size.find_first_of("xX");
  if (cross != std::string_view::npos && cross > 0 && size[cross - 1] == 'p')
    cross = size.find_first_of("xX", cross + 1);
  const auto width = parse_length(size.substr(0, cross));
  if (!width) return refused(text);
  out.width = *width;
  if (cross != std::string_view::npos) {
    out.height = parse_length(size.substr(cross + 1));
    if (!out.height) return refused(text);
  }
  for (const double side : {out.width, out.height.value_or(out.width)})
    if (side < kLeast || side > kLargestPage)
      return usage_error("takes sides from 1 mm to 5080 mm, not " + in_quotes(text));
  return out;
}

}  // namespace mes
