// SPDX-License-Identifier: GPL-3.0-or-later
// Private to app/picture.
#pragma once

#include "app/picture/paper/paper_drawing.h"

namespace mes {

inline constexpr double kSmallLineHeight = 17.0;

}  // namespace mes
