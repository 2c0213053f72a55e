// SPDX-License-Identifier: GPL-3.0-or-later
// An oracle that knows neither triangulations nor crossings of arcs: by the nerve theorem a union of disks has the Euler
// characteristic of the complex of all sets of disks that have a point in common, and by Helly's theorem a set of disks
// in the plane has one if each three of it have. Whether three have is decided in rationals and one square root.
#include <CGAL/Exact_rational.h>

#include <catch2/catch.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/poles/polar_union.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using Number = CGAL::Exact_rational;

int sign_of(const Number& x) {
  return static_cast<int>(CGAL::sign(x));
}
/// Of a + b sqrt(c); c is not negative.
int sign_with_root(const Number& a, const Number& b, const Number& c) {
  const int first = sign_of(a);
  const int second = sign_of(b) * sign_of(c);
  if (first == 0 || second == 0 || first == second) return first == 0 ? second : first;
  return first * sign_of(a * a - b * b * c);
}

struct UnionCircle {
  Number x, y;
  Number square;  // of the radius
};

Number square_distance(const UnionCircle& a, const UnionCircle& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

bool meet(const UnionCircle& a, const UnionCircle& b) {
  return sign_with_root(square_distance(a, b) - a.square - b.square, Number(-2), a.square * b.square) <= 0;
}

/// The disk of `b` lies in that of `a`.
bool holds(const UnionCircle& a, const UnionCircle& b) {
  return a.square >= b.square &&
         sign_with_root(a.square + b.square - square_distance(a, b), Number(-2), a.square * b.square) >= 0;
}

/// A point of both circles lies in the disk of `c`. The disks of `a` and `b` meet, and none holds the other.
bool have_crossing_in(const UnionCircle& a, const UnionCircle& b, const UnionCircle& c) {
  const Number dx = b.x - a.x, dy = b.y - a.y, dd = dx * dx + dy * dy;
  const Number along = (dd + a.square - b.square) / (2 * dd);
  const Number away_x = a.x + along * dx - c.x, away_y = a.y + along * dy - c.y;
  const Number half_square = a.square - along * along * dd;
  const Number power = away_x * away_x + away_y * away_y + half_square - c.square;
  const Number slope = 2 * (away_y * dx - away_x * dy);
  return sign_with_root(power, slope, half_square / dd) <= 0 || sign_with_root(power, -slope, half_square / dd) <= 0;
}

bool meet(const UnionCircle& a, const UnionCircle& b, const UnionCircle& c) {
  if (!meet(a, b) || !meet(b, c) || !meet(a, c)) return false;
  for (const auto& [p, q] : {std::pair{&a, &b}, std::pair{&b, &c}, std::pair{&a, &c}})
    if (holds(*p, *q) || holds(*q, *p)) return true;
  return have_crossing_in(a, b, c) || have_crossing_in(b, c, a) || have_crossing_in(a, c, b);
}

class Nerve {
 public:
  explicit Nerve(const std::vector<UnionCircle>& circles) : circles_(circles), size_(circles.size()) {
    pairs_.resize(size_ * size_);
    triples_.resize(size_ * size_ * size_);
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t j = i + 1; j < size_; ++j) {
        pairs_[i * size_ + j] = meet(circles_[i], circles_[j]);
        for (std::size_t k = j + 1; k < size_; ++k)
          triples_[(i * size_ + j) * size_ + k] = meet(circles_[i], circles_[j], circles_[k]);
      }
    }
  }
  std::int64_t components() const {
    std::vector<std::size_t> root(size_);
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto root_of = [&](std::size_t i) {
      while (root[i] != i) i = root[i];
      return i;
    };
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = i + 1; j < size_; ++j)
        if (pairs_[i * size_ + j]) root[root_of(j)] = root_of(i);
    std::int64_t out = 0;
    for (std::size_t i = 0; i < size_; ++i) out += root[i] == i ? 1 : 0;
    return out;
  }
  std::int64_t euler_characteristic() const {
    std::vector<std::size_t> chosen;
    return count_from(0, chosen);
  }

 private:
  // Sets with more disks than those chosen, which have numbers from `first` on; each with the sign of its dimension.
  std::int64_t count_from(std::size_t first, std::vector<std::size_t>& chosen) const {
    std::int64_t out = 0;
    for (std::size_t k = first; k < size_; ++k) {
      bool is_simplex = true;
      for (std::size_t j = 0; is_simplex && j < chosen.size(); ++j) {
        is_simplex = pairs_[chosen[j] * size_ + k];
        for (std::size_t i = 0; is_simplex && i < j; ++i)
          is_simplex = triples_[(chosen[i] * size_ + chosen[j]) * size_ + k];
      }
      if (!is_simplex) continue;
      out += chosen.size() % 2 == 0 ? 1 : -1;
      chosen.push_back(k);
      out += count_from(k + 1, chosen);
      chosen.pop_back();
    }
    return out;
  }

  const std::vector<UnionCircle>& circles_;
  std::size_t size_;
  std::vector<bool> pairs_, triples_;
};

UnionCircle circle_of(const Disk& disk, double scale) {
  const Number radius = Number(disk.radius) * Number(scale);
  return {disk.center.x, disk.center.y, radius * radius};
}

UnionCircle circle_through(const std::array<Vec2, 3>& corners, double scale) {
  const Number ax = corners[0].x, ay = corners[0].y;
  const Number bx = Number(corners[1].x) - ax, by = Number(corners[1].y) - ay;
  const Number cx = Number(corners[2].x) - ax, cy = Number(corners[2].y) - ay;
  const Number twice = 2 * (bx * cy - by * cx), b = bx * bx + by * by, c = cx * cx + cy * cy;
  const Number x = (cy * b - by * c) / twice, y = (bx * c - cx * b) / twice;
  return {ax + x, ay + y, (x * x + y * y) * Number(scale) * Number(scale)};
}

std::vector<UnionCircle> circles_of(const BallUnion& balls) {
  std::vector<UnionCircle> out;
  const BallFamily& family = balls.family();
  for (std::size_t row = 0; row < family.rows(); ++row) {
    const FamilySlot slot(row);
    if (!family.is_ball(slot)) continue;
    out.push_back(family.origin(slot) == BallOrigin::circumdisk ? circle_through(family.corners(slot), family.scale())
                                                                : circle_of(family.plain_disk(slot), family.scale()));
  }
  return out;
}

ComputationSettings settings_of(Precision precision, double scale) {
  ComputationSettings out;
  out.precision = precision;
  out[Parameter::a_scale] = scale;
  out[Parameter::p_scale] = scale;
  out[Parameter::b_scale] = scale;
  return out;
}

/// More disks than these may have a million sets in common.
constexpr std::size_t kMost = 22;

struct Topology {
  std::int64_t components, cycles, chi, chi_dual;
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// Nothing if there are no disks or too many.
std::optional<Topology> topology_of_nerve(const BallUnion& balls) {
  const std::vector<UnionCircle> circles = circles_of(balls);
  if (circles.empty() || circles.size() > kMost) return std::nullopt;
  const Nerve nerve(circles);
  const std::int64_t components = nerve.components();
  const std::int64_t chi = nerve.euler_characteristic();
  return Topology{components, components - chi, chi, chi};
}

Topology topology_found(const TestBench& bench, std::string_view id) {
  return {bench.count(id, "components"), bench.count(id, "cycles"), bench.count(id, "chi"),
          bench.count(id, "chi_dual")};
}

/// Returns whether there was something to compare.
bool check_topology(const TestBench& bench, std::string_view id, const BallUnion& balls) {
  REQUIRE(balls.is_exact());
  const auto expected = topology_of_nerve(balls);
  if (!expected) return false;
  INFO(id << " of " << bench.count(id, "balls") << " disks");
  const Topology found = topology_found(bench, id);
  CHECK(found.components == expected->components);
  CHECK(found.cycles == expected->cycles);
  CHECK(found.chi == expected->chi);
  CHECK(found.chi_dual == expected->chi_dual);
  return true;
}

/// Places on a grid of integers to equal places far from the origin and of another size, without rounding.
struct Image {
  double scale;
  Vec2 shift;
  Vec2 operator()(Vec2 p) const { return scale * (p + shift); }
};
constexpr Image kImages[] = {
    {1.0, {0.0, 0.0}}, {0x1p-20, {0x1p44, -0x1p45}}, {0x1p400, {0.0, 0x1p40}}, {0x1p-400, {-0x1p30, 3.0}}};

/// Small integers, where circles touch, hold each other, meet in one point, and are there twice.
std::vector<Disk> coincident_disks(int kind, Rng& rng) {
  const auto whole = [&rng](std::uint64_t below) { return static_cast<double>(rng.below(below)); };
  std::vector<Disk> out;
  const std::size_t count = 3 + rng.below(12);
  for (std::size_t i = 0; i < count; ++i) {
    switch (kind) {
      case 0: out.push_back({{whole(12), whole(12)}, 1.0 + whole(3)}); break;
      case 1: out.push_back({{whole(16), 0.0}, 1.0 + whole(4)}); break;       // centres in line
      case 2: out.push_back({{3.0 * whole(4), 4.0 * whole(4)}, 2.5}); break;  // equal, touching
      case 3: {  // all circles pass through one point, some of them from outside
        constexpr Vec2 kFive[] = {{3, 4},  {4, 3},  {5, 0},  {0, 5},  {-3, 4},
                                  {-4, 3}, {-5, 0}, {0, -5}, {3, -4}, {-4, -3}};
        const double factor = 1.0 + whole(3);
        out.push_back({factor * kFive[rng.below(10)], 5.0 * factor});
        break;
      }
      default:  // touching from inside and outside, about few centres
        out.push_back({{5.0 * whole(3), 0.0}, 1.0 + whole(9)});
        break;
    }
  }
  return out;
}

std::vector<Vec2> samples_on_grid(Rng& rng, std::uint64_t cells) {
  std::vector<Vec2> out;
  const std::size_t count = 8 + rng.below(10);
  for (std::size_t i = 0; i < count; ++i)
    out.push_back({static_cast<double>(rng.below(cells)), static_cast<double>(rng.below(cells))});
  return out;
}

}  // namespace

TEST_CASE("unions of disks full of coincidences have the components and cycles of their nerve") {
  Rng rng(41);
  int compared = 0;
  for (int round = 0; round < 30; ++round) {
    const int kind = round % 5;
    const std::vector<Disk> disks = coincident_disks(kind, rng);
    for (const Image& image : kImages) {
      SampleData data;
      for (const Disk& disk : disks) data.balls.push_back({image(disk.center), image.scale * disk.radius});
      TestBench bench;
      bench.show({"b-ball-medial-axis"});
      bench.load(data);
      for (const double scale : {1.0, 1.5, 1.1}) {
        INFO("round " << round << ", kind " << kind << ", size " << image.scale << ", scale " << scale);
        bench.choose(settings_of(Precision::exact, scale));
        compared += check_topology(bench, "b-union", bench.get<BUnion>()) ? 1 : 0;
      }
    }
  }
  CHECK(compared == 30 * 4 * 3);
}

TEST_CASE("unions of balls of samples have the components and cycles of their nerve by default") {
  Rng rng(42);
  int compared = 0;
  for (int round = 0; round < 20; ++round) {
    // Many are cocircular, in line, or there twice, or in general position.
    const std::vector<Vec2> samples = samples_on_grid(rng, round % 2 == 0 ? 7 : 40);
    for (const Image& image : kImages) {
      std::vector<Vec2> moved;
      for (const Vec2 p : samples) moved.push_back(image(p));
      TestBench bench;
      bench.show({"a-ball-medial-axis", "p-ball-medial-axis"});
      bench.replace(moved);
      for (const double scale : {1.0, 1.1, 0.75}) {
        INFO("round " << round << ", size " << image.scale << ", scale " << scale);
        bench.choose(settings_of(Precision::fast, scale));
        compared += check_topology(bench, "a-union", bench.get<AUnion>()) ? 1 : 0;
        compared += check_topology(bench, "p-union", bench.get<PUnion>()) ? 1 : 0;
      }
    }
  }
  CHECK(compared > 250);
}

TEST_CASE("the nerve tells unions of rounded numbers from exact ones") {
  Rng rng(43);
  int wrong = 0;
  for (int round = 0; round < 20; ++round) {
    TestBench bench;
    bench.show({"a-ball-medial-axis"});
    bench.replace(samples_on_grid(rng, 40));
    ComputationSettings settings = settings_of(Precision::fast, 1.0);
    settings[Parameter::union_shortcut] = 0.0;
    bench.choose(settings);
    const auto expected = topology_of_nerve(bench.get<AUnion>());
    if (expected && topology_found(bench, "a-union") != *expected) ++wrong;
  }
  CHECK(wrong > 0);
}
