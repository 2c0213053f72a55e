// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/curve_source_input.h"

namespace mes {

StatList CurveSourceInput::statistics() const {
  return {{"curves", static_cast<std::int64_t>(current_ ? current_->curves->curves.size() : 0)}};
}

}  // namespace mes
