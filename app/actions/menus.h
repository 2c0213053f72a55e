// SPDX-License-Identifier: GPL-3.0-or-later
// The menus that show the actions of the table. The menu bar draws them, and the palette says where an action is.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/actions/actions.h"

namespace mes {

/// Actions that follow each other in a menu. Lines, submenus and functions without an action lie between the parts.
struct MenuPart {
  std::string_view path{};  ///< "View > Panels"
  std::vector<ActionId> actions{};
};

/// Every part, in the order of the menus; those of one menu in the order of its rows.
std::span<const MenuPart> menu_parts();

/// The actions of the part with this number, from 0, of those with the path. It must exist.
std::span<const ActionId> actions_in_menu(std::string_view path, std::size_t part = 0);

/// The path of the first menu with the action; empty if no menu has it.
std::string_view menu_of(ActionId id);

}  // namespace mes
