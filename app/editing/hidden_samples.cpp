// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/hidden_samples.h"

#include <algorithm>
#include <utility>

namespace mes {

void HiddenSamples::begin(const Document& document) {
  *this = {};
  last_ = document.sample_count();
}

void HiddenSamples::follow(const Document& document, const LayerStack& layers) {
  const std::size_t now = document.sample_count();
  if (const LayerIndex points = layers.find("points"); points == kNoLayer || layers.is_visible(points))
    return begin(document);
  const std::size_t before = std::exchange(last_, now);
  if (now >= before)
    added_ += now - before;
  else
    added_ -= std::min(added_, before - now);
}

}  // namespace mes
