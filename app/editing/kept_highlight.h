// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a highlight of provenance into an annotation that stays.
//
// Smallest use:
//     KeptHighlight kept = highlight_of(*card.shown(), document);
//     annotations.begin(std::move(kept.annotation));
#pragma once

#include <cstddef>
#include <optional>

#include "core/document/annotation.h"
#include "core/document/document.h"
#include "core/draw/provenance.h"

namespace mes {

struct KeptHighlight {
  Annotation annotation;     ///< without elements if nothing can be kept
  std::size_t left_out = 0;  ///< shapes beyond `kMostHighlighted`, and shapes that no document can hold
};

/// Guarantees: an element defined by samples alone, or by balls of the document, follows them; if one of its points
/// is not so defined, the whole element keeps its position. `line`: a line of the answer; nothing: all lines. The
/// answer must refer to this state of the document. Cost: O(shapes). Threads: any.
KeptHighlight highlight_of(const Provenance& answer, const Document& document,
                           std::optional<std::size_t> line = std::nullopt);

}  // namespace mes
