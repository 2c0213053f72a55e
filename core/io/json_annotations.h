// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations as JSON: part of sessions.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/document/annotation.h"
#include "core/io/json_view.h"

namespace mes {

nlohmann::json to_json(const Annotations& annotations);

/// Kinds and keys that are not known are skipped; sizes and shifts out of range are brought into it. Error:
/// `bad_input` when something is of the wrong kind, or a place, a text or their number is out of range. Whether the
/// samples that are named exist is for the document to say.
Expected<Annotations> annotations_from(JsonView value);

}  // namespace mes
