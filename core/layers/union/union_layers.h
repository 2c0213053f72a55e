// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mes {

class Registry;

/// Adds the layers of the unions of inner, polar and user balls.
void add_union_layers(Registry& registry);

}  // namespace mes
