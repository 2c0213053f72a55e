// SPDX-License-Identifier: GPL-3.0-or-later
// What provenance highlights, as an annotation that stays.
//
// Smallest use:
//     KeptHighlight kept = highlight_of(*card.shown(), document);
//     desk.begin(std::move(kept.annotation));
#pragma once

#include <cstddef>
#include <optional>

#include "core/document/annotation.h"
#include "core/document/document.h"
#include "core/draw/provenance.h"

namespace mes {

struct KeptHighlight {
  Annotation annotation;     ///< without elements if there is nothing that can be kept
  std::size_t left_out = 0;  ///< shapes beyond `kMostHighlighted`, and those that no document can hold
};

/// What it guarantees: an element that is defined by samples alone, or by balls of the document, follows them; one of
/// which some place is not stays as a whole where it is. `line`: of the answer; none: all lines. The answer is of this
/// state of the document. Cost: O(shapes). Threads: any.
KeptHighlight highlight_of(const Provenance& answer, const Document& document,
                           std::optional<std::size_t> line = std::nullopt);

}  // namespace mes
