// SPDX-License-Identifier: GPL-3.0-or-later
// Point sets (random, lattices, degenerate, nearly degenerate), and balls along a curve.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/rng.h"
#include "core/shapes/internal/formula_in_t.h"
#include "core/shapes/internal/shape_parts.h"

namespace mes {
namespace {

MadeShape of_points(std::vector<Vec2> points) {
  return {.curves = {{}, std::move(points)}};
}

/// Two independent numbers of mean 0 and variance 1 (Box and Muller 1958).
Vec2 gaussian_pair(Rng& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  const double angle = random.uniform(0.0, kTurn);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Expected<MadeShape> uniform(const ShapeArguments& values) {
  Rng random(values.seed);
  std::vector<Vec2> out(values.samples);
  for (Vec2& p : out) {
    p.x = random.uniform(0.0, values.numbers[0]);
    p.y = random.uniform(0.0, values.numbers[1]);
  }
  return of_points(std::move(out));
}

Expected<MadeShape> gaussian(const ShapeArguments& values) {
  Rng random(values.seed);
  std::vector<Vec2> out(values.samples);
  for (Vec2& p : out) p = values.numbers[0] * gaussian_pair(random);
  return of_points(std::move(out));
}

Expected<MadeShape> clustered(const ShapeArguments& values) {
  Rng random(values.seed);
  std::vector<Vec2> centers(static_cast<std::size_t>(values.numbers[0]));
  for (Vec2& p : centers) {
    p.x = random.uniform();
    p.y = random.uniform();
  }
  std::vector<Vec2> out(values.samples);
  for (Vec2& p : out) {
    const Vec2 center = centers[random.below(centers.size())];
    p = center + values.numbers[1] * gaussian_pair(random);
  }
  return of_points(std::move(out));
}

/// Throws darts into the unit square and repeats those too near to an earlier one. The square of the least distance is
/// `share` squared of an equal part of the area, well below the share at which darts no longer find room (0.83).
Expected<MadeShape> poisson_disk(const ShapeArguments& values) {
  Rng random(values.seed);
  const double least = values.numbers[0] / std::sqrt(static_cast<double>(values.samples));
  // The cells are at least as wide as the distance, and there are at most as many as points.
  const double most = std::ceil(std::sqrt(static_cast<double>(values.samples)));
  const auto side = static_cast<std::size_t>(std::max(1.0, std::min(most, std::floor(1.0 / least))));
  std::vector<std::vector<Vec2>> cells(side * side);
  const auto cell_of = [&](double x) {
    return std::min(static_cast<std::size_t>(x * static_cast<double>(side)), side - 1);
  };
  const auto has_room = [&](Vec2 p) {
    const std::size_t x = cell_of(p.x);
    const std::size_t y = cell_of(p.y);
    for (std::size_t j = y - std::min<std::size_t>(y, 1); j <= std::min(y + 1, side - 1); ++j)
      for (std::size_t i = x - std::min<std::size_t>(x, 1); i <= std::min(x + 1, side - 1); ++i)
        for (const Vec2 q : cells[j * side + i])
          if (dot(q - p, q - p) < least * least) return false;
    return true;
  };
  std::vector<Vec2> out;
  while (out.size() < values.samples) {
    const double x = random.uniform();
    const Vec2 p{x, random.uniform()};
    if (!has_room(p)) continue;
    out.push_back(p);
    cells[cell_of(p.y) * side + cell_of(p.x)].push_back(p);
  }
  return of_points(std::move(out));
}

/// A lattice with as many rows as columns, if the count is a square; the last row may be shorter.
template <class At>
Expected<MadeShape> lattice(std::size_t count, At at) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(at(static_cast<double>(i % columns), static_cast<double>(i / columns)));
  return of_points(std::move(out));
}

Expected<MadeShape> square_lattice(const ShapeArguments& values) {
  return lattice(values.samples, [&](double x, double y) { return values.numbers[0] * Vec2{x, y}; });
}

Expected<MadeShape> hexagonal_lattice(const ShapeArguments& values) {
  const double height = 0.5 * std::sqrt(3.0);
  return lattice(values.samples, [&](double x, double y) {
    return values.numbers[0] * Vec2{x + 0.5 * std::fmod(y, 2.0), height * y};
  });
}

/// All pairs of integers on the circle of radius 5 * 13 * 17 * 29 * 37 * 41 about the origin, by angle. Each of these
/// primes is a product (a + bi)(a - bi), so its squared factors can be divided between a point and its mirror image in
/// three ways.
std::vector<Vec2> integers_on_circle() {
  using Pair = std::array<std::int64_t, 2>;
  const auto times = [](Pair a, Pair b) { return Pair{a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]}; };
  std::vector<Pair> points{{1, 0}};
  for (const Pair prime : {Pair{2, 1}, Pair{3, 2}, Pair{4, 1}, Pair{5, 2}, Pair{6, 1}, Pair{5, 4}}) {
    const Pair mirrored{prime[0], -prime[1]};
    std::vector<Pair> next;
    for (const Pair point : points)
      for (const Pair factor : {times(prime, prime), times(prime, mirrored), times(mirrored, mirrored)})
        next.push_back(times(point, factor));
    points = std::move(next);
  }
  std::vector<Vec2> out;
  for (const Pair point : points) {
    const Vec2 p{static_cast<double>(point[0]), static_cast<double>(point[1])};
    for (const Vec2 turned : {p, perpendicular(p), -p, -perpendicular(p)}) out.push_back(turned);
  }
  std::ranges::sort(out, {}, [](Vec2 p) { return std::atan2(p.y, p.x); });
  return out;
}

/// Scales by a power of two, which keeps the points exactly cocircular.
Expected<MadeShape> cocircular(const ShapeArguments& values) {
  const std::vector<Vec2> all = integers_on_circle();
  if (values.samples > all.size())
    return impossible("of exactly cocircular points there are at most " + std::to_string(all.size()));
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < values.samples; ++i) out.push_back(0x1p-25 * all[i * all.size() / values.samples]);
  return of_points(std::move(out));
}

Expected<MadeShape> almost_cocircular(const ShapeArguments& values) {
  Rng random(values.seed);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < values.samples; ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(values.samples);
    const double radius = 1.0 + values.numbers[0] * random.uniform(-1.0, 1.0);
    out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return of_points(std::move(out));
}

/// Multiples of an integer step, which are exact.
Expected<MadeShape> collinear(const ShapeArguments& values) {
  const Vec2 step{values.numbers[0], values.numbers[1]};
  if (step == Vec2{}) return impossible("dx and dy must not both be zero");
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < values.samples; ++i) out.push_back(static_cast<double>(i) * step);
  return of_points(std::move(out));
}

Expected<MadeShape> almost_collinear(const ShapeArguments& values) {
  Rng random(values.seed);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < values.samples; ++i)
    out.push_back({static_cast<double>(i) / static_cast<double>(values.samples),
                   values.numbers[0] * random.uniform(-1.0, 1.0)});
  return of_points(std::move(out));
}

Expected<MadeShape> balls_along_curve(const ShapeArguments& values) {
  std::vector<FormulaInT> formulas;
  for (std::size_t i = 0; i < 3; ++i) {
    auto formula = FormulaInT::parse(values.formulas[i], std::array{"x", "y", "radius"}[i]);
    if (!formula) return std::unexpected(formula.error());
    formulas.push_back(*std::move(formula));
  }
  MadeShape out;
  const double from = values.numbers[0];
  const double step = (values.numbers[1] - from) / static_cast<double>(std::max<std::size_t>(values.samples, 2) - 1);
  for (std::size_t i = 0; i < values.samples; ++i) {
    const double t = from + step * static_cast<double>(i);
    const Disk ball{{formulas[0].at(t), formulas[1].at(t)}, formulas[2].at(t)};
    if (!is_finite(ball) || ball.radius < 0.0)
      return std::unexpected(
          Error{ErrorCode::bad_input, "the formulas give no ball of a finite size at t = " + std::to_string(t)});
    out.balls.push_back(ball);
  }
  return out;
}

Parameter whole(const char* id, const char* explanation, double value) {
  return {id, explanation, "", -1000.0, 1000.0, value, true};
}

constexpr std::size_t kUsual = 400;
constexpr std::size_t kFewPoints = 24;

}  // namespace

std::vector<ShapeDescriptor> point_shapes() {
  return {
      {"uniform",
       "Uniform points",
       "random points in a rectangle",
       {length_parameter("width", "Its width", 1.0), length_parameter("height", "Its height", 1.0)},
       {},
       kUsual,
       uniform},
      {"poisson-disk",
       "Poisson disk",
       "random points in the unit square, no two of them too close together",
       {{"share", "The least distance, where 1 is the side of an equal part of the area", "", 0.01, 0.75, 0.7}},
       {},
       kUsual,
       poisson_disk},
      {"gaussian",
       "Gaussian points",
       "points around the origin, ever sparser outwards",
       {length_parameter("sigma", "Standard deviation of each coordinate", 1.0)},
       {},
       kUsual,
       gaussian},
      {"clustered",
       "Clustered points",
       "clusters of points around random centres in the unit square",
       {{"clusters", "The number of clusters", "", 1.0, 10000.0, 8.0, true},
        length_parameter("sigma", "Standard deviation of each coordinate in a cluster", 0.03)},
       {},
       kUsual,
       clustered},
      {"square-lattice",
       "Square lattice",
       "rows and columns: every four points of a square are cocircular",
       {length_parameter("step", "Between neighbours", 1.0)},
       {},
       kUsual,
       square_lattice},
      {"hexagonal-lattice",
       "Hexagonal lattice",
       "rows shifted by half a step, up to rounding",
       {length_parameter("step", "Between neighbours", 1.0)},
       {},
       kUsual,
       hexagonal_lattice},
      {"cocircular",
       "Cocircular points",
       "points exactly on a circle about the origin",
       {},
       {},
       kFewPoints,
       cocircular},
      {"almost-cocircular",
       "Almost cocircular points",
       "points on the unit circle up to noise and rounding",
       {{"noise", "Largest distance from it", "", 0.0, 0.1, 1e-12}},
       {},
       kFewPoints,
       almost_cocircular},
      {"collinear",
       "Collinear points",
       "points exactly on a line",
       {whole("dx", "From point to point, to the right", 2.0), whole("dy", "From point to point, upwards", 1.0)},
       {},
       kFewPoints,
       collinear},
      {"almost-collinear",
       "Almost collinear points",
       "points on a line up to noise",
       {{"noise", "Largest distance from it", "", 0.0, 0.1, 1e-12}},
       {},
       kFewPoints,
       almost_collinear},
      {"balls-along-curve",
       "Balls along a curve",
       "balls whose centres and radii are formulas",
       {{"from", "The first t", "", -1e6, 1e6, 0.0}, {"to", "The last t", "", -1e6, 1e6, kTurn}},
       {{"x", "x of the centre as a formula of t", "t"},
        {"y", "y of the centre as a formula of t", "sin(t)"},
        {"radius", "The radius as a formula of t", "0.4 + 0.2*cos(3*t)"}},
       kFewPoints,
       balls_along_curve},
  };
}

}  // namespace mes
