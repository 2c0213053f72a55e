// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of a function: spirals, epicycloids, superellipses, and typed formulas.
#include <array>
#include <cmath>

#include "core/shapes/internal/formula_in_t.h"
#include "core/shapes/internal/shape_parts.h"

namespace mes {
namespace {

constexpr std::size_t kPieces = 2048;
constexpr double kPiecesATurn = 512.0;

Expected<MadeShape> of_function(const PointOf& at, double from, double to, std::size_t pieces, bool may_close) {
  auto curve = curve_of_function(at, from, to, pieces, may_close);
  if (!curve) return std::unexpected(curve.error());
  return MadeShape{.curves = {{*std::move(curve)}, {}}};
}

/// Archimedean spiral: successive turns have a constant distance.
Expected<MadeShape> spiral(const ShapeArguments& values) {
  const double inner = values.numbers[1];
  const double gap = values.numbers[2];
  return of_function([&](double t) { return at_angle(inner + gap * t, kTurn * t); }, 0.0, values.numbers[0],
                     static_cast<std::size_t>(std::ceil(kPiecesATurn * values.numbers[0])), false);
}

/// Path of a point fixed to a circle that rolls around another circle, which is `cusps` times as large. `reach`:
/// distance of the point from the centre of the rolling circle, in radii.
Expected<MadeShape> epicycloid(const ShapeArguments& values) {
  const double cusps = values.numbers[0];
  const double radius = values.numbers[1];
  const double reach = values.numbers[2];
  return of_function(
      [&](double t) {
        return radius * ((cusps + 1.0) * at_angle(1.0, t) - reach * at_angle(1.0, (cusps + 1.0) * t));
      },
      0.0, kTurn, static_cast<std::size_t>(cusps * kPiecesATurn), true);
}

///x/a|^n + |y/b|^n = 1, parametrized by the angle, which makes it smooth for n above one.
Expected<MadeShape> superellipse(const ShapeArguments& values) {
  const auto [a, b, power] = std::array{values.numbers[0], values.numbers[1], values.numbers[2]};
  return of_function(
      [=](double t) {
        const double sum = std::pow(std::abs(std::cos(t) / a), power) + std::pow(std::abs(std::sin(t) / b), power);
        return at_angle(std::pow(sum, -1.0 / power), t);
      },
      0.0, kTurn, kPieces, true);
}

Expected<MadeShape> curve(const ShapeArguments& values) {
  const auto x = FormulaInT::parse(values.formulas[0], "x");
  if (!x) return std::unexpected(x.error());
  const auto y = FormulaInT::parse(values.formulas[1], "y");
  if (!y) return std::unexpected(y.error());
  if (!(values.numbers[0] < values.numbers[1])) return impossible("from must be less than to");
  return of_function(
      [&](double t) {
        return Vec2{x->at(t), y->at(t)};
      },
      values.numbers[0], values.numbers[1], kPieces, true);
}

Expected<MadeShape> polar(const ShapeArguments& values) {
  const auto radius = FormulaInT::parse(values.formulas[0], "r");
  if (!radius) return std::unexpected(radius.error());
  if (!(values.numbers[0] < values.numbers[1])) return impossible("from must be less than to");
  return of_function([&](double t) { return at_angle(radius->at(t), t); }, values.numbers[0], values.numbers[1],
                     kPieces, true);
}

const Parameter kFrom{"from", "The first t", "", -1e6, 1e6, 0.0};
const Parameter kTo{"to", "The last t", "", -1e6, 1e6, kTurn};

}  // namespace

std::vector<ShapeDescriptor> formula_shapes() {
  return {
      {"spiral",
       "Spiral",
       "a stroke whose turns are equally far apart",
       {{"turns", "The number of its turns", "", 0.1, 1000.0, 3.0},
        length_parameter("inner", "Where it begins", 0.2),
        length_parameter("gap", "Between its turns", 1.0)},
       {},
       0,
       spiral},
      {"epicycloid",
       "Epicycloid",
       "the path of a point of a wheel that rolls around another",
       {{"cusps", "How many times as large the other wheel is", "", 1.0, 1000.0, 5.0, true},
        length_parameter("radius", "Radius of the rolling wheel", 1.0),
        {"reach", "Where the point is, from the centre (0) to the rim (1)", "", 0.0, 1.0, 0.7}},
       {},
       0,
       epicycloid},
      {"superellipse",
       "Superellipse",
       "|x/a|^n + |y/b|^n = 1, between an ellipse (n = 2) and a rectangle",
       {length_parameter("a", "Half its width", 2.0),
        length_parameter("b", "Half its height", 1.0),
        {"n", "The power: 1 is a rhombus", "", 0.3, 50.0, 4.0}},
       {},
       0,
       superellipse},
      {"curve",
       "Curve (x(t), y(t))",
       "a curve by two formulas",
       {kFrom, kTo},
       {{"x", "x as a formula of t", "(2 + cos(3*t)) * cos(t)"},
        {"y", "y as a formula of t", "(2 + cos(3*t)) * sin(t)"}},
       0,
       curve},
      {"polar",
       "Curve r(t)",
       "a curve around the origin by a formula of the angle",
       {kFrom, kTo},
       {{"r", "The distance from the origin as a formula of t, in radians", "1 + 0.3*cos(5*t)"}},
       0,
       polar},
  };
}

}  // namespace mes
