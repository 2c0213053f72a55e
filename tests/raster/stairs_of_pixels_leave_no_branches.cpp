// SPDX-License-Identifier: GPL-3.0-or-later
// From pixels to the medial axis: ellipses and rings, whose axes are a segment and a circle, rendered in two values and
// with soft edges.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/curves/sampling.h"
#include "core/raster/trace.h"
#include "tests/raster/rendered.h"
#include "tests/support/axis_picture.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

Workbench traced_bench(const GrayImage& image) {
  const auto tracing = trace(image, {});
  REQUIRE(tracing.has_value());
  const auto samples = sample(tracing->curves, sampling_of_tracing());
  REQUIRE(samples.has_value());
  return Workbench(samples->positions);
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
      const Workbench bench = traced_bench(image);
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
    const Workbench bench = traced_bench(rendered(300, 300, fine, [&](Vec2 p) {
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
