// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <thread>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/evolutions/evolution_run.h"
#include "tests/support/bell.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Document document_of(const SampleData& data) {
  Document out;
  const auto delta = replace_all(out, data);
  REQUIRE(delta);
  out.apply(*delta);
  return out;
}

EvolutionState beginning_of(const SampleData& data) {
  return state_of(document_of(data));
}

EvolutionChoice choice_of(std::string_view id, std::initializer_list<std::pair<std::string_view, double>> values = {},
                          std::uint64_t seed = 1) {
  EvolutionChoice out{.evolution = find_evolution(id), .seed = seed};
  for (const auto& [name, value] : values) out.values.keep(name, value);
  return out;
}

EvolutionState state_at(const SampleData& data, const EvolutionChoice& choice, std::uint64_t k) {
  JobControl job;
  EvolutionStates states(beginning_of(data), choice);
  const auto out = states.at(k, job);
  REQUIRE(out);
  return **out;
}

std::vector<std::uint32_t> counting(std::size_t n) {
  std::vector<std::uint32_t> out(n);
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<std::uint32_t>(i);
  return out;
}

// A closed polygon, its order known or not.
SampleData polygon(std::size_t n, bool known, const auto& radius) {
  SampleData out;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = kTurn * static_cast<double>(i) / static_cast<double>(n);
    out.positions.push_back({3.0 + radius(t) * std::cos(t), -1.0 + radius(t) * std::sin(t)});
  }
  if (known) out.contours.push_back({true, counting(n)});
  return out;
}
SampleData regular_polygon(std::size_t n, bool known) {
  return polygon(n, known, [](double) { return 1.0; });
}

Vec2 middle_of(const std::vector<Vec2>& points) {
  Vec2 sum;
  for (const Vec2 p : points) sum = sum + p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

double area_of(const std::vector<Vec2>& loop) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return 0.5 * sum;
}

std::vector<Vec2> along_first_loop(const EvolutionState& state) {
  std::vector<Vec2> out;
  const auto contours = contours_of(state);
  for (const std::uint32_t sample : contours.at(0).points) out.push_back(state.positions[sample]);
  return out;
}

void check_close(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double tolerance) {
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, distance(a[i], b[i]));
  CHECK(largest <= tolerance);
}

std::vector<Evolution> sample_evolutions() {
  std::vector<Evolution> out;
  for (const auto& evolution : builtins().evolutions().all()) out.push_back(*evolution);
  std::erase_if(out, [](const Evolution& evolution) { return evolution.moved_parameter() != nullptr; });
  return out;
}

}  // namespace

TEST_CASE("smoothing shrinks a regular polygon by the factor of the formula and keeps its middle") {
  for (const bool known : {true, false}) {
    for (const std::size_t n : {5U, 12U, 100U}) {
      const SampleData data = regular_polygon(n, known);
      for (const double mu : {0.5, 0.2, 1.0}) {
        const double factor = 1.0 - mu * (1.0 - std::cos(kTurn / static_cast<double>(n)));
        if (mu == 0.5) CHECK(factor == Approx((1.0 + std::cos(kTurn / static_cast<double>(n))) / 2.0));
        const int steps = 20;
        const auto after = state_at(data, choice_of("smooth", {{"smooth-mu", mu}}), steps).positions;
        const Vec2 middle{3.0, -1.0};
        std::vector<Vec2> expected;
        for (const Vec2 p : data.positions) expected.push_back(middle + std::pow(factor, steps) * (p - middle));
        check_close(after, expected, 1e-13);
        CHECK(distance(middle_of(after), middle) < 1e-14);
      }
    }
  }
}

TEST_CASE("smoothing multiplies each Fourier mode by its own factor, with and without the second pass") {
  constexpr std::size_t kSamples = 24;
  const Rng random(5);
  SampleData data = regular_polygon(kSamples, true);
  for (std::size_t i = 0; i < kSamples; ++i)
    data.positions[i] = {static_cast<double>(random.at(2 * i) >> 40U) * 1e-7,
                         static_cast<double>(random.at(2 * i + 1) >> 40U) * 1e-7};
  const auto mode = [&](const std::vector<Vec2>& points, std::size_t k, bool cosine) {
    Vec2 sum;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const double t = kTurn * static_cast<double>(i * k % kSamples) / kSamples;
      sum = sum + (cosine ? std::cos(t) : std::sin(t)) * points[i];
    }
    return sum;
  };
  for (const double back : {0.0, 0.53}) {
    const auto after = state_at(data, choice_of("smooth", {{"smooth-back", back}}), 7).positions;
    for (std::size_t k = 0; k <= kSamples / 2; ++k) {
      const double less = 1.0 - std::cos(kTurn * static_cast<double>(k) / kSamples);
      const double factor = std::pow((1.0 - 0.5 * less) * (1.0 + back * less), 7);
      for (const bool cosine : {true, false})
        CHECK(distance(mode(after, k, cosine), factor * mode(data.positions, k, cosine)) < 1e-11);
    }
  }
}

TEST_CASE("each loop keeps its area and its middle when asked to") {
  SampleData data = two_ellipses(2.0, 1.0, 0.5, 60).data;
  const auto choice = choice_of("smooth", {{"smooth-keep-area", 1.0}});
  const auto after = state_at(data, choice, 50).positions;
  const auto shrunk = state_at(data, choice_of("smooth"), 50).positions;
  for (const std::size_t from : {0U, 60U}) {
    const auto loop = [from](const std::vector<Vec2>& points) {
      return std::vector<Vec2>(points.begin() + static_cast<std::ptrdiff_t>(from),
                               points.begin() + static_cast<std::ptrdiff_t>(from + 60));
    };
    CHECK(area_of(loop(after)) == Approx(area_of(loop(data.positions))).epsilon(1e-12));
    CHECK(area_of(loop(shrunk)) < 0.95 * area_of(loop(data.positions)));
    CHECK(distance(middle_of(loop(after)), middle_of(loop(data.positions))) < 1e-13);
  }
}

TEST_CASE("a loop with samples that stay keeps them where they are, whatever becomes of its area") {
  // Two loops that meet in the first sample.
  const SampleData eight{.positions = {{0, 0}, {2, 1}, {3, 0}, {2, -1}, {-2, 1}, {-3, 0}, {-2, -1}},
                         .contours = {{true, {0, 1, 2, 3}}, {true, {0, 4, 5, 6}}}};
  const auto after = state_at(eight, choice_of("smooth", {{"smooth-keep-area", 1.0}}), 3).positions;
  CHECK(after[0] == eight.positions[0]);
  CHECK(after == state_at(eight, choice_of("smooth"), 3).positions);
}

TEST_CASE("two samples that are each other's neighbours enclose nothing and stay") {
  const SampleData data{.positions = {{0, 0}, {2, 1}}, .contours = {{true, {0, 1}}}};
  for (const std::string_view id : {"smooth", "noise"})
    CHECK(state_at(data, choice_of(id), 3).positions == data.positions);
}

TEST_CASE("curves found by the crust are numbered by their samples, wherever they lie") {
  for (const double side : {-1.0, 1.0}) {
    // Far apart; the first samples are those of one or of the other.
    SampleData data = regular_polygon(20, false);
    const std::vector<Vec2> first = data.positions;
    for (const Vec2 p : first) data.positions.push_back(p + Vec2{100.0 * side, 0.0});
    const auto after = state_at(data, choice_of("subdivide"), 1).positions;
    REQUIRE(after.size() == 80);
    for (std::size_t i = 40; i < 60; ++i) CHECK(distance(after[i], first[0]) < 50.0);
    for (std::size_t i = 60; i < 80; ++i) CHECK(distance(after[i], first[0]) > 50.0);
  }
}

TEST_CASE("subdivision converges to the cubic B-spline of the control polygon") {
  const SampleData data = polygon(7, true, [](double t) { return 2.0 + std::cos(3.0 * t); });
  const auto& p = data.positions;
  const auto after = state_at(data, choice_of("subdivide"), 6);
  REQUIRE(after.positions.size() == 7U << 6U);
  const auto contours = contours_of(after);
  REQUIRE(contours.size() == 1);
  REQUIRE(contours[0].points.size() == after.positions.size());
  for (std::size_t i = 0; i < contours[0].points.size(); ++i) {
    // The uniform B-spline at parameter i / 64; the control points of level 6 lie 1/6 of a second difference off it.
    const std::size_t span = i >> 6U;
    const double t = static_cast<double>(i & 63U) / 64.0;
    const double basis[4] = {(1 - t) * (1 - t) * (1 - t) / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                             (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
    Vec2 on_curve;
    for (std::size_t j = 0; j < 4; ++j) on_curve = on_curve + basis[j] * p[(span + j + 6) % 7];
    const auto at = [&](std::size_t j) {
      return after.positions[contours[0].points[(i + j + contours[0].points.size() - 1) % contours[0].points.size()]];
    };
    const Vec2 limit = (1.0 / 6.0) * at(0) + (2.0 / 3.0) * at(1) + (1.0 / 6.0) * at(2);
    CHECK(distance(limit, on_curve) < 1e-13);
  }
}

TEST_CASE("every scheme of subdivision does one step as its mask says") {
  SampleData open{.positions = {{0, 0}, {4, 0}, {8, 8}, {8, 16}}, .contours = {{false, {0, 1, 2, 3}}}};
  const auto in_order = [&](double scheme) {
    const auto state = state_at(open, choice_of("subdivide", {{"subdivide-scheme", scheme}}), 1);
    return along_first_loop(state);
  };
  check_close(in_order(0), {{0, 0}, {2, 0}, {4, 1}, {6, 4}, {7.5, 8}, {8, 12}, {8, 16}}, 0.0);
  check_close(in_order(1), {{0, 0}, {3, 0}, {5, 2}, {7, 6}, {8, 10}, {8, 16}}, 0.0);
  check_close(in_order(2), {{0, 0}, {2.0, -0.5}, {4, 0}, {6.25, 3.5}, {8, 8}, {8.25, 12}, {8, 16}}, 1e-15);
  check_close(in_order(3), {{0, 0}, {2, 0}, {4, 0}, {6, 4}, {8, 8}, {8, 12}, {8, 16}}, 0.0);

  SampleData closed{.positions = {{0, 0}, {8, 0}, {8, 8}, {0, 8}}, .contours = {{true, {0, 1, 2, 3}}}};
  const auto cut = state_at(closed, choice_of("subdivide", {{"subdivide-scheme", 1}}), 1);
  check_close(along_first_loop(cut), {{2, 0}, {6, 0}, {8, 2}, {8, 6}, {6, 8}, {2, 8}, {0, 6}, {0, 2}}, 0.0);
}

TEST_CASE("subdividing beyond what can be handled is refused in one line") {
  const SampleData data = regular_polygon(1000, true);
  JobControl job;
  EvolutionStates states(beginning_of(data), choice_of("subdivide"));
  const auto state = states.at(40, job);
  REQUIRE_FALSE(state);
  CHECK(state.error().text == "step 12 would make 4096000 samples; 4000000 are the most");
}

TEST_CASE("noise stays within its bound, and another seed, step or sample gives other noise") {
  const SampleData data = regular_polygon(200, true);
  const double between = distance(data.positions[0], data.positions[2]);
  const auto moved = [&](const EvolutionChoice& choice, std::uint64_t k) {
    return state_at(data, choice, k).positions;
  };
  for (const double isotropic : {0.0, 1.0}) {
    const auto choice = choice_of("noise", {{"noise-isotropic", isotropic}});
    const auto once = moved(choice, 1);
    double largest = 0.0;
    for (std::size_t i = 0; i < once.size(); ++i) {
      const Vec2 offset = once[i] - data.positions[i];
      largest = std::max(largest, length(offset));
      if (isotropic == 0.0) CHECK(std::abs(cross(offset, data.positions[i] - Vec2{3.0, -1.0})) < 1e-14);
    }
    CHECK(largest <= 0.05 * between * (1 + 1e-12));
    CHECK(largest > 0.04 * between);
    CHECK(once == moved(choice, 1));
    CHECK(once != moved(choice_of("noise", {{"noise-isotropic", isotropic}}, 2), 1));
    const auto twice = moved(choice, 2);
    CHECK(distance(twice[0] - once[0], once[0] - data.positions[0]) > 1e-9);
  }
  // A sample that leaves takes no noise away from the others.
  Document document = document_of(data);
  const auto gone = remove_samples(document, std::vector{document.id(SampleSlot(50))});
  REQUIRE(gone);
  document.apply(*gone);
  JobControl job;
  EvolutionStates fewer(state_of(document), choice_of("noise"));
  const auto state = fewer.at(1, job);
  REQUIRE(state);
  const auto all = moved(choice_of("noise"), 1);
  CHECK((*state)->positions[10] == all[10]);
  CHECK((*state)->positions[150] == all[151]);
}

TEST_CASE("states are the same in whatever order they are asked for and however little is kept") {
  const SampleData data = polygon(80, false, [](double t) { return 2.0 + 0.3 * std::cos(5.0 * t); });
  for (const Evolution& evolution : sample_evolutions()) {
    const auto choice = choice_of(evolution.descriptor.id);
    const std::uint64_t last = evolution.descriptor.id == "subdivide" ? 6 : 200;
    JobControl job;
    EvolutionStates forward(beginning_of(data), choice);
    std::vector<std::vector<Vec2>> expected;
    for (std::uint64_t k = 0; k <= last; ++k) expected.push_back((*forward.at(k, job))->positions);
    for (const std::size_t budget : {std::size_t{0}, std::size_t{40'000}, EvolutionStates::kDefaultBudget}) {
      EvolutionStates states(beginning_of(data), choice, budget);
      for (std::uint64_t k = last + 1; k-- > 0;) CHECK((*states.at(k, job))->positions == expected[k]);
      Rng random(3);
      for (int i = 0; i < 60; ++i) {
        const std::uint64_t k = random.below(last + 1);
        CHECK((*states.at(k, job))->positions == expected[k]);
      }
      if (last == 200 && budget == 40'000) CHECK(states.kept_bytes() <= budget);
    }
  }
}

TEST_CASE("playing backwards computes each stretch once") {
  const SampleData data = regular_polygon(100, true);
  JobControl job;
  EvolutionStates states(beginning_of(data), choice_of("smooth"), 120'000);
  std::size_t steps = 0;
  const auto count = [&steps](std::uint64_t) { ++steps; };
  REQUIRE(states.at(400, job, count));
  CHECK(steps == 400);
  for (std::uint64_t k = 400; k-- > 0;) REQUIRE(states.at(k, job, count));
  CHECK(steps <= 850);
}

TEST_CASE("twenty thousand steps of smoothing end at the middle") {
  const SampleData data = regular_polygon(40, true);
  const auto after = state_at(data, choice_of("smooth"), 20'000).positions;
  check_close(after, std::vector<Vec2>(40, Vec2{3.0, -1.0}), 1e-12);
}

TEST_CASE("samples off the curve, ends of chains and samples on several loops stay") {
  SampleData data;
  for (int i = 0; i < 20; ++i) data.positions.push_back({0.1 * i, 0.02 * (i % 3)});
  data.positions.push_back({1.0, 5.0});
  for (const Evolution& evolution : sample_evolutions()) {
    const auto after = state_at(data, choice_of(evolution.descriptor.id), 3).positions;
    CHECK(after[0] == data.positions[0]);
    CHECK(after[19] == data.positions[19]);
    CHECK(after[20] == data.positions[20]);
    CHECK(after[11] != data.positions[11]);
  }
  SampleData eight{.positions = {{0, 0}, {2, 1}, {2, -1}, {-2, 1}, {-2, -1}},
                   .contours = {{true, {0, 1, 2}}, {true, {0, 3, 4}}}};
  for (const Evolution& evolution : sample_evolutions()) {
    const auto after = state_at(eight, choice_of(evolution.descriptor.id), 1).positions;
    CHECK(after[0] == eight.positions[0]);
    CHECK(after[1] != eight.positions[1]);
  }
}

TEST_CASE("samples at one place stay together") {
  SampleData data = regular_polygon(30, false);
  data.positions.push_back(data.positions[4]);
  data.positions.insert(data.positions.begin(), data.positions[9]);
  for (const Evolution& evolution : sample_evolutions()) {
    for (const double frozen : {0.0, 1.0}) {
      const auto after = state_at(data, choice_of(evolution.descriptor.id, {{"freeze-chains", frozen}}), 3).positions;
      CHECK(after[0] == after[10]);
      CHECK(after[5] == after[31]);
      CHECK(after[0] != data.positions[0]);
    }
  }
}

TEST_CASE("no samples, one, two and many at one place make no trouble") {
  for (const std::vector<Vec2>& positions :
       {std::vector<Vec2>{}, {{1, 2}}, {{0, 0}, {1, 1}}, {{1, 1}, {1, 1}, {1, 1}}, {{0, 0}, {1, 0}, {2, 0}}}) {
    for (const Evolution& evolution : sample_evolutions()) {
      for (const bool known : {false, true}) {
        SampleData data{.positions = positions};
        if (known) data.contours = {{true, counting(positions.size())}};
        const auto after = state_at(data, choice_of(evolution.descriptor.id), 5);
        CHECK(after.positions.size() >= positions.size());
        CHECK(std::ranges::all_of(after.positions, [](Vec2 p) { return is_finite(p); }));
      }
    }
  }
}

TEST_CASE("coordinates that leave their range are an error") {
  SampleData data{.positions = {{-0x1.ep499, 0}, {0x1.ep499, 0x1p499}, {0, 0x1.ep499}, {0, 0x1p480}},
                  .contours = {{true, {0, 1, 2, 3}}}};
  JobControl job;
  EvolutionStates states(beginning_of(data), choice_of("noise", {{"noise-factor", 10}}));
  const auto state = states.at(20, job);
  REQUIRE_FALSE(state);
  CHECK_THAT(state.error().text, Catch::Contains("leaves the range of coordinates") && Catch::Contains("too large"));
}

TEST_CASE("a run answers the last wish, on a thread of its own, and can be cancelled") {
  const SampleData data = regular_polygon(300, false);
  Bell bell;
  EvolutionRun run({.wake = bell.ring()});
  run.begin(beginning_of(data), choice_of("smooth"));
  const auto answer = [&] {
    std::optional<EvolutionRun::Answer> out;
    bell.wait_until([&] { return (out = run.poll()).has_value(); });
    return *out;
  };
  run.want(1'000'000'000);
  run.want(5);
  const auto five = answer();
  CHECK(five.k == 5);
  REQUIRE(five.state);
  CHECK((*five.state)->positions == state_at(data, choice_of("smooth"), 5).positions);
  CHECK_FALSE(run.is_busy());
  run.want(1'000'000'000);
  CHECK(run.is_busy());
  run.cancel();
  CHECK_FALSE(run.is_busy());
  run.want(3);
  CHECK(answer().k == 3);
  run.want(1'000'000'000);  // is left behind when the run ends
}

TEST_CASE("a state reached after a farther one was requested does not answer the request") {
  Bell bell;
  EvolutionRun run({.wake = bell.ring()});
  run.begin(beginning_of(regular_polygon(300, true)), choice_of("smooth"));
  run.want(20'000);
  while (run.reached() == 0) std::this_thread::yield();
  run.want(20'001);
  std::optional<EvolutionRun::Answer> answer;
  bell.wait_until([&] { return (answer = run.poll()).has_value(); });
  CHECK(answer->k == 20'001);
  CHECK_FALSE(run.is_busy());
}

TEST_CASE("balls grow by equal steps, shrink by the inverse, and stay within the parameter's range") {
  const ParameterValues values;
  const auto value = [&values](std::string_view id, double first, std::uint64_t k) {
    return moved_value(*find_evolution(id)->moved_parameter(), first, k, values);
  };
  for (const std::string family : {"a", "p", "b"}) {
    const ParameterMove* move = find_evolution(family + "-growing")->moved_parameter();
    REQUIRE(move != nullptr);
    CHECK(move->parameter.id == family + "-scale");
    CHECK(value(family + "-growing", 1.0, 0) == 1.0);
    CHECK(value(family + "-growing", 1.0, 1) == 1.03);
    CHECK(value(family + "-growing", 1.0, 100) == 4.0);
    CHECK(value(family + "-shrinking", 1.0, 0) == 1.0);
    CHECK(value(family + "-shrinking", 1.0, 100) == 0.25);
    CHECK(value(family + "-growing", 1.0, 3300) == 100.0);
    CHECK_FALSE(value(family + "-growing", 1.0, 3301));
    CHECK_FALSE(value(family + "-shrinking", 0.01, 1));
  }
  for (const char* id : {"scale-axis-growing", "scale-skeleton"}) {
    CHECK(value(id, 1.0, 10) == 1.3);
    CHECK_FALSE(value(id, 1.0, 67));
  }
  CHECK(value("scale-axis-shrinking", 1.0, 100) == 0.25);
  CHECK(value("scale-axis-shrinking", 1.0, 300) == 0.1);
  CHECK_FALSE(value("scale-axis-shrinking", 1.0, 301));
  CHECK(value("alpha-growing", 0.0, 0) == 0.0);
  CHECK(value("alpha-growing", 0.5, 7) == 7.5);
  CHECK(value("alpha-shrinking", 7.0, 3) == 4.0);
  CHECK(value("alpha-shrinking", 7.0, 7) == 0.0);
  CHECK_FALSE(value("alpha-shrinking", 7.0, 8));
  ParameterValues tenths;
  tenths.keep("alpha-step", 0.1);
  CHECK(moved_value(*find_evolution("alpha-shrinking")->moved_parameter(), 0.3, 3, tenths) == 0.0);
}
