// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "core/document/commands.h"
#include "core/io/format.h"
#include "core/io/text/text_numbers.h"

namespace mes {

void append_map_line(std::string& out, const std::optional<MapPlane>& map) {
  if (!map) return;
  const bool is_in_system = map->projection == MapProjection::none;
  if (map->is_of_drawing()) {
    out += "# unit " + map->unit + '\n';
    if (map->page == Vec2{}) return;
    append_number(out += "# page ", map->page.x);
    append_number(out += ' ', map->page.y);
    out += '\n';
    return;
  }
  out += "# map ";
  if (is_in_system) {
    out += map->system.empty() ? "degrees" : map->unit;
  } else {
    out += map->projection == MapProjection::azimuthal ? "metres about " : "kilometres about ";
    append_number(out, map->longitude);
    append_number(out += ' ', map->latitude);
  }
  if (!map->system.empty()) out += " of " + map->system;
  out += '\n';
}

std::string write_poff(const Document& document) {
  const SampleData data = data_of(document);
  constexpr std::size_t kTypicalLine = 40;
  std::string out = fmt::format("POFF {} 0 0\n", data.positions.size());
  out.reserve(out.size() + data.positions.size() * kTypicalLine);
  for (const Vec2 p : data.positions) {
    append_number(out, p.x);
    out += ' ';
    append_number(out, p.y);
    out += '\n';
  }
  append_map_line(out, data.map);
  for (const SampleData::Contour& contour : data.contours) {
    out += contour.closed ? "# loop closed" : "# loop open";
    for (const std::uint32_t point : contour.points) out += ' ' + std::to_string(point);
    out += '\n';
  }
  return out;
}

}  // namespace mes
