// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of source curves and sampling requests: part of sessions.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/curves/curve.h"
#include "core/curves/sampling.h"
#include "core/io/session/json_view.h"

namespace mes {

/// {"curves": [{"closed", "points", ...}], "points": [...], "resolution"}. A curve of lines only has no more keys;
/// others have "kinds", a letter for each piece as in SVG (L, Q, C, A), and "arcs", eight numbers each.
nlohmann::json to_json(const CurveSet& curves);
nlohmann::json to_json(const SamplingRequest& request);

/// Keeps every double bit for bit. Error: `bad_input` when something is of the wrong kind, or the number of points does
/// not fit. Memory: less than ten times the text.
Expected<CurveSet> curves_from(JsonView object);
/// Clamps numbers into their range; an unknown rule becomes `adaptive`. Error: `bad_input` when something is of the
/// wrong kind.
Expected<SamplingRequest> sampling_from(JsonView object);

}  // namespace mes
