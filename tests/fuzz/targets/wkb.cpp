// SPDX-License-Identifier: GPL-3.0-or-later
// Maps. Bytes have no lines, and places in them are in the messages; hexadecimal digits have both.
#include "tests/fuzz/sample_files.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mes::fuzz;
  constexpr std::size_t kMostMemory = std::size_t{2} << 30U;
  constexpr std::size_t kFewSamples = 10'000;
  const std::string_view bytes = text_of(data, size);
  const auto file = mes::read_sample_bytes(bytes, "a", "wkb");
  require(peak_bytes() <= kMostMemory, "bounded memory: " + std::to_string(peak_bytes()));
  if (!file) {
    require_error(file.error(), bytes);
    return 0;
  }
  for (const std::string& warning : file->warnings) require_message(warning);
  if (file->data.positions.size() <= kFewSamples) require_round_trip(file->data);
  return 0;
}
