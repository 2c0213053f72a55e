// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/looks/color_maps.h"
#include "tests/fuzz/reader_checks.h"

void mes::fuzz::run_color_map(std::string_view bytes) {
  const auto map = mes::parse_color_map(bytes, "a", "a.map");
  require_little_memory(bytes.size());
  require_little_work(bytes.size(), kPlainWork);
  if (!map) {
    require_error(map.error(), bytes);
    return;
  }
  std::string text;
  for (const auto& color : map->colors)
    for (int i = 0; i < 3; ++i) {
      const float part = color[i];
      require(part >= 0.0F && part <= 1.0F, "parts of colours are from 0 to 1");
      mes::append_number(text, static_cast<double>(part));
      text += ' ';
    }
  const auto again = require_read(mes::parse_color_map(text, "a", "again.map"));
  require(again.colors == map->colors, "what is written reads back equal");
}
