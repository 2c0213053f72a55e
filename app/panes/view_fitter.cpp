// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panes/view_fitter.h"

#include <algorithm>

namespace mes {

std::optional<ViewFitter::How> ViewFitter::wanted_again(const Document& document, const Room& room,
                                                        bool is_held) const {
  if (!fitted_ || room == fitted_->room || !view_.is_as_fitted() || is_held || view_.fits() != fitted_->fit)
    return std::nullopt;
  const bool is_same_window = room.width == fitted_->room.width && room.height == fitted_->room.height;
  if (fitted_->is_target) return is_same_window ? std::nullopt : std::optional(How::at_once);
  constexpr double kAbout = 0.2;
  const double size = std::max(fitted_->box.width(), fitted_->box.height());
  const auto is_about = [size](Vec2 a, Vec2 b) { return distance(a, b) <= kAbout * size; };
  const Box2 box = document.bounding_box();
  if (!is_about(box.low, fitted_->box.low) || !is_about(box.high, fitted_->box.high)) return std::nullopt;
  return is_same_window ? How::glide : How::at_once;
}

void ViewFitter::follow(const Document& document, const Frame& frame) {
  const Room room{view_.camera().width(), view_.camera().height(), view_.insets()};
  if (!wanted_) {
    wanted_ = wanted_again(document, room, frame.is_held);
    if (wanted_ && fitted_->is_target) target_ = fitted_->box;
  }
  // Forgets the old fit, so that a large drawing is compared only once.
  if (fitted_ && !fitted_->is_target && room != fitted_->room && !frame.is_held) fitted_.reset();
  if (!wanted_) return;
  const Box2 box = target_.value_or(document.bounding_box());
  // A target is what was seen in the whole free area, with the legend on it.
  if (!box.is_empty() && !target_)
    view_.set_insets(clear_of_corner(room.panels, {static_cast<double>(room.width), static_cast<double>(room.height)},
                                     frame.legend, {box.width(), box.height()}));
  view_.fit(box, target_ ? 0.0 : kMargin * frame.content_scale, *wanted_ == How::at_once);
  fitted_.reset();
  if (!box.is_empty()) fitted_ = Fitted{box, room, view_.fits(), target_.has_value()};
  target_.reset();
  wanted_.reset();
}

}  // namespace mes
