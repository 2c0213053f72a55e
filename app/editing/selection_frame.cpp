// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/selection_frame.h"

namespace mes {

std::optional<Box2> SelectionFrame::box() const {
  const Document& document = editor_.document();
  const Selection& selection = editor_.selection();
  const std::pair now{selection.revision(), document.revision()};
  if (box_of_ == now) return box_;
  box_of_ = now;
  box_.reset();
  if (selection.size() < 2) return box_;
  Box2 box;
  for (const SampleSlot slot : selection.slots()) box.add(document.position(slot));
  for (const BallSlot slot : selection.ball_slots()) box.add(document.disk(slot).center);
  if (box.width() > 0.0 || box.height() > 0.0) box_ = box;
  return box_;
}

}  // namespace mes
