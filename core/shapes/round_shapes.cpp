// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of circles, arcs and lines: exact curves.
#include <cmath>

#include "core/shapes/internal/shape_parts.h"

namespace mes {
namespace {

Expected<MadeShape> circle(const ShapeArguments& values) {
  return MadeShape{.curves = {{ellipse_curve({}, values.numbers[0], values.numbers[0])}, {}}};
}

Expected<MadeShape> ellipse(const ShapeArguments& values) {
  return MadeShape{.curves = {{ellipse_curve({}, values.numbers[0], values.numbers[1])}, {}}};
}

/// A rectangle about the origin with quarter circles as corners.
PlaneCurve rounded(double half_width, double half_height, double radius) {
  const double x = half_width - radius;
  const double y = half_height - radius;
  const Vec2 centers[] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  const Vec2 steps[] = {{radius, 0.0}, {0.0, radius}, {-radius, 0.0}, {0.0, -radius}};
  PlaneCurve out(centers[0] + steps[0]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 end = centers[i] + steps[(i + 1) % 4];
    out.arc_to({centers[i], {radius, 0.0}, {0.0, radius}, 0.25 * kTurn * static_cast<double>(i), 0.25 * kTurn}, end);
    const Vec2 next = centers[(i + 1) % 4] + steps[(i + 1) % 4];
    if (next != end) out.line_to(next);
  }
  out.close();
  return out;
}

Expected<MadeShape> stadium(const ShapeArguments& values) {
  const double radius = values.numbers[1];
  return MadeShape{.curves = {{rounded(values.numbers[0] + radius, radius, radius)}, {}}};
}

Expected<MadeShape> rounded_rectangle(const ShapeArguments& values) {
  const double half_width = 0.5 * values.numbers[0];
  const double half_height = 0.5 * values.numbers[1];
  if (values.numbers[2] > std::min(half_width, half_height))
    return impossible("the radius of the corners must be at most half of width and height");
  return MadeShape{.curves = {{rounded(half_width, half_height, values.numbers[2])}, {}}};
}

Expected<MadeShape> annulus(const ShapeArguments& values) {
  if (values.numbers[1] + std::abs(values.numbers[2]) >= values.numbers[0])
    return impossible("the hole must lie within the outer circle: inner and shift together must be less than outer");
  return MadeShape{.curves = {{ellipse_curve({}, values.numbers[0], values.numbers[0]),
                               ellipse_curve({values.numbers[2], 0.0}, values.numbers[1], values.numbers[1], true)},
                              {}}};
}

}  // namespace

std::vector<ShapeDescriptor> round_shapes() {
  return {
      {"circle",
       "Circle",
       "a circle about the origin",
       {length_parameter("radius", "Its radius", 1.0)},
       {},
       0,
       circle},
      {"ellipse",
       "Ellipse",
       "an ellipse about the origin",
       {length_parameter("a", "Half its width", 2.0), length_parameter("b", "Half its height", 1.0)},
       {},
       0,
       ellipse},
      {"stadium",
       "Stadium",
       "the points at a fixed distance from a segment",
       {length_parameter("half-length", "Half the length of the segment", 1.5),
        length_parameter("radius", "The distance", 1.0)},
       {},
       0,
       stadium},
      {"rounded-rectangle",
       "Rounded rectangle",
       "a rectangle whose corners are quarters of circles",
       {length_parameter("width", "Its width", 4.0), length_parameter("height", "Its height", 2.0),
        length_parameter("radius", "The radius of the corners", 0.5)},
       {},
       0,
       rounded_rectangle},
      {"annulus",
       "Annulus",
       "a disk with a round hole",
       {length_parameter("outer", "Radius of the disk", 2.0),
        length_parameter("inner", "Radius of the hole", 1.0),
        {"shift", "Where the centre of the hole lies, to the right", "", -1e6, 1e6, 0.0}},
       {},
       0,
       annulus},
  };
}

}  // namespace mes
