// SPDX-License-Identifier: GPL-3.0-or-later
// Each shape against the equation that it solves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>

#include "core/document/commands.h"
#include "core/shapes/shape.h"

using namespace mes;

namespace {

constexpr double kPi = std::numbers::pi;

using Numbers = std::map<std::string, double>;
using Formulas = std::map<std::string, std::string>;

Expected<SampleData> tried(const std::string& id, const ShapeSampling& sampling = {}, const Numbers& numbers = {},
                           const Formulas& formulas = {}) {
  const ShapeDescriptor* const shape = find_shape(id);
  REQUIRE(shape != nullptr);
  ShapeValues values = values_of(*shape);
  std::size_t known = 0;
  for (const Parameter& parameter : shape->parameters)
    if (const auto found = numbers.find(parameter.id); found != numbers.end()) {
      values.numbers[parameter] = found->second;
      ++known;
    }
  for (std::size_t i = 0; i < shape->formulas.size(); ++i)
    if (const auto found = formulas.find(std::string(shape->formulas[i].id)); found != formulas.end()) {
      values.formulas[i] = found->second;
      ++known;
    }
  REQUIRE(known == numbers.size() + formulas.size());
  return make_shape(*shape, {values, sampling});
}

SampleData made(const std::string& id, const ShapeSampling& sampling = {}, const Numbers& numbers = {},
                const Formulas& formulas = {}) {
  auto out = tried(id, sampling, numbers, formulas);
  INFO(id << ": " << (out ? std::string() : out.error().text));
  REQUIRE(out.has_value());
  return *std::move(out);
}

template <class Rest>
void check_zero(const SampleData& data, double tolerance, Rest rest) {
  REQUIRE(data.positions.size() > 10);
  double worst = 0.0;
  for (const Vec2 p : data.positions) worst = std::max(worst, std::abs(rest(p)));
  CHECK(worst <= tolerance);
}

double length_of(const SampleData& data, std::size_t contour = 0) {
  double out = 0.0;
  const auto& points = data.contours.at(contour).points;
  for (std::size_t i = 0; i + (data.contours[contour].closed ? 0 : 1) < points.size(); ++i)
    out += distance(data.positions[points[i]], data.positions[points[(i + 1) % points.size()]]);
  return out;
}

/// Pixels of a circle of integers.
std::int64_t unscaled(double x) {
  const double out = std::ldexp(x, 25);
  CHECK(out == std::trunc(out));
  return static_cast<std::int64_t>(out);
}

}  // namespace

TEST_CASE("every shape is made with its defaults, the same each time, and fits into a document") {
  REQUIRE(shapes().size() == 25);
  std::set<std::string_view> ids;
  for (const ShapeDescriptor& shape : shapes()) {
    INFO(shape.id);
    CHECK(ids.insert(shape.id).second);
    const SampleData data = made(std::string(shape.id));
    const SampleData again = made(std::string(shape.id));
    CHECK(data.positions == again.positions);
    CHECK(data.contours == again.contours);
    CHECK(data.balls == again.balls);
    CHECK(data.positions.empty() != data.balls.empty());
    Document document;
    CHECK(replace_all(document, data).has_value());
    for (const Parameter& parameter : shape.parameters) {
      CHECK(parameter.low <= parameter.default_value);
      CHECK(parameter.default_value <= parameter.high);
    }
    // Number, jitter and seed.
    const std::size_t few = 24;
    const SampleData asked = made(std::string(shape.id), {.samples = few});
    if (shape.points != 0) CHECK(asked.positions.size() + asked.balls.size() == few);
    const SampleData moved = made(std::string(shape.id), {.samples = few, .jitter = 0.1, .seed = 5});
    if (!asked.balls.empty()) {
      CHECK(moved.balls != asked.balls);
      CHECK(moved.balls == made(std::string(shape.id), {.samples = few, .jitter = 0.1, .seed = 5}).balls);
      for (std::size_t i = 0; i < few; ++i) CHECK(moved.balls[i].radius == asked.balls[i].radius);
    }
    if (!asked.positions.empty()) {
      CHECK(moved.positions != asked.positions);
      CHECK(moved.positions.size() == asked.positions.size());
      CHECK(moved.positions == made(std::string(shape.id), {.samples = few, .jitter = 0.1, .seed = 5}).positions);
      CHECK(moved.positions != made(std::string(shape.id), {.samples = few, .jitter = 0.1, .seed = 6}).positions);
    }
  }
  CHECK(find_shape("no-shape") == nullptr);
}

TEST_CASE("circles, ellipses and what is made of arcs lie where their equations are zero") {
  check_zero(made("circle", {}, {{"radius", 3.0}}), 1e-14, [](Vec2 p) { return length(p) - 3.0; });
  check_zero(made("ellipse", {.samples = 200}, {{"a", 5.0}, {"b", 2.0}}), 1e-14,
             [](Vec2 p) { return p.x * p.x / 25.0 + p.y * p.y / 4.0 - 1.0; });
  const auto from_box = [](double half_width, double half_height) {
    return [=](Vec2 p) {
      return length({std::max(std::abs(p.x) - half_width, 0.0), std::max(std::abs(p.y) - half_height, 0.0)});
    };
  };
  check_zero(made("stadium", {}, {{"half-length", 2.0}, {"radius", 0.5}}), 1e-14,
             [&](Vec2 p) { return from_box(2.0, 0.0)(p) - 0.5; });
  check_zero(made("rounded-rectangle", {}, {{"width", 6.0}, {"height", 3.0}, {"radius", 0.75}}), 1e-14,
             [&](Vec2 p) { return from_box(2.25, 0.75)(p) - 0.75; });
  const SampleData annulus = made("annulus", {.spacing = 0.05}, {{"shift", 0.5}});
  REQUIRE(annulus.contours.size() == 2);
  check_zero(annulus, 1e-14, [](Vec2 p) {
    return std::min(std::abs(length(p) - 2.0), std::abs(distance(p, {0.5, 0.0}) - 1.0));
  });
  CHECK(length_of(annulus, 0) == Approx(4.0 * kPi).epsilon(1e-3));
  CHECK(length_of(annulus, 1) == Approx(2.0 * kPi).epsilon(1e-3));
}

TEST_CASE("shapes with corners have these as samples, and the perimeter of their formula") {
  const SampleData star = made("star", {.samples = 500}, {{"points", 7.0}, {"outer", 2.0}, {"inner", 1.0}});
  std::size_t tips = 0;
  for (const Vec2 p : star.positions) tips += std::abs(length(p) - 2.0) < 1e-12 ? 1U : 0U;
  CHECK(tips == 7);
  const double side = std::sqrt(4.0 + 1.0 - 4.0 * std::cos(kPi / 7.0));
  CHECK(length_of(star) == Approx(14.0 * side).epsilon(1e-12));
  CHECK(length_of(made("polygon", {}, {{"corners", 6.0}})) == Approx(6.0).epsilon(1e-12));
  // Arcs of half the circles, and twenty sides of a fifth.
  CHECK(length_of(made("gear", {.samples = 20000}, {{"teeth", 10.0}})) ==
        Approx(kPi * 1.0 + kPi * 0.8 + 20 * 0.2).epsilon(1e-6));
  // Around teeth and gaps: up and down each tooth, and once along the beam above and below.
  CHECK(length_of(made("comb")) == Approx(2.0 * (8 * 0.2 + 7 * 0.1) + 2.0 * 0.4 + 16 * 1.0).epsilon(1e-12));
  CHECK(tried("star", {}, {{"inner", 2.0}}).error().code == ErrorCode::usage);
  CHECK(tried("gear", {}, {{"inner", 1.0}}).error().code == ErrorCode::usage);
}

TEST_CASE("curves of a function lie on it") {
  check_zero(made("superellipse", {.samples = 300}, {{"n", 4.0}}), 1e-8,
             [](Vec2 p) { return std::pow(p.x / 2.0, 4) + std::pow(p.y, 4) - 1.0; });
  // Corners of a rhombus.
  check_zero(made("superellipse", {.samples = 300}, {{"n", 1.0}}), 1e-8,
             [](Vec2 p) { return std::abs(p.x / 2.0) + std::abs(p.y) - 1.0; });
  check_zero(made("spiral", {.samples = 300}), 1e-8, [](Vec2 p) {
    const double turns = length(p) - 0.2 - std::atan2(p.y, p.x) / (2.0 * kPi);
    return turns - std::round(turns);
  });
  CHECK_FALSE(made("spiral").contours.at(0).closed);
  // Eight times the radius for each cusp of a cycloid: 8 r (k + 1) in all.
  CHECK(length_of(made("epicycloid", {.samples = 5000}, {{"reach", 1.0}})) == Approx(8.0 * 6.0).epsilon(1e-4));
  check_zero(made("polar", {}, {}, {{"r", "2"}}), 1e-9, [](Vec2 p) { return length(p) - 2.0; });
  const SampleData parabola =
      made("curve", {.samples = 100}, {{"from", -1.0}, {"to", 2.0}}, {{"x", "t"}, {"y", "t^2"}});
  check_zero(parabola, 1e-9, [](Vec2 p) { return p.y - p.x * p.x; });
  CHECK_FALSE(parabola.contours.at(0).closed);
  CHECK(made("curve").contours.at(0).closed);
}

TEST_CASE("formulas that are not understood are refused with their name") {
  for (const std::string& text :
       std::vector<std::string>{"", "  ", "1 +", "sin(", "foo(t)", "u", "1, 2", "t t", std::string(2000, '1')}) {
    INFO(text);
    const auto formula = tried("polar", {}, {}, {{"r", text}});
    REQUIRE_FALSE(formula.has_value());
    CHECK(formula.error().code == ErrorCode::usage);
    CHECK_THAT(formula.error().text, Catch::StartsWith("the formula of r: "));
    CHECK(formula.error().text.find('\n') == std::string::npos);
    CHECK_FALSE(formula.error().text.ends_with('.'));
  }
  const auto wrong = tried("polar", {}, {}, {{"r", "sqrt(t - 1)"}});
  REQUIRE_FALSE(wrong.has_value());
  CHECK(wrong.error().code == ErrorCode::bad_input);
  CHECK(wrong.error().text == "the formula gives no finite number at t = 0");
  CHECK(tried("polar", {}, {{"from", 1.0}, {"to", 1.0}}).error().code == ErrorCode::usage);
  CHECK(tried("balls-along-curve", {}, {}, {{"radius", "-1"}}).error().code == ErrorCode::bad_input);
}

TEST_CASE("degenerate points are so exactly") {
  const SampleData circle = made("cocircular", {.samples = 2916});
  constexpr std::int64_t kRadius = 5LL * 13 * 17 * 29 * 37 * 41;
  std::set<std::pair<double, double>> different;
  for (const Vec2 p : circle.positions) {
    const std::int64_t x = unscaled(p.x);
    const std::int64_t y = unscaled(p.y);
    CHECK(x * x + y * y == kRadius * kRadius);
    different.insert({p.x, p.y});
  }
  CHECK(different.size() == 2916);
  CHECK(tried("cocircular", {.samples = 2917}).error().code == ErrorCode::usage);
  const SampleData line = made("collinear", {.samples = 100}, {{"dx", 7.0}, {"dy", -3.0}});
  for (std::size_t i = 0; i < 100; ++i)
    CHECK(line.positions[i] == Vec2{7.0 * static_cast<double>(i), -3.0 * static_cast<double>(i)});
  CHECK(tried("collinear", {}, {{"dx", 0.0}, {"dy", 0.0}}).error().code == ErrorCode::usage);
  check_zero(made("almost-cocircular", {}, {{"noise", 1e-3}}), 1e-3, [](Vec2 p) { return length(p) - 1.0; });
  check_zero(made("almost-collinear", {}, {{"noise", 1e-3}}), 1e-3, [](Vec2 p) { return p.y; });
}

TEST_CASE("random points have the distribution of their name") {
  const std::size_t n = 4000;
  const SampleData uniform = made("uniform", {.samples = n, .seed = 3}, {{"width", 2.0}});
  Vec2 mean;
  for (const Vec2 p : uniform.positions) {
    CHECK((p.x >= 0.0 && p.x < 2.0 && p.y >= 0.0 && p.y < 1.0));
    mean = mean + (1.0 / n) * p;
  }
  CHECK(std::abs(mean.x - 1.0) < 0.05);  // five standard deviations
  CHECK(std::abs(mean.y - 0.5) < 0.025);
  double square = 0.0;
  for (const Vec2 p : made("gaussian", {.samples = n}, {{"sigma", 3.0}}).positions) square += dot(p, p) / n;
  CHECK(square == Approx(18.0).epsilon(0.08));
  const SampleData disks = made("poisson-disk", {.samples = 1000});
  double least = 1.0;
  for (std::size_t i = 0; i < 1000; ++i)
    for (std::size_t k = 0; k < i; ++k) least = std::min(least, distance(disks.positions[i], disks.positions[k]));
  CHECK(least >= 0.7 / std::sqrt(1000.0));
  CHECK(least < 0.71 / std::sqrt(1000.0));
  CHECK(made("uniform", {.seed = 1}).positions != made("uniform", {.seed = 2}).positions);
}

TEST_CASE("lattices have rows and columns") {
  const SampleData square = made("square-lattice", {.samples = 12}, {{"step", 0.5}});
  CHECK(square.positions[0] == Vec2{0.0, 0.0});
  CHECK(square.positions[11] == Vec2{1.5, 1.0});
  const SampleData hexagonal = made("hexagonal-lattice", {.samples = 9});
  for (const std::size_t neighbour : {1U, 3U})
    CHECK(distance(hexagonal.positions[0], hexagonal.positions[neighbour]) == Approx(1.0));
  CHECK(hexagonal.positions[3].x == 0.5);
}

TEST_CASE("wishes that make no sense are refused") {
  CHECK(tried("circle", {.samples = 5, .spacing = 1.0}).error().code == ErrorCode::usage);
  CHECK(tried("circle", {.samples = 0}).error().code == ErrorCode::usage);
  CHECK(tried("circle", {.spacing = 0.0}).error().code == ErrorCode::usage);
  CHECK(tried("circle", {.spacing = 1e-9}).error().code == ErrorCode::bad_input);
  CHECK(tried("circle", {.jitter = -1.0}).error().code == ErrorCode::usage);
  CHECK(tried("uniform", {.spacing = 1.0}).error().code == ErrorCode::usage);
  CHECK(tried("annulus", {}, {{"inner", 2.0}}).error().code == ErrorCode::usage);
  CHECK(tried("rounded-rectangle", {}, {{"radius", 1.5}}).error().code == ErrorCode::usage);
}
