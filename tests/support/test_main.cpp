// SPDX-License-Identifier: GPL-3.0-or-later
// Catch2's own main function ends with the number of failed assertions, and CTest would take as many as its code for
// "skipped" for that.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

int main(int argc, char** argv) {
  return Catch::Session().run(argc, argv) == 0 ? 0 : 1;
}
