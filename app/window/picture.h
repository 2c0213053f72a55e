// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine has computed, on the graphics card, with the marks of the window above it.
#pragma once

#include <vector>

#include "app/editor.h"
#include "app/layer_stack.h"
#include "core/engine/engine.h"
#include "render/gl_device.h"
#include "render/scene.h"

namespace mes {

/// What it guarantees: it never waits for the engine; a layer whose structure failed keeps its last good picture;
/// marks (selection, hovered sample) are uploaded only when they change. Needs a current OpenGL context for its life.
/// Threads: the window's.
class Picture {
 public:
  Picture();

  /// Takes what is finished; true when something was.
  bool take_from(Engine& engine);
  /// Frees the graphics memory of layers that are shown no more.
  void forget_hidden(const LayerStack& layers);
  void draw(const render::Camera& camera, const LayerStack& layers, const Editor& editor, Slot hovered,
            double content_scale);

  NodeState state(LayerIndex layer) const;
  const LayerReport* report(LayerIndex layer) const;
  const std::vector<NodeReport>& nodes() const { return nodes_; }
  /// The document state that is on screen.
  std::uint64_t document_revision() const { return document_revision_; }
  const render::Scene& scene() const { return scene_; }

 private:
  void mark_selection(const Editor& editor);
  void mark_hovered(const Editor& editor, Slot hovered);

  render::GlDevice device_;
  render::Scene scene_;
  std::vector<LayerReport> reports_;
  std::vector<NodeReport> nodes_;
  std::uint64_t document_revision_ = 0;
  struct MarkedState {
    std::uint64_t document = ~std::uint64_t{0};
    std::uint64_t selection = ~std::uint64_t{0};
    DrawingFrame frame;
    friend bool operator==(const MarkedState&, const MarkedState&) = default;
  } marked_;
  std::vector<double> mark_data_;  // kept for its memory
};

}  // namespace mes
