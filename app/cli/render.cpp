// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/messages.h"
#include "app/cli/requests.h"

namespace mes::cli {

Expected<void> run_render(const RenderRequest&, Interruption&) {
  return std::unexpected(Error{ErrorCode::no_display, "this build draws no pictures", {}, 0, 0});
}

}  // namespace mes::cli
