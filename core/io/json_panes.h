// SPDX-License-Identifier: GPL-3.0-or-later
// What panes show, as JSON: part of sessions.
#pragma once

#include <expected>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/box2.h"
#include "core/document/pane_choice.h"
#include "core/io/json_view.h"

namespace mes {

/// `views`: of each pane, an empty box for everything; none at all where all panes show one view.
nlohmann::json panes_to_json(std::span<const PaneChoice> panes, std::span<const Box2> views);

/// Why panes make no sense, and where.
struct PaneFault {
  std::string text;
  JsonView at;
};
struct ReadPanes {
  std::vector<PaneChoice> panes;
  std::vector<Box2> views;  ///< of each; none where no pane has one
};
/// Panes of kinds, number types, parameters and families that are not known are skipped; values of parameters are
/// brought into their range. A fault: something of the wrong kind, more panes or steps than there can be.
std::expected<ReadPanes, PaneFault> panes_from(JsonView list);

}  // namespace mes
