// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/hidden_additions.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "app/editing/editor.h"
#include "app/layers/ball_families.h"

namespace mes {
namespace {

std::size_t count_of(AddedKind kind, const Document& document) {
  switch (kind) {
    case AddedKind::samples: return document.sample_count();
    case AddedKind::balls: return document.ball_count();
    case AddedKind::annotations: return document.annotations()->size();
  }
  return 0;
}

/// True as well if the program has none of these layers: they cannot be shown then.
bool shows_one(const LayerStack& layers, std::span<const std::string_view> ids) {
  bool is_hidden = false;
  for (const std::string_view id : ids) {
    const LayerIndex layer = layers.find(id);
    if (layer == kNoLayer) continue;
    if (layers.is_visible(layer)) return true;
    is_hidden = true;
  }
  return !is_hidden;
}

constexpr std::array<std::string_view, 1> kSampleLayers{"points"};

}  // namespace

PickedThing seen_thing_at(const Editor& editor, const LayerStack& layers, Vec2 p, double radius) {
  const Document& document = editor.document();
  const PickedThing any = thing_at(document, editor.index(), p, radius);
  const Selection& selection = editor.selection();
  const bool is_selected = any.ball != kNoSlot ? selection.contains_ball(any.ball)
                                               : any.sample != kNoSlot && selection.contains(any.sample);
  if (is_selected) return any;
  return thing_at(document, editor.index(), p, radius,
                  {.samples = shows_one(layers, kSampleLayers), .balls = shows_one(layers, kOwnBallLayers)});
}

void HiddenAdditions::begin(const Document& document) {
  for (const AddedKind kind : kAddedKinds) of(kind) = {.last = count_of(kind, document)};
}

void HiddenAdditions::follow(const Document& document, const LayerStack& layers, bool shows_annotations) {
  const std::array<bool, kAddedKinds.size()> are_shown{shows_one(layers, kSampleLayers),
                                                       shows_one(layers, kOwnBallLayers), shows_annotations};
  for (const AddedKind kind : kAddedKinds) {
    Additions& additions = of(kind);
    const std::size_t now = count_of(kind, document);
    if (are_shown[static_cast<std::size_t>(kind)]) {
      additions = {.last = now};
      continue;
    }
    const std::size_t before = std::exchange(additions.last, now);
    if (now >= before)
      additions.added += now - before;
    else
      additions.added -= std::min(additions.added, before - now);
  }
}

}  // namespace mes
