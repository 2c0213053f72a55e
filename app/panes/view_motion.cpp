// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panes/view_motion.h"

#include <algorithm>
#include <cmath>

namespace mes {
namespace {

constexpr double kZoomTime = 0.055;   // seconds after which 1/e of a zoom is left; longer feels like rubber
constexpr double kFlightTime = 0.28;  // seconds; long enough to see the direction
constexpr double kRest = 0.8;         // seconds without motion after which the next one starts from a new view
constexpr double kDoneZoom = 1e-3;    // a thousandth: below a pixel even at the rim of a large screen
constexpr std::size_t kRemembered = 64;

double ease(double t) {
  return t * t * (3.0 - 2.0 * t);
}

// Zooms about the point that both views share, or pans if the scales are equal.
render::Camera between(const render::Camera& from, const render::Camera& to, double t) {
  render::Camera out = to;
  const double a = from.units_per_pixel();
  const double b = to.units_per_pixel();
  const double scale = a * std::pow(b / a, t);
  const double way = std::abs(b / a - 1.0) < 1e-6 ? t : (scale - a) / (b - a);
  out.look_at(from.center() + way * (to.center() - from.center()), scale);
  return out;
}

// The scale of a drawing that fills the free area; 0 if there is none.
double fitting_scale(const Insets& insets, Vec2 viewport, Vec2 size) {
  const double width = std::max(0.0, viewport.x - insets.left - insets.right);
  const double height = std::max(0.0, viewport.y - insets.top - insets.bottom);
  return std::min(width / size.x, height / size.y);
}

}  // namespace

Insets clear_of_corner(const Insets& insets, Vec2 viewport, Vec2 corner, Vec2 size) {
  if (corner.x <= 0.0 || corner.y <= 0.0) return insets;
  // For a drawing without extent only its position matters.
  size = {std::max(size.x, 1e-300), std::max(size.y, 1e-300)};
  const double scale = fitting_scale(insets, viewport, size);
  const double width = viewport.x - insets.left - insets.right;
  const double height = viewport.y - insets.top - insets.bottom;
  const bool is_free =
      0.5 * (width + scale * size.x) <= width - corner.x || 0.5 * (height + scale * size.y) <= height - corner.y;
  if (is_free) return insets;
  Insets beside = insets;
  beside.right += corner.x;
  Insets above = insets;
  above.bottom += corner.y;
  const double best = fitting_scale(above, viewport, size);
  return fitting_scale(beside, viewport, size) > best ? beside : above;
}

void ViewMotion::set_viewport(int width, int height) {
  if (width == camera_.width() && height == camera_.height()) return;
  // The upper left corner keeps its position on screen: resizing uncovers the drawing but does not shift it.
  const Vec2 grown{0.5 * (width - camera_.width()), 0.5 * (height - camera_.height())};
  camera_.set_viewport(width, height);
  camera_.pan(-grown);
  flight_.reset();
}

Vec2 ViewMotion::middle() const {
  return {0.5 * (insets_.left + camera_.width() - insets_.right),
          0.5 * (insets_.top + camera_.height() - insets_.bottom)};
}

Box2 ViewMotion::free_box() const {
  Box2 out;
  out.add(camera_.to_world({insets_.left, insets_.top}));
  out.add(camera_.to_world({camera_.width() - insets_.right, camera_.height() - insets_.bottom}));
  return out;
}

void ViewMotion::remember() {
  if (!earlier_.empty() && earlier_.back() == camera_) return;
  earlier_.push_back(camera_);
  if (earlier_.size() > kRemembered) earlier_.erase(earlier_.begin());
}

void ViewMotion::zoom_at(Vec2 px, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  if (rest_ > kRest) remember();
  flight_.reset();
  zoom_px_ = px;
  pending_zoom_ += std::log(factor);
  is_as_fitted_ = false;
  rest_ = 0.0;
}

void ViewMotion::pan(Vec2 delta_px) {
  if (rest_ > kRest) remember();
  flight_.reset();
  camera_.pan(delta_px);
  zoom_px_ = zoom_px_ + delta_px;
  is_as_fitted_ = false;
  rest_ = 0.0;
}

render::Camera ViewMotion::fitted(const Box2& box, double margin_px) const {
  render::Camera free = camera_;
  free.set_viewport(std::max(1, static_cast<int>(camera_.width() - insets_.left - insets_.right)),
                    std::max(1, static_cast<int>(camera_.height() - insets_.top - insets_.bottom)));
  free.fit(box, margin_px);
  render::Camera out = free;
  out.set_viewport(camera_.width(), camera_.height());
  out.pan(middle() - Vec2{0.5 * camera_.width(), 0.5 * camera_.height()});
  return out;
}

void ViewMotion::fly_to(const render::Camera& goal) {
  pending_zoom_ = 0.0;
  rest_ = 0.0;
  if (goal == camera_) return;
  flight_ = Flight{camera_, goal, 0.0};
}

void ViewMotion::fit(const Box2& box, double margin_px, bool at_once) {
  is_as_fitted_ = true;
  ++fits_;
  if (at_once) {
    flight_.reset();
    pending_zoom_ = 0.0;
    camera_ = fitted(box, margin_px);
    return;
  }
  remember();
  fly_to(fitted(box, margin_px));
}

void ViewMotion::back() {
  while (!earlier_.empty()) {
    render::Camera goal = earlier_.back();
    earlier_.pop_back();
    goal.set_viewport(camera_.width(), camera_.height());
    if (goal == camera_) continue;
    fly_to(goal);
    is_as_fitted_ = false;
    return;
  }
}

void ViewMotion::advance(double seconds) {
  rest_ = is_moving() ? 0.0 : rest_ + seconds;
  if (flight_) {
    flight_->elapsed += seconds;
    if (flight_->elapsed >= kFlightTime) {
      camera_ = flight_->to;
      flight_.reset();
    } else {
      camera_ = between(flight_->from, flight_->to, ease(flight_->elapsed / kFlightTime));
    }
  }
  if (pending_zoom_ != 0.0) {
    double step = pending_zoom_ * (1.0 - std::exp(-seconds / kZoomTime));
    if (std::abs(pending_zoom_ - step) < kDoneZoom) step = pending_zoom_;
    camera_.zoom_at(zoom_px_, std::exp(step));
    pending_zoom_ -= step;
  }
}

}  // namespace mes
