// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the whole drawing in what the panels leave free.
#pragma once

#include <optional>

#include "app/model/view_motion.h"
#include "core/document/document.h"

namespace mes {

/// What it guarantees: what is wanted is done in the next frame, when the panels are where they will be. While the view
/// stays as it was fitted and the drawing about as large, it is fitted again when panels come and go or the window
/// changes its size. Threads: none.
class ViewFitter {
 public:
  static constexpr double kMargin = 40.0;  ///< around the drawing, in logical pixels

  /// The view outlives it.
  explicit ViewFitter(ViewMotion& view) : view_(view) {}

  enum class How : std::uint8_t { glide, at_once };
  void want(How how) { wanted_ = how; }
  bool is_wanted() const { return wanted_.has_value(); }
  /// Next time this box is fitted, without margin, and not the drawing.
  void set_target(const Box2& box) { target_ = box; }

  struct Frame {
    Vec2 legend{};               ///< size of what lies in the lower right corner of the free area
    double content_scale = 1.0;  ///< framebuffer pixels per logical pixel
    bool is_held = false;        ///< a gesture has the pointer
  };
  /// Once a frame, after the panels were drawn.
  void follow(const Document& document, const Frame& frame);

 private:
  struct Room {
    int width = 0;
    int height = 0;
    Insets panels{};
    friend bool operator==(const Room&, const Room&) = default;
  };
  /// What was fitted, and into what.
  struct Fitted {
    Box2 box;
    Room room;
    std::uint64_t fit = 0;  ///< of the view; a later one showed something else
  };
  std::optional<How> wanted_again(const Document& document, const Room& room, bool is_held) const;

  ViewMotion& view_;
  std::optional<How> wanted_{};
  std::optional<Box2> target_{};
  std::optional<Fitted> fitted_{};
};

}  // namespace mes
