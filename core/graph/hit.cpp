// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graph/hit.h"

#include <algorithm>
#include <cmath>

#include "core/draw/primitive_values.h"

namespace mes {
namespace {

/// Distance of `p` from a + t d for t in [low, high].
double distance_to_line(Vec2 p, Vec2 a, Vec2 d, double low, double high) {
  const double size = dot(d, d);
  const double t = size > 0.0 ? std::clamp(dot(p - a, d) / size, low, high) : 0.0;
  return distance(p, a + t * d);
}

}  // namespace

void HitSearch::look_at(PrimitiveKind kind, const double* v, ElementType type, RowNumber row) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Vec2 a{v[0], v[1]};
  int rank = 1;
  double measure = kFar;
  switch (kind) {
    case PrimitiveKind::point:
      rank = 0;
      measure = distance(at_, a);
      break;
    case PrimitiveKind::circle: measure = std::abs(distance(at_, a) - v[2]); break;
    case PrimitiveKind::segment: measure = distance_to_line(at_, a, Vec2{v[2], v[3]} - a, 0.0, 1.0); break;
    case PrimitiveKind::ray: measure = distance_to_line(at_, a, {v[2], v[3]}, 0.0, kFar); break;
    case PrimitiveKind::line: measure = distance_to_line(at_, a, {v[2], v[3]}, -kFar, kFar); break;
    case PrimitiveKind::arc: {
      const Vec2 from{v[3], v[4]};
      const Vec2 to{v[5], v[6]};
      // Outside the arc's sweep, the nearest point of the arc is an end.
      const bool is_beside = from == to || sweep_of({a, v[2], from, at_}) <= sweep_of({a, v[2], from, to});
      measure = is_beside ? std::abs(distance(at_, a) - v[2]) : std::min(distance(at_, from), distance(at_, to));
      break;
    }
    case PrimitiveKind::parabola: measure = distance_to(parabola_of(v), at_); break;
    case PrimitiveKind::disk:
      rank = 2;
      if (distance(at_, a) <= v[2]) measure = v[2] * v[2];
      break;
    case PrimitiveKind::triangle: {
      rank = 2;
      const Vec2 b{v[2], v[3]};
      const Vec2 c{v[4], v[5]};
      const double area = cross(b - a, c - a);
      const double sign = area < 0.0 ? -1.0 : 1.0;
      const bool holds = sign * cross(b - a, at_ - a) >= 0.0 && sign * cross(c - b, at_ - b) >= 0.0 &&
                         sign * cross(a - c, at_ - c) >= 0.0;
      if (holds) measure = std::abs(area);
      break;
    }
  }
  if (!(measure < kFar) || (rank < 2 && measure > reach_)) return;
  if (rank > best_rank_ || (rank == best_rank_ && measure >= best_measure_)) return;
  best_rank_ = rank;
  best_measure_ = measure;
  best_.emplace();
  best_->element = {type, row};
  best_->shape.kind = kind;
  std::copy_n(v, doubles_per(kind), best_->shape.values.begin());
}

}  // namespace mes
