// SPDX-License-Identifier: GPL-3.0-or-later
// Words for a change of the samples.
#pragma once

#include <string>

#include "core/engine/sampling_verdict.h"

namespace mes {

/// "before: epsilon 0.9 (2 corners exempt); now: epsilon 0.25 (2 corners exempt); the theorem is proved for these
/// samples"; only the present verdict if the epsilon is as before. It ends with the words of `now`, as they are given
/// everywhere else.
inline std::string before_and_now(const SamplingVerdict& before, const SamplingVerdict& now) {
  if (before.epsilon == now.epsilon) return now.text();
  return "before: " + (before.epsilon ? before.epsilon->text() : "no epsilon") + "; now: " + now.text();
}

}  // namespace mes
