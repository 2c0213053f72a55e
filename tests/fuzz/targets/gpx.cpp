// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sample_files.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mes::fuzz::check_sample_file(mes::fuzz::text_of(data, size), "a.gpx", "gpx");
  return 0;
}
