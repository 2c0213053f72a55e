// SPDX-License-Identifier: GPL-3.0-or-later
// The sessions that pictures and figures carry, so that they can be opened again.
#pragma once

#include <string>

#include "core/base/geometry/box2.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/document/settings/layer_configuration.h"
#include "core/io/session/session.h"

namespace mes {

/// The present document and its view, without its history, and without its author's folders. `view`: document units;
/// empty: everything.
Session session_for_picture(std::string title, SampleData data, LayerConfiguration layers,
                            const ComputationSettings& settings, const Box2& view);

/// The session with its history and its lesson, without its author's folders.
Session session_for_lesson(const Session& session);

}  // namespace mes
