// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that an experiment has the properties that the program's own structures have.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/library/experiments.h"

namespace mes {

class Registry;

/// One line of the result table.
struct CheckResult {
  std::string subject{};  ///< id of the structure, layer, evolution or shape
  std::string property{};
  std::string result{};  ///< "ok, 240 edits", or what went wrong, in one line
  bool is_good = true;
};

/// Tries what was added to the registry:
///  - degenerate inputs (no to three samples, collinear and cocircular ones, duplicates, extreme numbers) are computed,
///  - through random edits, an update gives the same tables and drawings as a computation from scratch,
///  - numbers are finite,
///  - layers drawn on two threads at the same time equal those drawn on one,
///  - evolutions keep the number of samples and do not depend on earlier calls, shapes can be sampled,
/// and measures the time per row. The results are in the order of the additions. Seed and inputs are always the same.
std::vector<CheckResult> check_experiment(const Registry& registry, const ExperimentContents& added);

}  // namespace mes
