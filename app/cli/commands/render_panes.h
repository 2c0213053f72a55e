// SPDX-License-Identifier: GPL-3.0-or-later
// Draws pictures and figures of panes side by side.
#pragma once

#include <string>

#include "app/cli/commands/rendering.h"
#include "app/export/comparison.h"

namespace mes::cli {

/// The bytes of a picture or a figure of all panes, in the format of `picture`; `canvas` is null for a figure.
/// `common` has the shared sources: maps and the picture to trace. If differences are to be marked, elements that
/// only some panes have are added to scene and mirror. Error: `usage` if the panes would be too small.
Expected<std::string> draw_panes(const PictureRequest& picture, const RenderRequest& request, Comparison& comparison,
                                 const ComputationResult& result, Canvas* canvas, LayerMirror& mirror,
                                 const FigureSource& common, std::string session);

}  // namespace mes::cli
