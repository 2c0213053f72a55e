// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/tools/snapper.h"

#include <cmath>

#include "core/curves/nearest_place.h"

namespace mes {

std::optional<Snap> Snapper::at(Vec2 p, double reach, const Except& except) const {
  if (!settings_.is_on) return std::nullopt;
  if (auto snap = point_at(p, reach, except)) return snap;
  const auto on_circle = circle_at(p, reach, except);
  const auto on_curve = curve_at(p, on_circle ? distance(p, on_circle->place) : reach);
  if (on_curve) return on_curve;
  if (on_circle) return on_circle;
  const Steps steps = steps_();
  if (settings_.grid)
    if (const auto on_grid = lines_at(p, reach, steps.grid)) return on_grid;
  auto pixel = settings_.pixels ? lines_at(p, steps.pixel, steps.pixel) : std::nullopt;
  if (pixel) pixel->name = "pixel";
  return pixel;
}

std::optional<Snap> Snapper::curve_at(Vec2 p, double reach) const {
  const CurveSource* const source = editor_.document().source().get();
  if (!settings_.curves || source == nullptr) return std::nullopt;
  const auto place = nearest_place(*source->curves, p, reach);
  return place ? std::optional(Snap{*place, "curve"}) : std::nullopt;
}

std::optional<Snap> Snapper::point_at(Vec2 p, double reach, const Except& except) const {
  const Document& document = editor_.document();
  std::optional<Snap> best;
  double nearest = reach;
  const auto offer = [&](Vec2 place, std::string_view name) {
    const double away = distance(p, place);
    if (away > nearest || (best && away == nearest)) return;
    nearest = away;
    best = Snap{place, name};
  };
  if (settings_.samples)
    for (const SampleSlot slot : editor_.index().in_box({p - Vec2{reach, reach}, p + Vec2{reach, reach}}))
      if (!except.sample || !except.sample(slot)) offer(document.position(slot), "sample");
  if (settings_.centers)
    for (const BallSlot slot : editor_.centers().in_box({p - Vec2{reach, reach}, p + Vec2{reach, reach}}))
      if (!except.ball || !except.ball(slot)) offer(document.disk(slot).center, "centre of a ball");
  if (settings_.vertices && !except.vertices)
    if (const Anchor vertex = vertices_.anchor_at(p, reach, true); vertex.samples.size() == 3)
      offer(vertex.at, "Voronoi vertex");
  return best;
}

std::optional<Snap> Snapper::circle_at(Vec2 p, double reach, const Except& except) const {
  if (!settings_.circles) return std::nullopt;
  const Document& document = editor_.document();
  std::optional<Snap> best;
  double nearest = reach;
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count())) {
    if (!document.is_ball_alive(slot) || (except.ball && except.ball(slot))) continue;
    const Disk& disk = document.disk(slot);
    const Vec2 from_center = p - disk.center;
    const double far = length(from_center);
    const double away = std::abs(far - disk.radius);
    if (far == 0.0 || away > nearest) continue;
    nearest = away;
    best = Snap{disk.center + (disk.radius / far) * from_center, "circle of a ball"};
  }
  return best;
}

std::optional<Snap> Snapper::lines_at(Vec2 p, double reach, double step) {
  if (!(step > 0.0)) return std::nullopt;
  // For steps below 1, the inverse is a whole number and exact down to steps of 1e-22, so the quotient of two exact
  // numbers is rounded only once.
  const double inverse = std::round(1.0 / step);
  const auto on_line = [&](double x) {
    const double k = std::round(x / step);
    return step < 1.0 ? k / inverse : k * step;
  };
  const Vec2 crossing{on_line(p.x), on_line(p.y)};
  const bool is_on_x = std::abs(crossing.x - p.x) <= reach;
  const bool is_on_y = std::abs(crossing.y - p.y) <= reach;
  if (!is_on_x && !is_on_y) return std::nullopt;
  return Snap{{is_on_x ? crossing.x : p.x, is_on_y ? crossing.y : p.y},
              is_on_x && is_on_y ? "grid" : "line of the grid"};
}

}  // namespace mes
