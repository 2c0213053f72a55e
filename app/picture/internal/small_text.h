// SPDX-License-Identifier: GPL-3.0-or-later
// Private to app/picture.
#pragma once

namespace mes {

/// The text of legends and scales; logical pixels.
inline constexpr double kSmallTextSize = 13.0;
inline constexpr double kSmallLineHeight = 17.0;

}  // namespace mes
