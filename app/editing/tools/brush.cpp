// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/tools/brush.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/base/jobs/job_control.h"
#include "core/document/live_corners.h"
#include "core/evolutions/moving_curve.h"

namespace mes {
namespace {

/// Samples in input order, as far from the brush as is necessary. It looks farther where samples are few, since two
/// samples do not show a curve, and returns nothing if there are too many even under the brush.
std::optional<std::vector<SampleSlot>> samples_near(const Editor& editor, Vec2 at, double radius) {
  constexpr double kReach = 3.0;
  constexpr double kFarthest = 48.0;
  constexpr std::array kNear{1.5, 1.0};
  constexpr std::size_t kEnough = 24;
  const auto within = [&](double reach) {
    const Vec2 corner{reach * radius, reach * radius};
    return editor.index().in_box({at - corner, at + corner});
  };
  std::vector<SampleSlot> out = within(kReach);
  for (double reach = 2 * kReach; reach <= kFarthest && out.size() < kEnough; reach *= 2) {
    if (out.size() == editor.document().sample_count()) break;
    std::vector<SampleSlot> wider = within(reach);
    if (wider.size() > BrushStroke::kMostSamples) break;
    out = std::move(wider);
  }
  for (const double reach : kNear)
    if (out.size() > BrushStroke::kMostSamples) out = within(reach);
  if (out.size() > BrushStroke::kMostSamples) return std::nullopt;
  std::ranges::sort(out, {}, [&](SampleSlot slot) { return editor.document().id(slot); });
  return out;
}

/// Curvature of the circle through three consecutive points; positive for a left turn.
double curvature(Vec2 a, Vec2 b, Vec2 c) {
  const double sides = distance(a, b) * distance(b, c) * distance(a, c);
  return sides > 0.0 ? 2.0 * cross(b - a, c - b) / sides : 0.0;
}

/// A point between a and b on an arc whose curvature is the mean of those at both. It is the midpoint if the arc
/// would span more than a sixth of a turn, as at corners. A neighbour is null where the curve ends.
Vec2 middle_of_arc(const Vec2* before, Vec2 a, Vec2 b, const Vec2* after) {
  const Vec2 middle = 0.5 * (a + b);
  double bend = 0.0;
  if (before != nullptr) bend += curvature(*before, a, b);
  if (after != nullptr) bend += curvature(a, b, *after);
  if (before != nullptr && after != nullptr) bend *= 0.5;
  const double chord = distance(a, b);
  const double sine = 0.5 * bend * chord;  // sine of half the angle that the arc spans
  constexpr double kMost = 0.5;
  if (chord == 0.0 || std::abs(sine) > kMost) return middle;
  // The height of the arc over its chord is chord / 2 times the tangent of a quarter of its angle.
  const double height = 0.5 * chord * std::tan(0.5 * std::asin(sine));
  return middle - (height / chord) * perpendicular(b - a);
}

}  // namespace

Expected<void> BrushStroke::touch(Vec2 at, double radius, BrushMode mode) {
  return mode == BrushMode::erase ? erase(at, radius) : along_curve(at, radius, mode);
}

Expected<void> BrushStroke::erase(Vec2 at, double radius) {
  const Document& document = editor_.document();
  const Vec2 corner{radius, radius};
  std::vector<SampleId> samples;
  for (const SampleSlot slot : editor_.index().in_box({at - corner, at + corner}))
    if (distance(document.position(slot), at) <= radius) samples.push_back(document.id(slot));
  std::vector<BallId> balls;
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count()))
    if (document.is_ball_alive(slot) && distance(document.disk(slot).center, at) <= radius)
      balls.push_back(document.ball_id(slot));
  if (samples.empty() && balls.empty()) return {};
  return editor_.remove(samples, balls, "Erase");
}

Expected<void> BrushStroke::along_curve(Vec2 at, double radius, BrushMode mode) try {
  const Document& document = editor_.document();
  const auto near = samples_near(editor_, at, radius);
  if (!near) {
    if (std::exchange(is_refused_, true)) return {};
    return std::unexpected(
        Error{ErrorCode::cannot_compute,
              fmt::format("more than {} samples lie under the brush: too many to follow their curve; "
                          "zoom in, or make it smaller",
                          kMostSamples)});
  }
  const std::vector<SampleSlot>& slots = *near;
  if (slots.size() < 2) return {};
  std::vector<Vec2> positions;
  for (const SampleSlot slot : slots) positions.push_back(document.position(slot));
  JobControl job;
  const MovingCurve curve = crust_curve(positions, job);
  const auto is_under = [&](std::uint32_t i) { return distance(positions[i], at) <= radius; };
  const auto id = [&](std::uint32_t i) { return document.id(slots[i]); };

  std::vector<SampleId> removed;
  std::vector<Vec2> inserted;
  std::vector<Pair> between;
  for (const MovingCurve::Chain& chain : curve.chains) {
    const std::vector<std::uint32_t>& p = chain.points;
    const std::size_t count = p.size();
    const auto is_there = [&](std::size_t i, int step) {
      return chain.closed ||
             (step < 0 ? i >= static_cast<std::size_t>(-step) : i + static_cast<std::size_t>(step) < count);
    };
    const auto neighbor = [&](std::size_t i, int step) {
      return p[(i + count + static_cast<std::size_t>(step + static_cast<int>(count))) % count];
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (mode == BrushMode::thin) {
        if (!is_under(p[i])) continue;
        // Keeps the ends of a curve, and the last samples of a loop.
        constexpr std::size_t kSmallestLoop = 5;
        if (!is_there(i, -1) || !is_there(i, 1) || (chain.closed && count < kSmallestLoop)) continue;
        if (kept_.contains(id(p[i]))) continue;
        kept_.insert(id(neighbor(i, -1)));
        kept_.insert(id(neighbor(i, 1)));
        removed.push_back(id(p[i]));
        continue;
      }
      if (!is_there(i, 1)) continue;
      const Vec2 a = positions[p[i]];
      const Vec2 b = positions[neighbor(i, 1)];
      const Pair pair = std::minmax(id(p[i]), id(neighbor(i, 1)));
      if (refined_.contains(pair)) continue;
      const Vec2* const before = is_there(i, -1) && count > 2 ? &positions[neighbor(i, -1)] : nullptr;
      const Vec2* const after = is_there(i, 2) && count > 2 ? &positions[neighbor(i, 2)] : nullptr;
      const Vec2 middle = middle_of_arc(before, a, b, after);
      if (middle == a || middle == b) continue;
      // Neighbours may be farther apart than the width of the brush.
      const bool is_met = distance(middle, at) <= radius || (is_under(p[i]) && is_under(neighbor(i, 1)));
      if (!is_met) continue;
      inserted.push_back(middle);
      between.push_back(pair);
    }
  }
  if (!removed.empty()) return editor_.remove(removed, "Thin out");
  if (inserted.empty()) return {};
  const auto rows = editor_.insert(inserted, "Refine");
  if (!rows) return std::unexpected(rows.error());
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const SampleId added = document.id((*rows)[i]);
    between_.emplace(between[i], added);
    refined_.insert(std::minmax(between[i].first, added));
    refined_.insert(std::minmax(between[i].second, added));
  }
  return {};
} catch (const GeometryError& problem) {
  return std::unexpected(Error{ErrorCode::cannot_compute, problem.what()});
}

Expected<void> BrushStroke::finish() {
  const Document& document = editor_.document();
  const auto is_alive = [&](SampleId id) { return document.slot_of(id) != kNoSlot; };
  CurveOrder contours;
  bool is_changed = false;
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    const std::vector<SampleId> alive = live_corners(document, contour);
    CurveOrder::Contour& out = contours.contours.emplace_back(CurveOrder::Contour{contour.closed, {}});
    for (std::size_t i = 0; i < alive.size(); ++i) {
      out.samples.push_back(alive[i]);
      const bool is_last = i + 1 == alive.size();
      if (is_last && (!contour.closed || alive.size() < 3)) continue;
      const auto added = between_.find(std::minmax(alive[i], alive[is_last ? 0 : i + 1]));
      if (added == between_.end() || !is_alive(added->second)) continue;
      out.samples.push_back(added->second);
      is_changed = true;
    }
    if (out.samples.empty()) contours.contours.pop_back();
  }
  between_.clear();
  if (!is_changed) return {};
  return editor_.set_contours(std::move(contours), "Refine");
}

}  // namespace mes
