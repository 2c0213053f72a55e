// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that samples are taken from, and how, as JSON: part of sessions.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/curves/curve.h"
#include "core/curves/sampling.h"
#include "core/io/json_view.h"

namespace mes {

/// {"curves": [{"closed", "points", ...}], "points": [...], "resolution"}. A curve that consists of lines says no more; others have
/// "kinds", a letter for each piece as SVG has them (L, Q, C, A), and "arcs", eight numbers each.
nlohmann::json to_json(const CurveSet& curves);
nlohmann::json to_json(const SamplingRequest& request);

/// Every double bit for bit. Error: `bad_input` when something is of the wrong kind, or numbers of points do not fit.
/// Memory: less than ten times the text.
Expected<CurveSet> curves_from(JsonView object);
/// Numbers out of range are brought into it; a rule that is not known is `adaptive`. Error: `bad_input` when something
/// is of the wrong kind.
Expected<SamplingRequest> sampling_from(JsonView object);

}  // namespace mes
