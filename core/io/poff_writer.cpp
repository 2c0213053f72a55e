// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <unordered_map>

#include "core/document/document.h"
#include "core/io/format.h"
#include "core/io/text_numbers.h"

namespace mes {

std::string write_poff(const Document& document) {
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  constexpr std::size_t kTypicalLine = 40;
  std::string out = fmt::format("POFF {} 0 0\n", slots.size());
  out.reserve(out.size() + slots.size() * kTypicalLine);
  // In the file.
  Table<SampleSlot, std::uint32_t> number(document.slot_count(), 0);
  std::uint32_t next = 0;
  for (const SampleSlot slot : slots) {
    const Vec2 p = document.position(slot);
    append_number(out, p.x);
    out += ' ';
    append_number(out, p.y);
    out += '\n';
    number[slot] = next++;
  }
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    const std::size_t before = out.size();
    out += contour.closed ? "# loop closed" : "# loop open";
    bool has_samples = false;
    for (const SampleId id : contour.samples) {
      const SampleSlot slot = document.slot_of(id);
      if (slot == kNoSlot) continue;
      out += ' ';
      out += std::to_string(number[slot]);
      has_samples = true;
    }
    if (has_samples) {
      out += '\n';
    } else {
      out.resize(before);
    }
  }
  return out;
}

}  // namespace mes
