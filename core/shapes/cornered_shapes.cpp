// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes with corners: polygons, stars, gears, combs.
#include "core/shapes/internal/shape_parts.h"

namespace mes {
namespace {

Expected<MadeShape> of_corners(const std::vector<Vec2>& corners) {
  return MadeShape{.curves = {{polygon_curve(corners)}, {}}};
}

/// The first corner points upwards.
Expected<MadeShape> polygon(const ShapeArguments& values) {
  std::vector<Vec2> corners;
  for (double i = 0.0; i < values.numbers[0]; ++i)
    corners.push_back(at_angle(values.numbers[1], kTurn * (0.25 + i / values.numbers[0])));
  return of_corners(corners);
}

Expected<MadeShape> star(const ShapeArguments& values) {
  const double points = values.numbers[0];
  if (values.numbers[2] >= values.numbers[1]) return impossible("inner must be less than outer");
  std::vector<Vec2> corners;
  for (double i = 0.0; i < points; ++i) {
    corners.push_back(at_angle(values.numbers[1], kTurn * (0.25 + i / points)));
    corners.push_back(at_angle(values.numbers[2], kTurn * (0.25 + (i + 0.5) / points)));
  }
  return of_corners(corners);
}

/// Teeth of arcs about the centre, with radial sides; as wide as the gaps between them.
Expected<MadeShape> gear(const ShapeArguments& values) {
  const double teeth = values.numbers[0];
  const double outer = values.numbers[1];
  const double inner = values.numbers[2];
  if (inner >= outer) return impossible("inner must be less than outer");
  const double half = 0.5 * kTurn / teeth;
  PlaneCurve out(at_angle(outer, 0.0));
  for (double i = 0.0; i < teeth; ++i) {
    const double angle = kTurn * i / teeth;
    const double next = i + 1.0 < teeth ? kTurn * (i + 1.0) / teeth : 0.0;
    out.arc_to({{}, {outer, 0.0}, {0.0, outer}, angle, half}, at_angle(outer, angle + half));
    out.line_to(at_angle(inner, angle + half));
    out.arc_to({{}, {inner, 0.0}, {0.0, inner}, angle + half, half}, at_angle(inner, next));
    if (i + 1.0 < teeth) out.line_to(at_angle(outer, next));
  }
  out.close();
  return MadeShape{.curves = {{std::move(out)}, {}}};
}

/// Teeth and gaps along the upper side of a beam.
Expected<MadeShape> comb(const ShapeArguments& values) {
  const double teeth = values.numbers[0];
  const double tooth = values.numbers[1];
  const double gap = values.numbers[2];
  const double length = values.numbers[3];
  const double beam = values.numbers[4];
  const double width = teeth * tooth + (teeth - 1.0) * gap;
  std::vector<Vec2> corners{{0.0, 0.0}, {width, 0.0}};
  for (double i = teeth - 1.0; i >= 0.0; --i) {
    const double left = i * (tooth + gap);
    if (i + 1.0 < teeth) corners.push_back({left + tooth, beam});
    corners.push_back({left + tooth, beam + length});
    corners.push_back({left, beam + length});
    if (i > 0.0) corners.push_back({left, beam});
  }
  return of_corners(corners);
}

Parameter count(const char* id, const char* explanation, double low, double value) {
  return {id, explanation, "", low, 10000.0, value, true};
}

}  // namespace

std::vector<ShapeDescriptor> cornered_shapes() {
  return {
      {"polygon",
       "Polygon",
       "a regular polygon",
       {count("corners", "How many corners it has", 3.0, 5.0),
        length_parameter("radius", "From its middle to its corners", 1.0)},
       {},
       0,
       polygon},
      {"star",
       "Star",
       "a star with straight sides",
       {count("points", "How many points it has", 2.0, 5.0),
        length_parameter("outer", "From its middle to its points", 1.0),
        length_parameter("inner", "From its middle to the corners between them", 0.4)},
       {},
       0,
       star},
      {"gear",
       "Gear",
       "a wheel with teeth as wide as the gaps between them",
       {count("teeth", "How many teeth it has", 2.0, 12.0), length_parameter("outer", "Radius of the teeth", 1.0),
        length_parameter("inner", "Radius between them", 0.8)},
       {},
       0,
       gear},
      {"comb",
       "Comb",
       "a beam with teeth on its upper side",
       {count("teeth", "How many teeth it has", 1.0, 8.0), length_parameter("tooth", "Width of a tooth", 0.2),
        length_parameter("gap", "Width of a gap", 0.1), length_parameter("length", "Length of a tooth", 1.0),
        length_parameter("beam", "Height of the beam", 0.4)},
       {},
       0,
       comb},
  };
}

}  // namespace mes
