// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/center_line_text.h"

#include <fmt/core.h>
#include <algorithm>

namespace mes {

TextLine text_line_of(const CenterLine& line, const std::optional<MapPlane>& map, double unit) {
  TextLine out{.points = {}, .is_closed = line.is_closed, .map = map};
  for (const CenterLine::Point& point : line.points) out.points.push_back(point.place);
  out.radii = radii_of(line);
  const Widths widths = widths_of(line);
  out.numbers = {{"shape", static_cast<double>(line.shape + 1)},
                 {"line", static_cast<double>(line.rank + 1)},
                 {"length", unit * length_of(line)},
                 {"width_least", unit * widths.least},
                 {"width_mean", unit * widths.mean},
                 {"width_largest", unit * widths.largest}};
  return out;
}

void CenterLineTotals::add(const CenterLines& found, double unit) {
  lines += found.lines.size();
  points += found.points;
  for (const CenterLine& line : found.lines) {
    length.add(unit * length_of(line));
    const Widths own = widths_of(line);
    widths.least = std::min(widths.least, unit * own.least);
    widths.largest = std::max(widths.largest, unit * own.largest);
  }
}

std::string CenterLineTotals::text(const std::optional<MapPlane>& map, std::uint64_t off_earth,
                                   std::size_t stations) const {
  const std::string unit = map ? fmt::format(" {}", map->written_unit()) : std::string();
  std::string out = fmt::format("{} of length {:.6g}{} in all, width {:.6g} to {:.6g}{}",
                                lines == 1 ? "1 line" : fmt::format("{} lines", lines), length.value(), unit,
                                widths.least, widths.largest, unit);
  if (stations != 0) out += stations == 1 ? ", 1 station" : fmt::format(", {} stations", stations);
  if (points != 0)
    out += fmt::format("; {} no line, since {} pruned axis is a point",
                       points == 1 ? "1 shape has" : fmt::format("{} shapes have", points),
                       points == 1 ? "its" : "their");
  if (off_earth != 0)
    out += fmt::format("; {} left out that {} beyond the poles or around the Earth",
                       off_earth == 1 ? "1 line is" : fmt::format("{} lines are", off_earth),
                       off_earth == 1 ? "reaches" : "reach");
  return out;
}

}  // namespace mes
