// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the samples on screen.
#pragma once

#include "app/layers/words/verdict_word.h"
#include "app/picture/picture.h"
#include "core/engine/engine.h"

namespace mes {

/// The status bar, the list below the light and the page of the sampling all show this.
inline VerdictWord shown_verdict(const Engine& engine, const Picture& picture) {
  return verdict_word(sampling_verdict(picture.nodes()), picture.lacks_memory(),
                      checking_of(engine.status(), picture.is_outdated()));
}

}  // namespace mes
