// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that are added while no layer shows samples.
#pragma once

#include "app/layers/layer_stack.h"
#include "core/document/document.h"

namespace mes {

/// Counts the samples that were added since samples were visible last, or since the document came, less those that were
/// taken away again; the count is zero once the user knows. Threads: none.
class HiddenSamples {
 public:
  /// Another document is there.
  void begin(const Document& document);
  /// Once a frame.
  void follow(const Document& document, const LayerStack& layers);
  /// The number of hidden samples to tell of.
  std::size_t count() const { return is_known_ ? 0 : added_; }
  /// The user knows, until samples have been visible, or another document comes.
  void dismiss() { is_known_ = true; }

 private:
  std::size_t last_ = 0;  // samples of the document
  std::size_t added_ = 0;
  bool is_known_ = false;
};

}  // namespace mes
