// SPDX-License-Identifier: GPL-3.0-or-later
// The camera of the canvas, which glides to its target.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/geometry/box2.h"
#include "render/camera.h"

namespace mes {

/// Pixels covered by panels at the sides of the view; fitted boxes avoid them.
struct Insets {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  friend bool operator==(const Insets&, const Insets&) = default;
};

/// Insets that exclude an item of size `corner` in the lower right corner of the free area: below or on the right,
/// whichever shows a drawing of this `size` (in any unit) larger. Unchanged if the item is not in the way.
Insets clear_of_corner(const Insets& insets, Vec2 viewport, Vec2 corner, Vec2 size);

/// Guarantees:
///  1. During a zoom the world point under the pointer stays under it, in every frame.
///  2. A motion ends exactly at its goal; then `is_moving` is false, and nothing more needs to be drawn.
///  3. `back` returns to views that were left by a jump, or by zooming and panning after a rest.
///
/// Smallest use:
///     motion.zoom_at(cursor, 1.2);
///     while (motion.is_moving()) { motion.advance(seconds); draw(motion.camera()); }
///
/// Coordinates are framebuffer pixels, y down. Moving the view is not a step of undo. Threads: none.
class ViewMotion {
 public:
  const render::Camera& camera() const { return camera_; }
  void set_viewport(int width, int height);
  void set_insets(const Insets& insets) { insets_ = insets; }
  const Insets& insets() const { return insets_; }

  void zoom_at(Vec2 px, double factor);
  /// Pans at once: the picture sticks to the hand.
  void pan(Vec2 delta_px);
  /// Glides to show the box, or jumps if nothing was shown before.
  void fit(const Box2& box, double margin_px, bool at_once = false);
  /// True if the view was not zoomed, panned or taken back since it was fitted.
  bool is_as_fitted() const { return is_as_fitted_; }
  /// The number of fits so far.
  std::uint64_t fits() const { return fits_; }
  void back();
  bool can_go_back() const { return !earlier_.empty(); }

  bool is_moving() const { return pending_zoom_ != 0.0 || flight_.has_value(); }
  void advance(double seconds);
  /// Centre of the area that the panels leave free.
  Vec2 middle() const;
  /// The visible area between the panels, in the world. Fitting it without margin restores the same view.
  Box2 free_box() const;

 private:
  struct Flight {
    render::Camera from;
    render::Camera to;
    double elapsed = 0.0;
  };
  render::Camera fitted(const Box2& box, double margin_px) const;
  void remember();
  void fly_to(const render::Camera& goal);

  render::Camera camera_;
  Insets insets_;
  std::vector<render::Camera> earlier_;
  std::optional<Flight> flight_;
  double pending_zoom_ = 0.0;  // logarithm of the factor still to come
  Vec2 zoom_px_{};
  bool is_as_fitted_ = false;
  std::uint64_t fits_ = 0;
  double rest_ = 1e9;  // seconds since the last motion
};

}  // namespace mes
