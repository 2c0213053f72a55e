// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and numbers of contours where these are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/glyphs/internal/united_contours.h"

using namespace mes;

namespace {

PlaneCurve square(Vec2 corner, double side, bool is_hole = false) {
  PlaneCurve out(corner);
  const Vec2 right{corner.x + side, corner.y};
  const Vec2 above{corner.x, corner.y + side};
  out.line_to(is_hole ? above : right);
  out.line_to({corner.x + side, corner.y + side});
  out.line_to(is_hole ? right : above);
  out.close();
  return out;
}

/// Four cubic pieces, off the circle by 3e-4 of its radius at most.
PlaneCurve circle(Vec2 center, double radius) {
  constexpr double kHandle = 0.5522847498;
  PlaneCurve out(center + Vec2{radius, 0});
  Vec2 along{radius, 0};
  for (int i = 0; i < 4; ++i) {
    const Vec2 next = perpendicular(along);
    out.cubic_to(center + along + kHandle * next, center + next + kHandle * along, center + next);
    along = next;
  }
  out.close();
  return out;
}

double area_of(const std::vector<PlaneCurve>& curves) {
  double twice = 0.0;
  for (const PlaneCurve& curve : curves)
    curve.for_each_piece([&](const Piece& piece) {
      constexpr int kSteps = 1000;
      for (int i = 0; i < kSteps; ++i) twice += cross(piece.at(i / 1000.0), piece.at((i + 1) / 1000.0));
    });
  return 0.5 * std::abs(twice);
}

std::size_t corners_of(const std::vector<PlaneCurve>& curves) {
  std::size_t out = 0;
  for (const PlaneCurve& curve : curves) out += curve.piece_count();
  return out;
}

}  // namespace

TEST_CASE("contours that do not meet stay as they are, to the last bit") {
  // A hole keeps its place too, and coordinates finer than the grid of the union are kept.
  const std::vector<PlaneCurve> before{circle({0.1, 0.2}, 100.0 / 3), square({-10, -10}, 20, true),
                                       square({-3, -3}, 6), circle({200, 0}, 50)};
  const std::vector<PlaneCurve> after = united_contours(before, 0.05);
  REQUIRE(after.size() == before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    REQUIRE(after[i].piece_count() == before[i].piece_count());
    std::vector<Piece> pieces;
    before[i].for_each_piece([&](const Piece& piece) { pieces.push_back(piece); });
    std::size_t k = 0;
    after[i].for_each_piece([&](const Piece& piece) {
      CHECK(piece.kind == pieces[k].kind);
      CHECK(piece.points == pieces[k].points);
      ++k;
    });
  }
}

TEST_CASE("contours that cross become one with the area of their union") {
  const auto squares = united_contours({square({0, 0}, 10), square({5, 5}, 10)}, 0.05);
  CHECK(squares.size() == 1);
  CHECK(corners_of(squares) == 8);
  CHECK(area_of(squares) == Approx(175.0).epsilon(1e-12));

  const double r = 100.0;
  const auto circles = united_contours({circle({0, 0}, r), circle({r, 0}, r)}, 0.001);
  CHECK(circles.size() == 1);
  const double lens = r * r * (2.0 * std::numbers::pi / 3.0 - std::sqrt(3.0) / 2.0);
  CHECK(area_of(circles) == Approx(2.0 * std::numbers::pi * r * r - lens).epsilon(1e-3));
}

TEST_CASE("a ring of overlapping bars keeps its hole, and others keep their curves") {
  const auto bar = [](double x, double y, double width, double height) {
    PlaneCurve out({x, y});
    out.line_to({x + width, y});
    out.line_to({x + width, y + height});
    out.line_to({x, y + height});
    out.close();
    return out;
  };
  const auto united = united_contours(
      {bar(0, 0, 100, 10), circle({300, 0}, 20), bar(90, 0, 10, 100), bar(0, 90, 100, 10), bar(0, 0, 10, 100)}, 0.05);
  REQUIRE(united.size() == 3);
  CHECK_FALSE(united[0].is_polyline());
  CHECK(area_of({united[1], united[2]}) == Approx(100.0 * 100.0 - 80.0 * 80.0));
}

TEST_CASE("what lies within what is filled already is no boundary, and a contour that crosses itself is filled") {
  CHECK(united_contours({square({0, 0}, 10), square({2, 2}, 3)}, 0.05).size() == 1);
  CHECK(united_contours({square({0, 0}, 10), square({0, 0}, 10)}, 0.05).size() == 1);
  // A pentagram winds around its middle twice.
  std::vector<Vec2> tips;
  for (int i = 0; i < 5; ++i) {
    const double angle = std::numbers::pi * (0.5 + 0.8 * i);
    tips.push_back({1000 * std::cos(angle), 1000 * std::sin(angle)});
  }
  PlaneCurve star(tips[0]);
  for (int i = 1; i < 5; ++i) star.line_to(tips[static_cast<std::size_t>(i)]);
  star.close();
  const auto outline = united_contours({star}, 0.05);
  REQUIRE(outline.size() == 1);
  CHECK(corners_of(outline) == 10);
}

TEST_CASE("nothing, single points and lines make no contour") {
  CHECK(united_contours({}, 0.05).empty());
  PlaneCurve back_and_forth({0, 0});
  back_and_forth.line_to({10, 0});
  back_and_forth.close();
  CHECK(united_contours({back_and_forth}, 0.05).empty());
}

TEST_CASE("what contours become does not depend on those apart from them, and uniting can be stopped between parts") {
  // Some overlap along a diagonal, so that their boxes meet in chains; others do not.
  std::vector<PlaneCurve> all;
  std::vector<PlaneCurve> stay;
  std::vector<PlaneCurve> made;
  for (int i = 0; i < 12; ++i) {
    const Vec2 at{500.0 * (i % 4) + 0.3, 400.0 * (i / 4) + 0.7};
    const std::vector<PlaneCurve> part{circle(at, 100.0 / 3), circle(at + Vec2{40, 30}, 100.0 / 3),
                                       circle(at + Vec2{80, 60}, 100.0 / 3), circle(at + Vec2{200, 0}, 10)};
    all.insert(all.end(), part.begin(), part.end());
    const std::vector<PlaneCurve> united = united_contours(part, 0.05);
    REQUIRE(united.size() == 2);
    stay.push_back(united[0]);
    made.push_back(united[1]);
  }
  const auto points_of = [](const std::vector<PlaneCurve>& curves) {
    std::vector<Vec2> out;
    for (const PlaneCurve& curve : curves)
      curve.for_each_piece(
          [&](const Piece& piece) { out.insert(out.end(), piece.points.begin(), piece.points.end()); });
    return out;
  };
  std::vector<PlaneCurve> expected = stay;
  expected.insert(expected.end(), made.begin(), made.end());
  CHECK(points_of(united_contours(all, 0.05)) == points_of(expected));

  std::int64_t looks = 0;
  for (bool is_stopped = true; is_stopped; looks += is_stopped ? 1 : 0) {
    JobControl job;
    job.stop_at_look(looks + 1);
    try {
      static_cast<void>(united_contours(all, 0.05, &job));
      is_stopped = false;
    } catch (const Cancelled&) {
      is_stopped = true;
    }
  }
  // A look before each contour is cut up, and before each of the 24 parts.
  CHECK(looks == 48 + 24);
}
