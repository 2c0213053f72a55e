// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices with segments and faces, as each of their formats. The first byte says which.
#include <array>

#include "tests/fuzz/sample_files.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mes::fuzz;
  constexpr std::array<std::string_view, 5> kFormats{"triangle", "edg", "obj", "off", "ply"};
  if (size == 0) return 0;
  const std::string_view bytes = text_of(data + 1, size - 1);
  const auto file = mes::read_sample_bytes(bytes, "a", kFormats[data[0] % kFormats.size()]);
  require_little_memory(bytes.size(), 600);
  if (!file) {
    // What follows the header of a PLY may be binary: then the place is in the message.
    require_error(file.error(), bytes);
    return 0;
  }
  for (const std::string& warning : file->warnings) require_message(warning);
  require_round_trip(file->data);
  return 0;
}
