// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edit/frame_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/edit/arrangement.h"

namespace mes {
namespace {

constexpr double kMarginPx = 12.0;
constexpr double kLeastPx = 40.0;  // minimum size of the frame, so that its handles do not overlap
constexpr double kStemPx = 18.0;   // distance of the rotation handle from the frame
constexpr double kStep = 15.0;     // degrees

// Position of a handle on each axis: -1 or 1 for an end of the box, 0 for the middle.
struct Ends {
  int x = 0;
  int y = 0;
};
constexpr std::array<Ends, kHandles> kEnds{
    {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {0, 1}}};

Ends ends_of(Handle handle) {
  return kEnds[static_cast<std::size_t>(handle)];
}

double at_end(double low, double high, int end) {
  return end < 0 ? low : end > 0 ? high : 0.5 * low + 0.5 * high;
}

Vec2 at_ends(const Box2& box, Ends ends) {
  return {at_end(box.low.x, box.high.x, ends.x), at_end(box.low.y, box.high.y, ends.y)};
}

Vec2 middle_of_box(const Box2& box) {
  return at_ends(box, {});
}

void widen(double& low, double& high, double units_per_pixel) {
  const double margin = std::max(kMarginPx, 0.5 * (kLeastPx - (high - low) / units_per_pixel)) * units_per_pixel;
  low -= margin;
  high += margin;
}

std::optional<Dragged> turned_by(std::span<const Vec2> places, const Box2& box, const HandleDrag& drag) {
  const Vec2 middle = middle_of_box(box);
  const Vec2 before = drag.from - middle;
  const Vec2 now = drag.to - middle;
  Dragged out;
  out.degrees = std::atan2(cross(before, now), dot(before, now)) * 180.0 / std::numbers::pi;
  if (drag.in_steps) out.degrees = kStep * std::round(out.degrees / kStep);
  out.places = turned(places, middle, out.degrees);
  return out;
}

// Scales a coordinate about the fixed point; the held point gets the wanted coordinate without rounding.
double stretched(double x, double about, double factor, double held, double wanted) {
  return x == held ? wanted : about + factor * (x - about);
}

}  // namespace

HandleFrame::HandleFrame(const Box2& box, double units_per_pixel)
    : box_(box), outline_(box), units_per_pixel_(units_per_pixel) {
  widen(outline_.low.x, outline_.high.x, units_per_pixel);
  widen(outline_.low.y, outline_.high.y, units_per_pixel);
}

bool HandleFrame::has(Handle handle) const {
  if (handle == Handle::turn) return true;
  const Ends ends = ends_of(handle);
  return (ends.x == 0 || box_.width() > 0.0) && (ends.y == 0 || box_.height() > 0.0);
}

Vec2 HandleFrame::at(Handle handle) const {
  const Vec2 place = at_ends(outline_, ends_of(handle));
  return handle == Handle::turn ? place + Vec2{0.0, kStemPx * units_per_pixel_} : place;
}

std::optional<Handle> HandleFrame::handle_at(Vec2 p, double reach) const {
  std::optional<Handle> best;
  for (std::size_t i = 0; i < kHandles; ++i) {
    const auto handle = static_cast<Handle>(i);
    const double away = distance(p, at(handle));
    if (!has(handle) || away > reach) continue;
    reach = away;
    best = handle;
  }
  return best;
}

Vec2 held_place(const Box2& box, Handle handle) {
  return at_ends(box, ends_of(handle));
}

std::optional<Dragged> dragged(std::span<const Vec2> places, const Box2& box, const HandleDrag& drag) {
  if (drag.handle == Handle::turn) return turned_by(places, box, drag);
  const Ends ends = ends_of(drag.handle);
  const Vec2 held = held_place(box, drag.handle);
  const Vec2 about = drag.about_middle ? middle_of_box(box) : at_ends(box, {-ends.x, -ends.y});
  const Vec2 reach = held - about;
  Dragged out;
  Vec2 wanted = drag.to;
  if (ends.x != 0 && ends.y != 0) {
    // Project the pointer onto the diagonal.
    const double factor = dot(drag.to - about, reach) / dot(reach, reach);
    out.factor = {factor, factor};
    out.radius_factor = std::abs(factor);
    wanted = about + factor * reach;
  } else if (ends.x != 0) {
    out.factor.x = (drag.to.x - about.x) / reach.x;
  } else {
    out.factor.y = (drag.to.y - about.y) / reach.y;
  }
  if (out.factor.x == 0.0 || out.factor.y == 0.0 || !std::isfinite(out.factor.x) || !std::isfinite(out.factor.y))
    return std::nullopt;
  out.places.reserve(places.size());
  for (Vec2 p : places) {
    if (ends.x != 0) p.x = stretched(p.x, about.x, out.factor.x, held.x, wanted.x);
    if (ends.y != 0) p.y = stretched(p.y, about.y, out.factor.y, held.y, wanted.y);
    out.places.push_back(p);
  }
  return out;
}

}  // namespace mes
