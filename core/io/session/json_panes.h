// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of panes and their content: part of sessions.
#pragma once

#include <expected>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/document/settings/pane_choice.h"
#include "core/io/session/json_view.h"

namespace mes {

/// `views`: one for each pane, an empty box for everything; empty if all panes share one view.
nlohmann::json panes_to_json(std::span<const PaneChoice> panes, std::span<const Box2> views);

/// Why the panes are invalid, and where.
struct PaneFault {
  std::string text;
  JsonView at;
};
struct ReadPanes {
  std::vector<PaneChoice> panes;
  std::vector<Box2> views;  ///< one for each pane; empty if no pane has its own
};
/// Skips panes with unknown kinds, number types, parameters and families; clamps parameter values into their range. A
/// fault: something of the wrong kind, or too many panes or steps.
std::expected<ReadPanes, PaneFault> panes_from(JsonView list);

}  // namespace mes
