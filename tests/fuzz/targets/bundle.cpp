// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/bundle_checks.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mes::fuzz::check_bundles(mes::fuzz::text_of(data, size), "a.json");
  return 0;
}
