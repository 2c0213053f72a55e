// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the numbers of samples beside them, as many as there is room for.
//
// Guarantees:
//  1. No two numbers overlap. If two would, the rounder one is shown, and of equally round ones the lower: the
//     roundest is 0, then follow multiples of ..., 100, 50, 10, 5, and all others. A hidden number still hides
//     others, so that samples along a curve show multiples of one number.
//  2. So the visibility of a number depends only on its neighbours at the scale of the view: panning does not change
//     it, and zooming in only adds numbers. If very many samples are visible (some ten thousand), numbers that are
//     not round are left out completely, by a bound that depends on the number of visible samples.
//  3. At most some ten thousand numbers compete, and with an index only some samples are examined to find them.
//
// Smallest use:
//     std::vector<render::LayerView> views = ...;
//     add_texts(layers, views, {document, &index}, {camera.visible(), camera.units_per_pixel()}, &font);
//     scene.draw(camera, views, {});
//
// Cost: at most a few milliseconds with an index, however many samples there are; O(samples) without one. Threads:
// any that may read the document.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/editing/places/place_index.h"
#include "core/base/geometry/box2.h"
#include "core/document/document.h"
#include "core/draw/layer_descriptor.h"
#include "render/layer_texts.h"
#include "render/scene.h"

namespace mes {

struct TextSource {
  const Document& document;
  const SampleIndex* index = nullptr;  ///< null: every sample is examined
};

/// The visible part of the plane and its scale: units of the document per logical pixel.
struct TextPart {
  Box2 box;
  double units_per_px = 1.0;
};

/// Gives the views of text layers their texts; nothing without a font (null). The texts avoid the dots of the layer
/// `points`. `layers` are all layers.
void add_texts(std::span<const LayerDescriptor> layers, std::span<render::LayerView> views, const TextSource& source,
               const TextPart& part, const render::Font* font);

/// The room that a number takes, in logical pixels.
struct NumberRoom {
  double digit = 8.0;    ///< width of a digit
  double apart = 4.0;    ///< gap between a number and the next
  double height = 10.0;  ///< height of a line
  Vec2 shift{};          ///< offset from the sample to the lower left corner, y down
};

/// The samples whose numbers are shown, by increasing row.
std::vector<SampleSlot> numbers_with_room(const TextSource& source, const TextPart& part, const NumberRoom& room);

/// The number of the sample, counted from 0 since the data were opened.
std::uint32_t number_of(const Document& document, SampleSlot sample);

}  // namespace mes
