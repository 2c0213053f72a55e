// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/balls/internal/growth/ball_births.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/structures/balls/internal/complex/power_diagram.h"
#include "core/structures/balls/internal/complex/union_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"

namespace mes {
namespace {

using Rational = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<false>;
using Balls = UnionBalls<ExactKernel, ExactKernel>;
using Span = std::array<InputSlot, 3>;  // the balls of a circle; missing ones at the end are kNoSlot

constexpr double kTooWide = 0x1p-40;  // width of an interval, relative to the values in it

/// Power of the smallest circle orthogonal to the balls: the least power that all of them have at one point.
template <class Number>
Number power_of(const BallOf<Number>& a) {
  return Number(0) - a.w;
}
template <class Number>
Number power_of(const BallOf<Number>& a, const BallOf<Number>& b) {
  const Number x = b.x - a.x, y = b.y - a.y;
  const Number dd = x * x + y * y;
  const Number pb = dd + (a.w - b.w);
  return pb * pb / (Number(4) * dd) - a.w;
}
template <class Number>
Number power_of(const BallOf<Number>& a, const BallOf<Number>& b, const BallOf<Number>& c) {
  const Number bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Number pb = bx * bx + by * by + (a.w - b.w);
  const Number pc = cx * cx + cy * cy + (a.w - c.w);
  const Number det = bx * cy - by * cx;
  const Number nx = pb * cy - pc * by;
  const Number ny = pc * bx - pb * cx;
  return (nx * nx + ny * ny) / (Number(4) * det * det) - a.w;
}

/// `ball(slot)` returns a ball in the required numbers.
template <class Ball>
auto power_of_span(const Span& span, Ball ball) {
  if (span[1] == kNoSlot) return power_of(ball(span[0]));
  if (span[2] == kNoSlot) return power_of(ball(span[0]), ball(span[1]));
  return power_of(ball(span[0]), ball(span[1]), ball(span[2]));
}

/// Balls of Voronoi vertices that touch one sample have the power 0 there.
bool is_known_zero(const PipelineInput& input, const Span& span) {
  return span[2] != kNoSlot &&
         common_sample(input.balls[span[0]], input.balls[span[1]], input.balls[span[2]]) != nullptr;
}

Rational exact_power(const PipelineInput& input, const Span& span) {
  if (is_known_zero(input, span)) return Rational(0);
  return power_of_span(span, [&](InputSlot ball) { return ball_in<Rational>(input.balls[ball]); });
}

/// A circle, and an interval that holds its power.
struct SpannedPower {
  Span span{};
  double low = 0.0;
  double high = 0.0;

  void set(const std::pair<double, double>& ends) { std::tie(low, high) = ends; }
};

class BirthSearch {
 public:
  BirthSearch(const PipelineInput& input, JobControl& job) : input_(input), job_(job), balls_(input) {}

  BallBirths run() {
    tables_ = in_share(job_, 0.25, [this] { return first_triangulation(balls_, job_); });
    find_circles();
    find_ranks();
    find_attached_ranks();
    return in_order();
  }

 private:
  static constexpr std::uint32_t kUnknown = 0xffffffffU;

  void add_circle(Span span, std::uint32_t& index_of) {
    index_of = static_cast<std::uint32_t>(circles_.size());
    circles_.push_back({span});
    if ((circles_.size() & 0xfffU) == 0) job_.checkpoint();
  }

  void find_circles() {
    const auto& ball = balls_.in_balls;
    of_triangle_.assign(tables_.faces.size(), kUnknown);
    of_edge_.assign(tables_.edges.size(), kUnknown);
    of_ball_.assign(input_.balls.size(), kUnknown);
    // Starts from the ball with the smallest radius, so that the subtraction at the end loses least.
    const auto sorted = [&](Span span, std::size_t count) {
      std::ranges::sort(span.begin(), span.begin() + static_cast<std::ptrdiff_t>(count),
                        [&](InputSlot a, InputSlot b) {
                          const double x = input_.balls[a].radius();
                          const double y = input_.balls[b].radius();
                          return x != y ? x < y : balls_.comes_before(a, b);
                        });
      return span;
    };
    for (const TriangleSlot f : tables_.faces.rows()) {
      if (tables_.is_infinite(f)) continue;
      const auto& v = tables_.faces[f].v;
      add_circle(sorted({v[0], v[1], v[2]}, 3), of_triangle_[f]);
    }
    std::vector<bool> has_lost_center(input_.balls.size(), false);
    attached_to_.assign(tables_.edges.size(), TriangleSlot());
    for (const RegularEdgeSlot e : tables_.edges.rows()) {
      const RegularTables::Edge& edge = tables_.edges[e];
      const InputSlot a = edge.v[0];
      const InputSlot b = edge.v[1];
      if (loses_center_to<ExactKernel>(ball[a], ball[b])) has_lost_center[a.index()] = true;
      if (loses_center_to<ExactKernel>(ball[b], ball[a])) has_lost_center[b.index()] = true;
      for (const TriangleSlot f : edge.f) {
        if (f == kNoSlot || tables_.is_infinite(f)) continue;
        const auto& v = tables_.faces[f].v;
        const auto apex = std::ranges::find_if(v, [&](InputSlot i) { return i != a && i != b; });
        if (sign_of_excess_at_foot<ExactKernel>(ball[a], ball[b], ball[*apex]) < 0) attached_to_[e] = f;
      }
      if (attached_to_[e] == kNoSlot) add_circle(sorted({a, b, kNoSlot}, 2), of_edge_[e]);
    }
    for (const InputSlot i : tables_.state.rows())
      if (is_visible(i) && !has_lost_center[i.index()]) add_circle({i, kNoSlot, kNoSlot}, of_ball_[i]);
    measure();
  }

  bool is_visible(InputSlot i) const {
    return tables_.state[i] != BallState::hidden && tables_.state[i] != BallState::duplicate;
  }

  void measure() {
    Table<InputSlot, BallOf<Interval>> ball;
    ball.reserve(input_.balls.size());
    for (const auto& exact : balls_.in_balls) ball.push_back({exact.x.approx(), exact.y.approx(), exact.w.approx()});
    const CGAL::Protect_FPU_rounding<true> rounding;
    for (SpannedPower& circle : circles_) {
      if (is_known_zero(input_, circle.span)) continue;
      const Interval power = power_of_span(circle.span, [&](InputSlot i) { return ball[i]; });
      circle.low = power.inf();
      circle.high = power.sup();
    }
  }

  void find_ranks() {
    // An interval that is too wide would be compared with many others.
    std::size_t looks = 0;
    for (SpannedPower& circle : circles_) {
      const double size = std::max(std::abs(circle.low), std::abs(circle.high));
      if (std::isfinite(size) && circle.high - circle.low <= kTooWide * size) continue;
      circle.set(CGAL::to_interval(exact_power(input_, circle.span)));
      if (++looks % 256 == 0) job_.checkpoint();
    }
    std::vector<std::uint32_t> order(circles_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [this](std::uint32_t i) { return circles_[i].low; });
    rank_.resize(circles_.size());
    for (std::size_t begin = 0; begin < order.size();) {
      double high = circles_[order[begin]].high;
      std::size_t end = begin + 1;
      for (; end < order.size() && circles_[order[end]].low <= high; ++end)
        high = std::max(high, circles_[order[end]].high);
      rank_run(std::span(order).subspan(begin, end - begin));
      begin = end;
    }
  }

  /// Ranks circles whose intervals overlap one another.
  void rank_run(std::span<const std::uint32_t> run) {
    const auto rank_of_first = static_cast<std::uint32_t>(levels_.size());
    const bool is_one = run.size() == 1 || std::ranges::all_of(run, [&](std::uint32_t i) {
                          return circles_[i].low == circles_[i].high && circles_[i].low == circles_[run[0]].low;
                        });
    if (is_one) {
      for (const std::uint32_t i : run) rank_[i] = rank_of_first;
      add_level(circles_[run[0]]);
      return;
    }
    struct Exact {
      Rational power;
      std::uint32_t circle = 0;
    };
    std::vector<Exact> exact;
    exact.reserve(run.size());
    for (const std::uint32_t i : run) {
      exact.push_back({exact_power(input_, circles_[i].span), i});
      if (exact.size() % 256 == 0) job_.checkpoint();
    }
    std::size_t looks = 0;
    std::ranges::sort(exact, [&](const Exact& a, const Exact& b) {
      if (++looks % 1024 == 0) job_.checkpoint();
      return a.power < b.power;
    });
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (i == 0 || exact[i - 1].power != exact[i].power) {
        SpannedPower circle = circles_[exact[i].circle];
        circle.set(CGAL::to_interval(exact[i].power));
        add_level(circle);
      }
      rank_[exact[i].circle] = static_cast<std::uint32_t>(levels_.size() - 1);
    }
  }
  void add_level(const SpannedPower& circle) { levels_.push_back({circle.low, circle.high, circle.span}); }

  void find_attached_ranks() {
    const auto replace = [this](auto& table) {
      for (std::uint32_t& index : table)
        if (index != kUnknown) index = rank_[index];
    };
    replace(of_triangle_);
    replace(of_edge_);
    replace(of_ball_);
    Table<InputSlot, std::uint32_t> first(input_.balls.size(), kUnknown);
    for (const RegularEdgeSlot e : tables_.edges.rows()) {
      if (attached_to_[e] != kNoSlot) of_edge_[e] = of_triangle_[attached_to_[e]];
      for (const InputSlot i : tables_.edges[e].v) first[i] = std::min(first[i], of_edge_[e]);
    }
    for (const InputSlot i : of_ball_.rows())
      if (is_visible(i) && of_ball_[i] == kUnknown) of_ball_[i] = first[i];
  }

  template <std::size_t count>
  std::array<Vec2, count> centers(const InputSlot (&v)[count]) const {
    std::array<Vec2, count> out;
    for (std::size_t i = 0; i < count; ++i) out[i] = input_.balls[v[i]].disk.center;
    std::ranges::sort(out, lexicographically_less);
    return out;
  }
  /// Existing rows, sorted by rank and, where ranks are equal, by centre.
  template <class Row, class Places>
  std::vector<Row> sorted_rows(const Table<Row, std::uint32_t>& rank, Places places) const {
    std::vector<Row> out;
    out.reserve(rank.size());
    for (const Row row : rank.rows())
      if (rank[row] != kUnknown) out.push_back(row);
    std::ranges::sort(out, [&](Row a, Row b) {
      if (rank[a] != rank[b]) return rank[a] < rank[b];
      const auto p = places(a);
      const auto q = places(b);
      if (p != q) return std::ranges::lexicographical_compare(p, q, lexicographically_less);
      return a < b;
    });
    return out;
  }

  BallBirths in_order() {
    job_.checkpoint();
    BallBirths out;
    out.levels = std::move(levels_);
    const auto balls = sorted_rows(of_ball_, [&](InputSlot i) { return std::array{input_.balls[i].disk.center}; });
    const auto edges = sorted_rows(of_edge_, [&](RegularEdgeSlot e) { return centers(tables_.edges[e].v); });
    const auto faces = sorted_rows(of_triangle_, [&](TriangleSlot f) { return centers(tables_.faces[f].v); });
    out.hidden = input_.balls.size() - balls.size();
    Table<InputSlot, GrownCornerSlot> corner_of(input_.balls.size());
    for (const InputSlot i : balls) {
      corner_of[i] = out.corners.next();
      out.corners.push_back({i, of_ball_[i]});
    }
    Table<TriangleSlot, GrownTriangleSlot> triangle_of(tables_.faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) triangle_of[faces[i]] = GrownTriangleSlot(i);
    // Positions for drawing; nothing is decided by them.
    Table<InputSlot, BallOf<double>> rounded_balls;
    rounded_balls.reserve(input_.balls.size());
    for (const PipelineBall& ball : input_.balls) rounded_balls.push_back(ball_in<double>(ball));
    const PowerCenters power = power_centers(input_, rounded_balls, tables_, job_);
    for (const TriangleSlot f : faces) {
      const RegularTables::Face& face = tables_.faces[f];
      BallBirths::Triangle row{.rank = of_triangle_[f], .center = power.center[f].document};
      for (std::size_t i = 0; i < 3; ++i) {
        row.v[i] = corner_of[face.v[i]];
        row.n[i] = triangle_of[face.n[i]];
      }
      out.triangles.push_back(row);
    }
    std::vector<BallPair> ends;
    ends.reserve(edges.size());
    for (const RegularEdgeSlot e : edges) ends.push_back({tables_.edges[e].v[0], tables_.edges[e].v[1]});
    const std::vector<RadicalAxis> axes = radical_axes(input_, ends, job_);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const RegularEdgeSlot e = edges[k];
      const RegularTables::Edge& edge = tables_.edges[e];
      BallBirths::Edge row{.v = {corner_of[edge.v[0]], corner_of[edge.v[1]]}, .rank = of_edge_[e], .axis = axes[k]};
      for (std::size_t side = 0; side < 2; ++side) {
        if (edge.f[side] == kNoSlot) continue;
        row.f[side] = triangle_of[edge.f[side]];
        if (row.f[side] == kNoSlot) continue;
        BallBirths::Triangle& triangle = out.triangles[row.f[side]];
        for (std::size_t i = 0; i < 3; ++i)
          if (triangle.v[i] != row.v[0] && triangle.v[i] != row.v[1]) triangle.e[i] = out.edges.next();
      }
      out.edges.push_back(row);
    }
    return out;
  }

  const PipelineInput& input_;
  JobControl& job_;
  Balls balls_;
  RegularTables tables_;
  std::vector<SpannedPower> circles_;
  std::vector<std::uint32_t> rank_;  // by circle
  std::vector<BallBirths::Level> levels_;
  // These hold first the circle, then its rank.
  Table<TriangleSlot, std::uint32_t> of_triangle_;
  Table<RegularEdgeSlot, std::uint32_t> of_edge_;
  Table<InputSlot, std::uint32_t> of_ball_;
  Table<RegularEdgeSlot, TriangleSlot> attached_to_;
};

}  // namespace

BallBirths ball_births(const PipelineInput& input, JobControl& job) {
  if (input.balls.size() == 0) return {};
  return BirthSearch(input, job).run();
}

std::uint32_t levels_within(const PipelineInput& input, const std::vector<BallBirths::Level>& levels, double radius) {
  // The radius in the frame need not be a double.
  const auto square = [&] {
    const Rational r = Rational(radius) / Rational(std::ldexp(1.0, input.frame.exponent));
    return Rational(r * r);
  };
  const double local = input.frame.to_local_length(radius);
  const double about = local * local;
  const bool is_normal = about > 0x1p-900 && about < 0x1p900;
  std::optional<Rational> exact;
  const auto has_come = [&](const BallBirths::Level& level) {
    if (is_normal && level.high < about * (1.0 - 0x1p-50)) return true;
    if (is_normal && level.low > about * (1.0 + 0x1p-50)) return false;
    if (level.high <= 0.0) return true;
    if (!exact) exact = square();
    return exact_power(input, level.balls) <= *exact;
  };
  return static_cast<std::uint32_t>(std::ranges::partition_point(levels, has_come) - levels.begin());
}

}  // namespace mes
