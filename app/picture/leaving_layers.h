// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the last picture in view while the engine computes the layers of the next one.
//
// Guarantees:
//  1. Layers that are hidden together with the showing of others leave once each of these has a picture or has failed.
//     Layers that are hidden alone leave at once.
//  2. A layer of a variant leaves at once if the variants change.
//  3. Until the layers leave, they are drawn where they were, each with its last style; afterwards `drawn` returns what
//     it is given.
//
// Cost: O(layers shown). Threads: none.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "app/panes/pane_list.h"

namespace mes {

class LeavingLayers {
 public:
  /// Whether the layer is in the scene, or has failed.
  using HasPicture = std::function<bool(VariantLayer)>;

  void follow(const ShownPanes& shown, const HasPicture& has_picture);
  void end_if_complete(const HasPicture& has_picture);
  /// All layers leave at once.
  void end() { leaving_.clear(); }
  /// True if the scene must keep the layer.
  bool needs(VariantLayer layer) const;
  /// The layers to draw in a pane whose layers are these; the main pane is number 0.
  ShownPanes::Layers drawn(std::size_t pane, ShownPanes::Layers layers) const;
  /// The same, and remembers them as those drawn last.
  const ShownPanes::Layers& draw(std::size_t pane, ShownPanes::Layers layers);

 private:
  std::vector<VariantLayer> demand_;
  std::vector<VariantLayer> leaving_;
  std::vector<VariantRequest> variants_;
  std::vector<std::optional<VersionChoice>> versions_;
  std::vector<ShownPanes::Layers> last_;  // by pane
};

}  // namespace mes
