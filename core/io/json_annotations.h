// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations as JSON: part of sessions.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/document/annotation.h"
#include "core/io/json_view.h"

namespace mes {

nlohmann::json to_json(const Annotations& annotations);
/// The first version of sessions (`kSessionSchema`) whose readers understand them.
std::uint64_t schema_of(const Annotations& annotations);

/// Keys that are not known are skipped; sizes and shifts out of range are brought into it. Error: `bad_input` when
/// something is of the wrong kind, a place, a text or their number is out of range, or a kind of annotation, of element
/// or a role is not known: without it, edits of annotations would change nothing, and undo would be counted wrongly.
/// Whether the samples and balls that are named exist is for the document to say.
Expected<Annotations> annotations_from(JsonView value);

}  // namespace mes
