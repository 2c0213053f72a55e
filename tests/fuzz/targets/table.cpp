// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of coordinates, as each of the formats and as what they look like. The first byte says which.
#include <array>

#include "tests/fuzz/sample_files.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<std::string_view, 5> kFormats{"", "csv", "tsv", "xyz", "pairs"};
  if (size == 0) return 0;
  mes::fuzz::check_sample_file(mes::fuzz::text_of(data + 1, size - 1), "a.txt", kFormats[data[0] % kFormats.size()]);
  return 0;
}
