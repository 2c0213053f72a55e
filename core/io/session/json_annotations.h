// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations as JSON: part of sessions.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/document/annotation.h"
#include "core/io/session/json_view.h"

namespace mes {

nlohmann::json to_json(const Annotations& annotations);
/// The first version of sessions (`kSessionSchema`) whose readers understand these annotations.
std::uint64_t schema_of(const Annotations& annotations);

/// Skips unknown keys; clamps sizes and shifts into their range. Error: `bad_input` when something is of the wrong
/// kind, when an anchor, a text or their number is out of range, or for an unknown kind of annotation, element or role:
/// if it were skipped, edits of annotations would change nothing, and undo would be counted wrongly. The document
/// checks whether the named samples and balls exist.
Expected<Annotations> annotations_from(JsonView value);

}  // namespace mes
