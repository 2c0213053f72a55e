// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/center_line_text.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "core/base/counted.h"

namespace mes {
namespace {

/// Keeps the first point, and from each kept point the farthest one up to which a straight piece is near enough.
void thin(std::vector<Vec2>& points, std::vector<double>& radii) {
  constexpr double kNear = 0x1p-12;  // of the radius
  const std::size_t n = points.size();
  const auto is_near = [&](std::size_t first, std::size_t last) {
    const Vec2 along = points[last] - points[first];
    const double size = dot(along, along);
    for (std::size_t i = first + 1; i < last; ++i) {
      const double share = size > 0.0 ? std::clamp(dot(points[i] - points[first], along) / size, 0.0, 1.0) : 0.0;
      const double most = kNear * radii[i];
      const double radius = (1.0 - share) * radii[first] + share * radii[last];
      if (distance(points[i], points[first] + share * along) > most || std::abs(radii[i] - radius) > most)
        return false;
    }
    return true;
  };
  std::size_t kept = 0;
  for (std::size_t at = 0; at + 1 < n;) {
    std::size_t step = 1;
    while (at + 2 * step < n && is_near(at, at + 2 * step)) step *= 2;
    for (std::size_t more = step / 2; more != 0; more /= 2)
      if (at + step + more < n && is_near(at, at + step + more)) step += more;
    at += step;
    ++kept;
    points[kept] = points[at];
    radii[kept] = radii[at];
  }
  points.resize(kept + 1);
  radii.resize(kept + 1);
}

}  // namespace

TextLine text_line_of(const CenterLine& line, const std::optional<MapPlane>& map, double unit) {
  TextLine out{.points = {}, .is_closed = line.is_closed, .map = map};
  for (const CenterLine::Point& point : line.points) out.points.push_back(point.place);
  out.radii = radii_of(line);
  if (!out.points.empty()) thin(out.points, out.radii);
  const Widths widths = widths_of(line);
  out.numbers = {{"shape", static_cast<double>(line.shape + 1), true},
                 {"line", static_cast<double>(line.rank + 1), true},
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
  std::string out = fmt::format("{} of length {:.6g}{} in all, width {:.6g} to {:.6g}{}", counted(lines, "line"),
                                length.value(), unit, widths.least, widths.largest, unit);
  if (stations != 0) out += ", " + counted(stations, "station");
  if (points != 0)
    out += fmt::format("; {} no line, since {} pruned axis is a point", counted(points, "shape has", "shapes have"),
                       points == 1 ? "its" : "their");
  if (off_earth != 0)
    out += fmt::format("; {} left out that {} beyond the poles or around the Earth",
                       counted(off_earth, "line is", "lines are"), off_earth == 1 ? "reaches" : "reach");
  return out;
}

}  // namespace mes
