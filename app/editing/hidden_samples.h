// SPDX-License-Identifier: GPL-3.0-or-later
// Counts samples that are added while no layer shows samples.
#pragma once

#include "app/layers/layer_stack.h"
#include "core/document/document.h"

namespace mes {

/// Counts the samples added since samples were last visible, or since the document was loaded, less those removed
/// again; the count is zero once the user knows of them. Threads: none.
class HiddenSamples {
 public:
  /// Begins with another document.
  void begin(const Document& document);
  /// Call it once per frame.
  void follow(const Document& document, const LayerStack& layers);
  /// The number of hidden samples to report.
  std::size_t count() const { return is_known_ ? 0 : added_; }
  /// The user knows; valid until samples have been visible, or another document is loaded.
  void dismiss() { is_known_ = true; }

 private:
  std::size_t last_ = 0;  // number of samples in the document
  std::size_t added_ = 0;
  bool is_known_ = false;
};

}  // namespace mes
