// SPDX-License-Identifier: GPL-3.0-or-later
// Checks an experiment for the properties that the structures of the program have.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/library/experiments.h"

namespace mes {

class Registry;

/// One line of the table.
struct CheckResult {
  std::string subject{};  ///< id of the structure, layer, evolution or shape
  std::string property{};
  std::string result{};  ///< "ok, 240 edits", or what went wrong, in one line
  bool is_good = true;
};

/// Tries what was added to the registry:
///  - degenerate inputs (none to three samples, collinear and cocircular ones, duplicates, extreme numbers) are computed,
///  - an update gives the tables and drawings that a computation anew gives, through random edits,
///  - numbers are finite,
///  - layers that are drawn on two threads at the same time are as those drawn on one,
///  - evolutions keep the number of samples and do not depend on earlier calls, shapes can be sampled,
/// and measures the time of a row. The results are in the order of what was added. Seed and inputs are always the same.
std::vector<CheckResult> check_experiment(const Registry& registry, const ExperimentContents& added);

}  // namespace mes
