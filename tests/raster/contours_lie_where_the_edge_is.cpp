// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures rendered of shapes with a formula: where their contours are, and how many.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/curves/sampling.h"
#include "core/raster/contours.h"
#include "core/raster/trace.h"
#include "tests/raster/rendered.h"

using namespace mes;

namespace {

Tracing traced(const GrayImage& image, const TraceRequest& request = {}) {
  auto out = trace(image, request);
  INFO((out ? std::string() : out.error().text));
  REQUIRE(out.has_value());
  return *std::move(out);
}

/// A hundredth of a pixel apart or less, where pieces are short; along half an ellipse a thousand.
std::vector<Vec2> points_of(const PlaneCurve& curve) {
  std::vector<Vec2> out;
  curve.for_each_piece([&](const Piece& piece) {
    const int parts = piece.kind == PieceKind::arc ? 1000 : 50;
    for (int i = 1; i < parts; ++i) out.push_back(piece.at(static_cast<double>(i) / parts));
    out.push_back(piece.to());
  });
  return out;
}

double area_of(const PlaneCurve& curve) {
  double out = 0.0;
  const std::vector<Vec2> points = points_of(curve);
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    out += 0.5 * cross(points[i] - points[0], points[i + 1] - points[0]);
  return out;
}

/// The points of all contours, in one order.
std::vector<Vec2> sorted_points(const PixelContours& contours) {
  std::vector<Vec2> out;
  for (const PixelContour& contour : contours.kept)
    out.insert(out.end(), contour.points.begin(), contour.points.end());
  std::ranges::sort(out, lexicographically_less);
  return out;
}

GrayImage noise(int width, int height, std::uint64_t seed, int values) {
  Rng random(seed);
  GrayImage out{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    out.values.push_back(static_cast<std::uint8_t>(random.below(static_cast<std::uint64_t>(values)) * 255 /
                                                   static_cast<std::uint64_t>(values - 1)));
  return out;
}

double farthest_from_circle(const PlaneCurve& curve, Vec2 center, double radius) {
  double out = 0.0;
  for (const Vec2 p : points_of(curve)) out = std::max(out, std::abs(distance(p, center) - radius));
  return out;
}

}  // namespace

TEST_CASE("the contour of a disk with soft edges is within a twentieth of a pixel of its circle") {
  for (const double radius : {10.0, 20.0, 50.0, 100.0}) {
    const int size = static_cast<int>(2 * radius) + 12;
    const Vec2 center{0.5 * size + 0.3137, 0.5 * size - 0.2713};
    const auto is_inside = [&](Vec2 p) { return distance(p, center) <= radius; };
    INFO("radius " << radius);
    const Tracing soft = traced(rendered(size, size, kFine, is_inside));
    REQUIRE(soft.curves.curves.size() == 1);
    CHECK_FALSE(soft.is_two_valued);
    CHECK(farthest_from_circle(soft.curves.curves[0], center, radius) < 0.05);
    // Of two values, half a pixel is all that the picture knows.
    const Tracing sharp = traced(rendered(size, size, 1, is_inside));
    REQUIRE(sharp.curves.curves.size() == 1);
    CHECK(sharp.is_two_valued);
    CHECK(farthest_from_circle(sharp.curves.curves[0], center, radius) < 0.25);
  }
}

TEST_CASE("a ring is an outline and a hole, each where its circle is") {
  const Vec2 center{60.2, 59.7};
  const Tracing ring = traced(rendered(120, 120, kFine, [&](Vec2 p) {
    const double away = distance(p, center);
    return away >= 25.0 && away <= 50.0;
  }));
  REQUIRE(ring.curves.curves.size() == 2);
  CHECK(farthest_from_circle(ring.curves.curves[0], center, 50.0) < 0.05);
  CHECK(farthest_from_circle(ring.curves.curves[1], center, 25.0) < 0.05);
  // The figure lies to the left of both.
  CHECK(area_of(ring.curves.curves[0]) == Approx(std::numbers::pi * 2500.0).epsilon(1e-3));
  CHECK(area_of(ring.curves.curves[1]) == Approx(-std::numbers::pi * 625.0).epsilon(1e-3));
}

TEST_CASE("a turned square has straight sides, and corners within a pixel") {
  for (const double angle : {0.0, 0.1, 0.4, std::numbers::pi / 4.0}) {
    const Vec2 center{80.3, 79.6};
    constexpr double kHalf = 50.0;
    const auto in_square = [&](Vec2 p) {
      const Vec2 d = p - center;
      return Vec2{std::cos(angle) * d.x + std::sin(angle) * d.y, std::cos(angle) * d.y - std::sin(angle) * d.x};
    };
    const Tracing square = traced(rendered(160, 160, kFine, [&](Vec2 p) {
      const Vec2 q = in_square(p);
      return std::max(std::abs(q.x), std::abs(q.y)) <= kHalf;
    }));
    INFO("angle " << angle);
    REQUIRE(square.curves.curves.size() == 1);
    double nearest_to_corner = 10.0;
    for (const Vec2 p : points_of(square.curves.curves[0])) {
      const Vec2 q = in_square(p);
      const Vec2 a{std::abs(q.x), std::abs(q.y)};
      nearest_to_corner = std::min(nearest_to_corner, distance(a, {kHalf, kHalf}));
      const bool is_near_corner = std::min(a.x, a.y) > kHalf - 6.0;
      CHECK(std::abs(std::max(a.x, a.y) - kHalf) < (is_near_corner ? 0.7 : 0.3));
    }
    CHECK(nearest_to_corner < 1.0);
  }
}

TEST_CASE("no edge is farther from its outline than is said, whatever the picture") {
  for (const int values : {2, 256}) {
    const GrayImage image = noise(90, 70, 5, values);
    TraceRequest request{.specks = 0.0};
    const Tracing smooth = traced(image, request);
    const PixelContours raw =
        contours_of(image, {.level = smooth.level, .is_figure_light = smooth.is_figure_light, .least_area = 0.0});
    REQUIRE(raw.kept.size() == smooth.curves.curves.size());
    CHECK(smooth.is_two_valued == (values == 2));
    double farthest = 0.0;
    for (std::size_t i = 0; i < raw.kept.size(); ++i) {
      const std::vector<Vec2> points = points_of(smooth.curves.curves[i]);
      for (const Vec2 p : raw.kept[i].points) {
        double away = 1e9;
        for (const Vec2 q : points) away = std::min(away, distance(p, q));
        farthest = std::max(farthest, away);
      }
    }
    CHECK(farthest <= kMostAway);
  }
}

TEST_CASE("light and dark exchanged, and rows and columns exchanged, give the same contours") {
  for (const int values : {2, 3, 256}) {
    const GrayImage image = noise(67, 130, 9, values);
    const ContourRequest request{.level = Level{100}, .is_figure_light = true};
    const PixelContours contours = contours_of(image, request);
    const PixelContours dark = contours_of(inverted(image), {.level = Level{154}, .is_figure_light = false});
    REQUIRE(dark.kept.size() == contours.kept.size());
    for (std::size_t i = 0; i < dark.kept.size(); ++i) CHECK(dark.kept[i].points == contours.kept[i].points);

    PixelContours turned = contours_of(transposed(image), request);
    REQUIRE(turned.kept.size() == contours.kept.size());
    for (PixelContour& contour : turned.kept)
      for (Vec2& p : contour.points) p = {130.0 - (130.0 - 67.0) - p.y, 130.0 - p.x};
    const std::vector<Vec2> expected = sorted_points(contours);
    std::vector<Vec2> found = sorted_points(turned);
    REQUIRE(found.size() == expected.size());
    for (const Vec2 p : found) {
      const auto from = std::ranges::lower_bound(expected, p.x - 1e-9, {}, &Vec2::x);
      CHECK(std::any_of(from, expected.end(), [&](Vec2 q) { return distance(p, q) < 1e-9; }));
    }
  }
}

TEST_CASE("contours part the pixels as counting them does") {
  // Components of pixels that touch in a corner, and of the others that touch in a side, by flooding.
  constexpr int kSide = 40;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const GrayImage image = noise(kSide, kSide, seed, 2);
    const PixelContours contours = contours_of(image, {});
    const auto is_light = [&](int x, int y) {
      return x >= 0 && y >= 0 && x < kSide && y < kSide && image.at(x, y) > 127;
    };
    constexpr int kWide = kSide + 2;
    std::vector<bool> seen(kWide * kWide, false);
    std::size_t figures = 0;
    std::size_t grounds = 0;
    for (int start = 0; start < kWide * kWide; ++start) {
      if (seen[static_cast<std::size_t>(start)]) continue;
      const bool light = is_light(start % kWide - 1, start / kWide - 1);
      ++(light ? figures : grounds);
      std::vector<int> open{start};
      seen[static_cast<std::size_t>(start)] = true;
      while (!open.empty()) {
        const int at = open.back();
        open.pop_back();
        for (int dx = -1; dx <= 1; ++dx)
          for (int dy = -1; dy <= 1; ++dy) {
            const int x = at % kWide + dx;
            const int y = at / kWide + dy;
            if (x < 0 || y < 0 || x >= kWide || y >= kWide || (!light && dx != 0 && dy != 0)) continue;
            const auto next = static_cast<std::size_t>(y * kWide + x);
            if (seen[next] || is_light(x - 1, y - 1) != light) continue;
            seen[next] = true;
            open.push_back(static_cast<int>(next));
          }
      }
    }
    const auto outlines = std::ranges::count_if(contours.kept, [](const PixelContour& c) { return c.area > 0.0; });
    INFO("seed " << seed);
    CHECK(static_cast<std::size_t>(outlines) == figures);
    CHECK(contours.kept.size() - static_cast<std::size_t>(outlines) == grounds - 1);  // all but the outside are holes
    // Corners are cut by half a square of a pixel, so the areas add up to the pixels within an eighth for each point.
    double area = 0.0;
    std::size_t points = 0;
    for (const PixelContour& contour : contours.kept) {
      area += contour.area;
      points += contour.points.size();
    }
    const auto pixels = static_cast<double>(std::ranges::count(image.values, std::uint8_t{255}));
    CHECK(std::abs(area - pixels) <= 0.125 * static_cast<double>(points));
  }
}

TEST_CASE("where a cell can be joined either way, the values decide") {
  // Bilinear interpolation is 128 in the middle of the first, and 127 in that of the second.
  const auto contours = [](std::vector<std::uint8_t> values) {
    return contours_of({2, 2, std::move(values)}, {.level = Level{127}}).kept.size();
  };
  CHECK(contours({200, 56, 56, 200}) == 1);
  CHECK(contours({198, 56, 56, 198}) == 2);
  CHECK(contours({255, 0, 0, 255}) == 1);  // equal claims: the figure stays in one piece
}

TEST_CASE("what reaches the edge of the picture is cut along it") {
  const GrayImage all{3, 2, std::vector<std::uint8_t>(6, 255)};
  const PixelContours contours = contours_of(all, {});
  REQUIRE(contours.kept.size() == 1);
  for (const Vec2 p : contours.kept[0].points) CHECK((p.x == 0.0 || p.x == 3.0 || p.y == 0.0 || p.y == 2.0));
  CHECK(contours.kept[0].area == Approx(6.0 - 4 * 0.125));
  CHECK(contours_of({}, {}).kept.empty());
}

TEST_CASE("rows far from the left, and of every width, are seen") {
  for (int width = 1; width <= 200; ++width) {
    GrayImage image{width, 1, std::vector<std::uint8_t>(static_cast<std::size_t>(width), 0)};
    for (int x = 0; x < width; x += 2) image.values[static_cast<std::size_t>(x)] = 255;
    CHECK(contours_of(image, {}).kept.size() == static_cast<std::size_t>((width + 1) / 2));
  }
}

TEST_CASE("specks and pinholes are left out and counted") {
  // A disk with a hole of radius 2 and three specks of one, four and nine pixels.
  GrayImage image = rendered(100, 100, 1, [](Vec2 p) {
    const double away = distance(p, {50, 50});
    return away <= 30.0 && away >= 2.0;
  });
  for (const auto& [x, size] : {std::pair{2, 1}, {10, 2}, {20, 3}})
    for (int i = 0; i < size * size; ++i)
      image.values[static_cast<std::size_t>((2 + i / size) * 100 + x + i % size)] = 255;
  const Tracing found = traced(image);
  CHECK(found.curves.curves.size() == 1);
  CHECK(found.counts.specks == 3);
  CHECK(found.counts.pinholes == 1);
  CHECK(found.speck_size == 16.0);
  CHECK(remark_of(found) ==
        "traced all pixels lighter than grey value 127; left out: 3 specks and 1 hole smaller than 16 square pixels");
  const Tracing more = traced(image, {.specks = 5.0});
  CHECK(more.curves.curves.size() == 3);
  CHECK(more.counts.specks == 2);
  CHECK(more.counts.pinholes == 0);
  CHECK(traced(image, {.specks = 0.0}).curves.curves.size() == 5);
}

TEST_CASE("the threshold of Otsu parts two heaps, and is exchanged with light and dark") {
  Histogram two{};
  two[40] = 100;
  two[90] = 30;
  CHECK(otsu_level(two) == Level{64});  // halfway, to within one
  Rng random(3);
  for (int round = 0; round < 50; ++round) {
    Histogram histogram{};
    for (int i = 0; i < 5; ++i) histogram[random.below(256)] += random.below(1000);
    Histogram exchanged = histogram;
    std::ranges::reverse(exchanged);
    const auto level = otsu_level(histogram);
    if (!level) continue;
    const int other = 254 - otsu_level(exchanged)->below;
    CHECK(std::abs(other - level->below) <= 1);
    // By its definition: no level has a larger variance between the classes.
    const auto variance = [&](int below) {
      double n[2] = {0, 0};
      double s[2] = {0, 0};
      for (int v = 0; v < 256; ++v) {
        n[v > below] += static_cast<double>(histogram[static_cast<std::size_t>(v)]);
        s[v > below] += v * static_cast<double>(histogram[static_cast<std::size_t>(v)]);
      }
      if (n[0] == 0 || n[1] == 0) return 0.0;
      const double gap = s[0] / n[0] - s[1] / n[1];
      return n[0] * n[1] * gap * gap;
    };
    for (int below = 0; below < 255; ++below) CHECK(variance(below) <= variance(level->below) * (1.0 + 1e-12));
  }
  Histogram one{};
  one[7] = 5;
  CHECK_FALSE(otsu_level(one).has_value());
}

TEST_CASE("the figure is what the border of the picture is not") {
  const auto disk = [](Vec2 p) { return distance(p, {20, 20}) <= 12.0; };
  const GrayImage light = rendered(40, 40, kFine, disk);
  CHECK(traced(light).is_figure_light);
  CHECK_FALSE(traced(inverted(light)).is_figure_light);
  CHECK(points_of(traced(light).curves.curves[0]) == points_of(traced(inverted(light)).curves.curves[0]));
  CHECK(traced(light, {.figure = FigureSide::dark}).curves.curves.size() == 2);
}

TEST_CASE("a picture without a figure is refused in one line") {
  const auto refusal = [](const GrayImage& image, const TraceRequest& request = {}) {
    const auto out = trace(image, request);
    REQUIRE_FALSE(out.has_value());
    return out.error().text;
  };
  const GrayImage gray{30, 30, std::vector<std::uint8_t>(900, 77)};
  CHECK(refusal(gray) == "no figure stands out: every pixel has the grey value 77");
  CHECK(refusal(gray, {.threshold = 100}) == "no figure stands out: nothing is lighter than grey value 100");
  GrayImage dot = gray;
  dot.values[300] = dot.values[301] = 200;
  CHECK(refusal(dot) ==
        "no figure stands out: there are only specks lighter than grey value 138, the largest of 1.5 square pixels; "
        "specks are figures below 16");
  // In a picture that was reduced to a quarter.
  CHECK_THAT(refusal(dot, {.pixel_area = 16.0}),
             Catch::EndsWith("the largest of 24 square pixels; specks are figures below 256"));
  // A small picture has small figures.
  GrayImage small{8, 8, std::vector<std::uint8_t>(64, 255)};
  for (const int y : {3, 4})
    for (const int x : {2, 3, 4, 5}) small.values[static_cast<std::size_t>(8 * y + x)] = 0;
  CHECK(traced(small).curves.curves.size() == 1);
  small.values.assign(64, 255);
  small.values[27] = 0;
  CHECK_THAT(refusal(small), Catch::EndsWith("specks are figures below 4"));
  CHECK(trace(gray, {.threshold = 255}).error().code == ErrorCode::usage);
  CHECK(trace(gray, {.threshold = -1}).error().code == ErrorCode::usage);
}

TEST_CASE("tracing is stopped wherever it is, and comes out the same under a job") {
  GrayImage image{400, 300, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.values.push_back((x - 200) * (x - 200) + (y - 150) * (y - 150) < 10'000 ? 0 : 255);
  const auto whole = trace(image, {});
  REQUIRE(whole.has_value());
  const auto stopped_at = [&](std::int64_t look) {
    JobControl job;
    job.stop_at_look(look);
    try {
      const auto tracing = trace(image, {}, &job);
      REQUIRE(tracing.has_value());
      CHECK(tracing->curves == whole->curves);
      return false;
    } catch (const Cancelled&) {
      return true;
    }
  };
  std::int64_t look = 1;
  while (look < 1000 && stopped_at(look)) ++look;
  CHECK(look > 20);
  CHECK(look < 1000);
}
