// SPDX-License-Identifier: GPL-3.0-or-later
// Why nothing is seen, and what would show something.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/layers/ball_families.h"

namespace mes {

/// What to do so that something is seen.
enum class ShowInstead : std::uint8_t { samples, own_balls, inner_family, own_family };
/// On a button.
std::string label_of(ShowInstead what);
/// Does it.
void show_instead(ShowInstead what, LayerStack& layers);

struct EmptyView {
  std::string text;  ///< one or two sentences
  ShowInstead offer = ShowInstead::samples;
};
/// For layers that are up to date: nothing if something is seen, or the document is empty. `shows` tells whether a
/// layer has anything to draw.
std::optional<EmptyView> empty_view(const Document& document, const LayerStack& layers,
                                    const std::function<bool(LayerIndex)>& shows);

}  // namespace mes
