// SPDX-License-Identifier: GPL-3.0-or-later
// From pixels to the medial axis: ellipses and rings, whose axes are a segment and a circle, rendered in two values and
// with soft edges.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/curves/sampling.h"
#include "core/raster/trace.h"
#include "tests/raster/rendered.h"
#include "tests/support/axis_picture.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// About normal: the sum of twelve uniform numbers.
double grain(Rng& random) {
  double out = -6.0;
  for (int i = 0; i < 12; ++i) out += random.uniform();
  return out;
}

ComparedBench traced_bench(const GrayImage& image) {
  const auto tracing = trace(image, {});
  REQUIRE(tracing.has_value());
  const auto samples = sample(tracing->curves, sampling_of_tracing(tracing->curves));
  REQUIRE(samples.has_value());
  return ComparedBench(samples->positions);
}

}  // namespace

TEST_CASE("the axis of a traced ellipse is one stroke") {
  for (const int fine : {1, 16})
    for (const double angle : {0.0, 0.2, 0.6}) {
      constexpr double kLong = 180.0;
      constexpr double kShort = 90.0;
      const Vec2 center{200.31, 199.77};
      const Vec2 along{std::cos(angle), std::sin(angle)};
      const GrayImage image = rendered(400, 400, fine, [&](Vec2 p) {
        const double x = dot(p - center, along) / kLong;
        const double y = cross(along, p - center) / kShort;
        return x * x + y * y <= 1.0;
      });
      INFO("fine " << fine << ", angle " << angle);
      const ComparedBench bench = traced_bench(image);
      CHECK(bench.count("one-step-crust", "odd_samples") == 0);
      const AxisPicture axis = axis_picture(bench.instances("medial-axis", PrimitiveKind::segment), 0.0);
      CHECK(axis.components == 1);
      CHECK(axis.cycles() == 0);
      // The true one ends at the centres of curvature of the ends; a branch would leave it, or end elsewhere.
      const double half = kLong - kShort * kShort / kLong;
      CHECK(axis.nodes.size() > 300);
      for (const AxisPicture::Node& node : axis.nodes) {
        CHECK(std::abs(cross(along, node.position - center)) < 0.5);
        if (node.degree == 1) CHECK(std::abs(std::abs(dot(node.position - center, along)) - half) < 3.0);
      }
    }
}

TEST_CASE("the axis of a traced ring is one circle without a branch") {
  for (const int fine : {1, 16}) {
    const Vec2 center{150.2, 149.6};
    const ComparedBench bench = traced_bench(rendered(300, 300, fine, [&](Vec2 p) {
      const double away = distance(p, center);
      return away >= 70.0 && away <= 130.0;
    }));
    INFO("fine " << fine);
    const AxisPicture axis = axis_picture(bench.instances("medial-axis", PrimitiveKind::segment), 0.0);
    CHECK(axis.cycles() == 1);
    CHECK(axis.with_degree(1).empty());
    CHECK(axis.length == Approx(200.0 * 3.14159265358979).epsilon(0.002));
  }
}

TEST_CASE("the axis of an ellipse in a noisy photograph under uneven light is one stroke") {
  constexpr double kLong = 180.0;
  constexpr double kShort = 90.0;
  const Vec2 center{200.31, 199.77};
  GrayImage image = rendered(400, 400, 4, [&](Vec2 p) {
    const double x = (p.x - center.x) / kLong;
    const double y = (p.y - center.y) / kShort;
    return x * x + y * y <= 1.0;
  });
  Rng random(7);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t& value = image.values[static_cast<std::size_t>(y) * 400 + static_cast<std::size_t>(x)];
      const double light = 150.0 + 30.0 * x / 400.0;
      value = static_cast<std::uint8_t>(std::clamp(light - 70.0 * value / 255.0 + 9.0 * grain(random), 0.0, 255.0));
    }
  const auto tracing = trace(image, {});
  REQUIRE(tracing);
  CHECK(tracing->counts.blur > 2.0);
  CHECK(tracing->curves.curves.size() == 1);
  CHECK(tracing->counts.specks + tracing->counts.pinholes == 0);
  const auto samples = sample(tracing->curves, sampling_of_tracing(tracing->curves));
  REQUIRE(samples);
  for (const Vec2 p : samples->positions)
    CHECK(std::abs(std::hypot((p.x - center.x) / kLong, (p.y - center.y) / kShort) - 1.0) < 1.5 / kShort);
  const ComparedBench bench(samples->positions);
  CHECK(bench.count("one-step-crust", "odd_samples") == 0);
  const AxisPicture axis = axis_picture(bench.instances("medial-axis", PrimitiveKind::segment), 0.0);
  CHECK(axis.components == 1);
  CHECK(axis.cycles() == 0);
}

// Strokes of two pixels in noise whose grains reach the level nowhere, and in noise that breaks them.
TEST_CASE("thin strokes in a noisy picture keep their width") {
  for (const double noise : {3.0, 9.0, 12.0, 20.0}) {
    for (const int period : {5, 20}) {
      INFO("noise " << noise << ", every " << period << " pixels");
      GrayImage image{200, 200, std::vector<std::uint8_t>(200 * 200)};
      Rng random(3);
      std::size_t dark = 0;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          const bool is_stroke = x % period == 2 || x % period == 3;
          const bool is_inside = 10 <= y && y < 190 && 5 <= x && x < 185;
          dark += is_stroke && is_inside ? 1 : 0;
          image.values[static_cast<std::size_t>(y) * 200 + static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(
              std::clamp((is_stroke && is_inside ? 60.0 : 200.0) + noise * grain(random), 0.0, 255.0));
        }
      const auto tracing = trace(image, {});
      REQUIRE(tracing.has_value());
      CHECK(tracing->counts.blur == 0.0);
      CHECK(tracing->curves.curves.size() == static_cast<std::size_t>(180 / period));
      double area = 0.0;
      for (const PlaneCurve& curve : tracing->curves.curves) {
        double twice = 0.0;
        curve.for_each_piece([&](const Piece& piece) { twice += cross(piece.from(), piece.to()); });
        area += 0.5 * std::abs(twice);
      }
      CHECK(std::abs(area - static_cast<double>(dark)) < 0.05 * static_cast<double>(dark));
    }
  }
}
