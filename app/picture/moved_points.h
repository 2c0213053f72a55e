// SPDX-License-Identifier: GPL-3.0-or-later
// Draws dragged samples where the document has them, although the engine has not followed yet.
//
// For a layer of samples, whose scalars are their ids, it knows the sample of each instance. So the window can write
// the positions of moved samples into the drawing itself, in a patch like the engine's; later patches of the engine
// write the same instances.
//
// Smallest use:
//     moved.take(patch);                     // each patch of the engine, after the scene has taken it
//     if (const FramePatch* own = moved.catch_up(document, selection.slots(), scene.frame())) scene.apply(*own);
//
// Cost: `take` O(changed instances); `catch_up` O(moved samples), and O(all) when other samples begin to move.
// Threads: the window's.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/document/document.h"
#include "core/draw/patch.h"

namespace mes {

class MovedPoints {
 public:
  /// `layer`: a layer with one point per sample, whose last number is its id.
  explicit MovedPoints(LayerIndex layer) : layer_(layer) {}

  void take(const FramePatch& patch);
  LayerIndex layer() const { return layer_; }
  /// Number of instances of the layer after the last patch.
  std::size_t count() const { return ids_.size(); }
  /// The patch that moves these samples to their positions in the document; null if none of them is in the drawing.
  /// Valid until the next call.
  const FramePatch* catch_up(const Document& document, std::span<const SampleSlot> samples,
                             const DrawingFrame& frame);

 private:
  void find_instances(std::vector<SampleId> samples);

  LayerIndex layer_;
  bool has_scalars_ = true;
  std::vector<double> ids_;         // id by instance
  std::vector<SampleId> searched_;  // sorted
  std::vector<std::uint32_t> instance_of_searched_;
  bool has_other_ids_ = true;  // true after a change since the search
  FramePatch patch_;
};

}  // namespace mes
