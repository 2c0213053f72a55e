// SPDX-License-Identifier: GPL-3.0-or-later
// What panes show, as JSON: part of sessions.
#pragma once

#include <expected>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/document/pane_choice.h"
#include "core/io/json_view.h"

namespace mes {

nlohmann::json to_json(std::span<const PaneChoice> panes);

/// Why panes make no sense, and where.
struct PaneFault {
  std::string text;
  JsonView at;
};
/// Panes of kinds, number types, parameters and families that are not known are skipped; values of parameters are
/// brought into their range. A fault: something of the wrong kind, more panes or steps than there can be.
std::expected<std::vector<PaneChoice>, PaneFault> panes_from(JsonView list);

}  // namespace mes
