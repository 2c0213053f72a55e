// SPDX-License-Identifier: GPL-3.0-or-later
// Catch2's own main function returns the number of failed assertions, and one such number is the code that CTest takes
// for "skipped".
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

int main(int argc, char** argv) {
  return Catch::Session().run(argc, argv) == 0 ? 0 : 1;
}
