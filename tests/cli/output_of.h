// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <catch2/catch.hpp>

#include "tests/cli/run_binary.h"

namespace mes::test {

/// What the program prints when it succeeds without a complaint.
inline std::string output_of(const std::vector<std::string>& arguments, const RunOptions& options = {}) {
  const RunResult result = run(arguments, options);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  return result.out;
}

}  // namespace mes::test
