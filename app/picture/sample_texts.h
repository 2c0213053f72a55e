// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of samples beside them, as many as have room.
//
// What it guarantees:
//  1. No two numbers overlap. Of two that would, the rounder one stays, of equally round ones the lower: from the
//     roundest down, 0, ..., multiples of 100, 50, 10, 5, and all others. One that gives way makes others give way
//     nevertheless, so that samples along a curve show multiples of one number.
//  2. So whether a number is shown follows from its neighbours at the scale of the view: it stays while the view is
//     moved, and magnifying only adds to what is shown. Where very many samples are seen (some ten thousand), numbers
//     that are not round are left out altogether, and this bound depends on how many are seen.
//  3. Some ten thousand numbers at most compete, and with an index only some samples are looked at to find them.
//
// Smallest use:
//     std::vector<render::LayerView> views = ...;
//     add_texts(layers, views, {document, &index}, {camera.visible(), camera.units_per_pixel()}, &font);
//     scene.draw(camera, views, {});
//
// Cost: a few milliseconds at most with an index, however many samples there are; O(samples) without. Threads: any
// that may read the document.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/editing/place_index.h"
#include "core/base/box2.h"
#include "core/document/document.h"
#include "core/draw/layer_descriptor.h"
#include "render/layer_texts.h"
#include "render/scene.h"

namespace mes {

struct TextSource {
  const Document& document;
  const SampleIndex* index = nullptr;  ///< null: every sample is looked at
};

/// The part of the plane that is seen, and how large it is: units of the document per logical pixel.
struct TextPart {
  Box2 box;
  double units_per_px = 1.0;
};

/// Gives views of layers that are texts what they show; nothing without a font (null). The texts keep clear of the dots
/// of the layer `points`. `layers` are all that there are.
void add_texts(std::span<const LayerDescriptor> layers, std::span<render::LayerView> views, const TextSource& source,
               const TextPart& part, const render::Font* font);

/// How much room a number takes, in logical pixels.
struct NumberRoom {
  double digit = 8.0;    ///< width of a digit
  double apart = 4.0;    ///< between a number and the next
  double height = 10.0;  ///< of a line
  Vec2 shift{};          ///< from the sample to the lower left corner, y down
};

/// Those that are shown, by increasing row of their samples.
std::vector<SampleSlot> numbers_with_room(const TextSource& source, const TextPart& part, const NumberRoom& room);

/// Of the sample, from 0 since the data were opened.
std::uint32_t number_of(const Document& document, SampleSlot sample);

}  // namespace mes
