// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the whole drawing into the area that the panels leave free.
#pragma once

#include <optional>

#include "app/panes/view_motion.h"
#include "core/document/document.h"

namespace mes {

/// Guarantees: a fit is made in the next frame, when the panels have their final positions. While the view stays as
/// fitted and the drawing about as large, it is fitted again when panels are opened or closed, or the window is
/// resized; a target only if the window is resized. Threads: none.
class ViewFitter {
 public:
  static constexpr double kMargin = 40.0;  ///< margin around the drawing, in logical pixels

  /// The view must outlive it.
  explicit ViewFitter(ViewMotion& view) : view_(view) {}

  enum class How : std::uint8_t { glide, at_once };
  void want(How how) { wanted_ = how; }
  bool is_wanted() const { return wanted_.has_value(); }
  /// The next fit shows this box without margin instead of the drawing.
  void set_target(const Box2& box) { target_ = box; }

  struct Frame {
    Vec2 legend{};               ///< size of the item in the lower right corner of the free area
    double content_scale = 1.0;  ///< framebuffer pixels per logical pixel
    bool is_held = false;        ///< a gesture has the pointer
  };
  /// Call it once per frame, after the panels were drawn.
  void follow(const Document& document, const Frame& frame);

 private:
  struct Room {
    int width = 0;
    int height = 0;
    Insets panels{};
    friend bool operator==(const Room&, const Room&) = default;
  };
  /// The fitted box, and the area it was fitted into.
  struct Fitted {
    Box2 box;
    Room room;
    std::uint64_t fit = 0;  ///< fit number of the view; a larger one shows something else
    bool is_target = false;
  };
  std::optional<How> wanted_again(const Document& document, const Room& room, bool is_held) const;

  ViewMotion& view_;
  std::optional<How> wanted_{};
  std::optional<Box2> target_{};
  std::optional<Fitted> fitted_{};
};

}  // namespace mes
