// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>

#include "app/insight/center_line_run.h"
#include "app/store/texts/center_line_text.h"
#include "core/builtins/builtins.h"
#include "core/curves/curve.h"
#include "core/document/curve_source.h"

using namespace mes;

namespace {

/// A band of width 2 about y = height sin x, with walls at both ends.
SampleData data_of_band(double height) {
  constexpr int kSteps = 400;
  PlaneCurve outline({0.0, -1.0});
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i <= kSteps; ++i) {
      const double x = 20.0 * (side < 0.0 ? i : kSteps - i) / kSteps;
      outline.line_to({x, height * std::sin(x) + side});
    }
  outline.close();
  auto curves = std::make_shared<CurveSet>();
  curves->curves = {outline};
  SampleData data;
  for (const Vec2 corner : outline.points()) data.positions.push_back(corner);
  data.positions.pop_back();  // the first again
  for (const double x : {0.0, 20.0})
    for (double y = -0.95; y < 0.97; y += 0.05) data.positions.push_back({x, height * std::sin(x) + y});
  data.source = std::make_shared<const CurveSource>(CurveSource{.curves = std::move(curves)});
  return data;
}

}  // namespace

TEST_CASE("a centre line is written with the points that it needs, and their radii") {
  for (const double height : {0.0, 0.1, 0.6}) {
    INFO("height " << height);
    JobControl job;
    const auto found = CenterLineFinder(builtins()).find(data_of_band(height), {.is_exact = true}, job);
    REQUIRE(found.has_value());
    REQUIRE(found->lines.size() == 1);
    const CenterLine& line = found->lines.front();
    const TextLine written = text_line_of(line, std::nullopt, 1.0);
    REQUIRE(written.points.size() == written.radii.size());
    CHECK(written.points.front() == line.points.front().place);
    CHECK(written.points.back() == line.points.back().place);
    const std::vector<double> radii = radii_of(line);
    std::size_t piece = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Vec2 p = line.points[i].place;
      while (piece + 2 < written.points.size() && p == written.points[piece + 1]) ++piece;
      const Vec2 a = written.points[piece];
      const Vec2 along = written.points[piece + 1] - a;
      const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
      CHECK(distance(p, a + share * along) <= 1.001 * 0x1p-12 * radii[i]);
      const double radius = (1.0 - share) * written.radii[piece] + share * written.radii[piece + 1];
      CHECK(std::abs(radii[i] - radius) <= 1.001 * 0x1p-12 * radii[i]);
    }
    CHECK(line.points.size() > 50);
    if (height == 0.0) CHECK(written.points.size() == 2);
    if (height == 0.6) CHECK(written.points.size() > 20);
  }
}

TEST_CASE("a finder has the lines of one set of samples, whatever it looked at before") {
  JobControl job;
  CenterLineFinder finder(builtins());
  SampleData nothing;
  nothing.positions = {{1.0, 2.0}, {3.0, 4.0}};
  for (const double height : {0.6, 0.0, 0.3, 0.6})
    for (const bool is_exact : {true, false, false}) {
      CAPTURE(height, is_exact);
      const SampleData data = data_of_band(height);
      const auto found = finder.find(data, {.is_exact = is_exact}, job);
      const auto alone = CenterLineFinder(builtins()).find(data, {.is_exact = is_exact}, job);
      REQUIRE(found.has_value());
      REQUIRE(alone.has_value());
      REQUIRE(found->lines.size() == 1);
      REQUIRE(alone->lines.size() == 1);
      CHECK(found->lines.front().axis == alone->lines.front().axis);
      CHECK(std::ranges::equal(found->lines.front().points, alone->lines.front().points, {},
                               &CenterLine::Point::place, &CenterLine::Point::place));
      CHECK_FALSE(finder.find(nothing, {.is_exact = is_exact}, job).has_value());
    }
}
