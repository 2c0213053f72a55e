// SPDX-License-Identifier: GPL-3.0-or-later
// The reason why nothing is visible, and a remedy.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/layers/ball_families.h"

namespace mes {

/// The remedies for an empty view.
enum class ShowInstead : std::uint8_t { samples, own_balls, inner_family, own_family };
/// Label of a button.
std::string label_of(ShowInstead what);
/// Applies the remedy.
void show_instead(ShowInstead what, LayerStack& layers);

struct EmptyView {
  std::string text;  ///< one or two sentences
  ShowInstead offer = ShowInstead::samples;
};
/// For layers that are up to date; nothing if something is visible, or the document is empty. `shows` tells whether a
/// layer has anything to draw.
std::optional<EmptyView> empty_view(const Document& document, const LayerStack& layers,
                                    const std::function<bool(LayerIndex)>& shows);

}  // namespace mes
