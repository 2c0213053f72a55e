// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/format_registry.h"

namespace mes {

#define FORMAT(name) Format name##_format();
#include "core/io/format_list.inc"
#undef FORMAT

std::span<const Format> formats() {
  static const std::vector<Format> list{
#define FORMAT(name) name##_format(),
#include "core/io/format_list.inc"
#undef FORMAT
  };
  return list;
}

}  // namespace mes
