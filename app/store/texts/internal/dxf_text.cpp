// SPDX-License-Identifier: GPL-3.0-or-later
// Group codes: 0 begins an entity, 8 is its layer, 10 to 30 a place, 40 a radius, 50 and 51 are angles in degrees, 66 says
// that vertices follow, and 70 has the bits 1 for
// closed, 8 for a polyline in space and 32 for a vertex of one.
#include "app/store/texts/internal/dxf_text.h"

#include <fmt/core.h>
#include <array>
#include <cmath>
#include <numbers>

#include "core/io/drawings/dxf_pairs.h"
#include "core/io/text/text_numbers.h"

namespace mes {

std::string DxfText::beginning(std::string_view unit) {
  const std::string_view number = dxf_number_of_unit(unit);
  std::string out;
  if (!number.empty()) out = fmt::format("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{}\n0\nENDSEC\n", number);
  return out + "0\nSECTION\n2\nENTITIES\n";
}

void DxfText::begin(std::string_view entity) {
  out_.append("0\n").append(entity).append("\n8\n").append(layer_) += '\n';
}

void DxfText::number(std::string_view code, double value) {
  append_number(out_.append(code) += '\n', value);
  out_ += '\n';
}

void DxfText::place(Vec2 p, double height) {
  number("10", p.x);
  number("20", p.y);
  number("30", height);
}

void DxfText::point(Vec2 p) {
  begin("POINT");
  place(p);
}

void DxfText::circle(const Disk& disk) {
  begin("CIRCLE");
  place(disk.center);
  number("40", disk.radius);
}

void DxfText::arc(const Arc& arc) {
  if (arc.from == arc.to) return circle({arc.center, arc.radius});
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  double start = std::atan2(arc.from.y - arc.center.y, arc.from.x - arc.center.x) * kDegrees;
  if (start < 0.0) start += 360.0;
  double end = start + sweep_of(arc) * kDegrees;
  // Equal angles would be a whole circle.
  if (end == start) return polyline(std::array{arc.from, arc.to}, false);
  if (end >= 360.0) end -= 360.0;
  begin("ARC");
  place(arc.center);
  number("40", arc.radius);
  number("50", start);
  number("51", end);
}

void DxfText::polyline(std::span<const Vec2> corners, bool is_closed, std::span<const double> heights) {
  begin("POLYLINE");
  const bool is_in_space = !heights.empty();
  out_ += fmt::format("66\n1\n70\n{}\n", (is_closed ? 1 : 0) + (is_in_space ? 8 : 0));
  place({});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    begin("VERTEX");
    place(corners[i], is_in_space ? heights[i] : 0.0);
    if (is_in_space) out_ += "70\n32\n";
  }
  begin("SEQEND");
}

}  // namespace mes
