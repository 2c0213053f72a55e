// SPDX-License-Identifier: GPL-3.0-or-later
// A browser has no fork: naive arithmetic and arithmetic with roots are not offered there.
#include <fmt/core.h>

#include "core/base/jobs/isolated.h"

namespace mes {

std::vector<std::byte> run_isolated(const std::function<std::vector<std::byte>()>& /*work*/,
                                    const IsolationLimits& limits, JobControl& /*job*/) {
  throw GeometryError(fmt::format("{} needs a process of its own, which a browser does not have", limits.what));
}

}  // namespace mes
