// SPDX-License-Identifier: GPL-3.0-or-later
// Sampled balls against the union they are of: in it, touching its boundary, and close enough to their neighbours.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "core/structures/balls/ball_sampling.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// Samples and balls, with both families sampled.
class Sampled {
 public:
  explicit Sampled(const SampleData& data) {
    graph_.set_demand(std::array{find_layer("a-ball-medial-disks"), find_layer("b-ball-medial-disks")});
    Document document;
    const auto delta = replace_all(document, data);
    REQUIRE(delta.has_value());
    graph_.post(std::make_shared<const DocumentDelta>(*delta));
    run();
  }
  void choose_angle(double degrees) {
    ComputationSettings settings;
    settings[Parameter::medial_sampling_angle] = degrees;
    graph_.post_settings(settings);
    run();
  }
  template <class T>
  const T& get() const {
    return graph_.structures().get<T>();
  }

 private:
  void run() {
    JobControl job;
    REQUIRE(graph_.run(patch_, job));
    for (const NodeReport& node : patch_.nodes) REQUIRE(node.state != NodeState::failed);
  }
  Graph graph_{builtins()};
  FramePatch patch_;
};

std::vector<Disk> disks_of(const SampledBalls& balls) {
  std::vector<Disk> out;
  for (const SampledSlot row : slots_below<SampledSlot>(balls.rows()))
    if (balls.is_alive(row)) out.push_back(balls.disk(row));
  return out;
}

SampleData some_balls(std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  SampleData data;
  for (std::size_t i = 0; i < count; ++i)
    data.balls.push_back({{10 * rng.uniform(), 10 * rng.uniform()}, 0.3 + rng.uniform()});
  return data;
}

bool is_in_union(const BallUnion& balls, Vec2 p) {
  for (const FamilySlot row : balls.tables().balls.rows()) {
    if (balls.tables().balls[row] == BallState::none) continue;
    const Disk disk = balls.family().disk(row);
    if (distance(p, disk.center) <= disk.radius + 1e-9) return true;
  }
  return false;
}

/// Radii at a crossing of the two circles enclose at most so much, or the balls are as close as sampling goes.
bool are_neighbours(const Disk& a, const Disk& b, double degrees, double diameter) {
  const double d = distance(a.center, b.center);
  if (d <= 1e-4 * diameter) return true;
  const double cosine = (a.radius * a.radius + b.radius * b.radius - d * d) / (2.0 * a.radius * b.radius);
  return cosine >= std::cos(degrees * std::numbers::pi / 180.0) - 1e-9;
}

/// The disks whose centres lie between a and b, in order.
std::vector<Disk> along(const std::vector<Disk>& disks, Vec2 a, Vec2 b) {
  std::vector<Disk> out;
  const double size = distance(a, b);
  for (const Disk& disk : disks) {
    const double s = dot(disk.center - a, b - a) / size;
    const double off = std::abs(cross(disk.center - a, b - a)) / size;
    if (off <= 1e-12 && s >= 0.0 && s <= size) out.push_back(disk);
  }
  std::ranges::sort(out, {}, [&](const Disk& disk) { return dot(disk.center - a, b - a); });
  return out;
}

void check_medial(const BallUnion& balls, const BallSampling& sampling, double angle) {
  const UnionTables& t = balls.tables();
  const std::vector<Disk> disks = disks_of(sampling.medial());
  REQUIRE(disks.size() > t.axis.size() / 2);
  Box2 box;
  for (const Disk& disk : disks) box.add(bounding_box_of(disk));
  const double diameter = std::hypot(box.width(), box.height());
  std::size_t outside = 0;
  std::size_t off_boundary = 0;
  for (const Disk& disk : disks) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const VPoint& v : t.v_points)
      if (v.is_alive()) nearest = std::min(nearest, distance(disk.center, v.position));
    // Alone in its component, a ball touches the boundary all around.
    const bool is_alone = nearest > disk.radius * (1.0 + 1e-9) && std::ranges::any_of(t.arcs, [&](const auto& arc) {
                            return arc.is_whole != 0 && balls.family().disk(arc.ball) == disk;
                          });
    off_boundary += is_alone || std::abs(nearest - disk.radius) <= 1e-9 * diameter ? 0U : 1U;
    for (int i = 0; i < 64; ++i) {
      const double t0 = 2.0 * std::numbers::pi * i / 64.0;
      if (!is_in_union(balls, disk.center + disk.radius * Vec2{std::cos(t0), std::sin(t0)})) ++outside;
    }
  }
  CHECK(outside == 0);
  CHECK(off_boundary == 0);

  std::size_t without_node = 0;
  std::size_t far = 0;
  for (const AxisPiece& piece : t.axis) {
    if (!piece.is_alive() || piece.is_zero != 0) continue;
    for (const Disk& end : {Disk{piece.a, piece.radius_a}, Disk{piece.b, piece.radius_b}})
      without_node += std::ranges::count(disks, end) == 1 ? 0U : 1U;
    const std::vector<Disk> on_piece = along(disks, piece.a, piece.b);
    for (std::size_t i = 1; i < on_piece.size(); ++i)
      far += are_neighbours(on_piece[i - 1], on_piece[i], 180.0 - angle, diameter) ? 0U : 1U;
  }
  CHECK(without_node == 0);
  CHECK(far == 0);
}

}  // namespace

TEST_CASE("medial balls lie in the union and touch its boundary, close to their neighbours") {
  SampleData data = some_balls(25, 3);
  data.positions = ellipse(2, 1, 120, {.offset = 0.123}).data.positions;
  Sampled sampled(data);
  std::size_t last = 0;
  for (const double angle : {90.0, 150.0, 175.0}) {
    INFO(angle << " degrees");
    sampled.choose_angle(angle);
    REQUIRE(sampled.get<AUnion>().rung() == UnionRung::shortcut);
    check_medial(sampled.get<AUnion>(), sampled.get<ABallSampling>(), angle);
    check_medial(sampled.get<BUnion>(), sampled.get<BBallSampling>(), angle);
    const std::size_t count = sampled.get<BBallSampling>().medial().count();
    CHECK(count > last);
    last = count;
  }
}

TEST_CASE("convex balls between two that cross pass through both crossings") {
  SampleData data;
  data.balls = {{{0, 0}, 5}, {{6, 0}, 5}};
  const Sampled sampled(data);
  const std::vector<Disk> disks = disks_of(sampled.get<BBallSampling>().convex());
  CHECK(disks.size() > 10);
  for (const Disk& disk : disks)
    for (const double y : {4.0, -4.0}) CHECK(distance(disk.center, {3.0, y}) == Approx(disk.radius).epsilon(1e-12));
  const std::vector<Disk> in_order = along(disks, {0, 0}, {6, 0});
  REQUIRE(in_order.size() == disks.size());
  CHECK(in_order.front() == data.balls[0]);
  CHECK(in_order.back() == data.balls[1]);
  for (std::size_t i = 1; i < in_order.size(); ++i) CHECK(are_neighbours(in_order[i - 1], in_order[i], 5.0, 16.0));
}

TEST_CASE("convex balls between two that touch stay a tenth as thick, medial ones vanish where they touch") {
  SampleData data;
  data.balls = {{{0, 0}, 1}, {{3, 0}, 2}};
  const Sampled sampled(data);
  const auto thinnest = [](const SampledBalls& balls) {
    return std::ranges::min(disks_of(balls), {}, &Disk::radius).radius;
  };
  CHECK(thinnest(sampled.get<BBallSampling>().convex()) == Approx(0.1));
  CHECK(thinnest(sampled.get<BBallSampling>().medial()) < 1e-3);
  CHECK(sampled.get<BBallSampling>().medial().count() < 100);
}

TEST_CASE("there are balls to sample only where there is an axis") {
  const auto counts = [](std::vector<Disk> disks) {
    SampleData data;
    data.balls = std::move(disks);
    const Sampled sampled(data);
    const auto& sampling = sampled.get<BBallSampling>();
    return std::pair(sampling.medial().count(), sampling.convex().count());
  };
  CHECK(counts({}) == std::pair<std::size_t, std::size_t>(0, 0));
  CHECK(counts({{{1, 2}, 3}}) == std::pair<std::size_t, std::size_t>(1, 0));
  CHECK(counts({{{1, 2}, 0}}) == std::pair<std::size_t, std::size_t>(0, 0));
  CHECK(counts({{{0, 0}, 3}, {{1, 0}, 1}}) == std::pair<std::size_t, std::size_t>(1, 0));
  CHECK(counts({{{0, 0}, 3}, {{0, 0}, 3}}) == std::pair<std::size_t, std::size_t>(1, 0));
  CHECK(counts({{{0, 0}, 1}, {{9, 0}, 1}}) == std::pair<std::size_t, std::size_t>(2, 0));
}

TEST_CASE("size does not matter to sampling") {
  const auto counts = [](double size) {
    SampleData data = some_balls(12, 8);
    for (Disk& disk : data.balls) disk = {size * disk.center, size * disk.radius};
    const Sampled sampled(data);
    const auto& sampling = sampled.get<BBallSampling>();
    return std::pair(sampling.medial().count(), sampling.convex().count());
  };
  const auto expected = counts(1.0);
  CHECK(expected.first > 100);
  for (const int exponent : {-400, -300, 300, 400}) {
    INFO("2^" << exponent);
    CHECK(counts(std::ldexp(1.0, exponent)) == expected);
  }
}

TEST_CASE("an edit of a certified union samples its surroundings again, and gives what a fresh start gives") {
  TestBench bench(ellipse(200, 100, 400, {.offset = 0.3}).data.positions);
  const LayerIndex layer = find_layer("a-ball-medial-disks");
  const auto whole = bench.count("a-ball-sampling", "medial_balls");
  Rng rng(4);
  for (int step = 0; step < 60; ++step) {
    const auto ids = bench.ids();
    const SampleId id = ids[rng.below(ids.size())];
    const Vec2 p = bench.document().position(bench.document().slot_of(id));
    switch (step % 3) {
      case 0: bench.move(id, p + 0.2 * Vec2{rng.uniform() - 0.5, rng.uniform() - 0.5}); break;
      case 1: bench.remove({id}); break;
      default: bench.undo(); break;
    }
    INFO("step " << step);
    REQUIRE(bench.get<AUnion>().rung() == UnionRung::shortcut);
    for (std::size_t i = 0; i < bench.patch().layer_count; ++i) {
      const LayerPatch& patch = bench.patch().layers[i];
      if (patch.layer != layer) continue;
      CHECK_FALSE(patch[PrimitiveKind::disk].reset);
      CHECK(patch[PrimitiveKind::disk].index.size() < static_cast<std::size_t>(whole) / 4);
    }
    REQUIRE(bench.trouble() == "");
  }
}
