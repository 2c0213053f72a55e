// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/evolutions/evolution.h"

namespace mes {

#define EVOLUTION(name) Evolution name##_evolution();
#include "core/evolutions/evolution_list.inc"
#undef EVOLUTION

std::span<const Evolution> evolutions() {
  static const std::vector<Evolution> list{
#define EVOLUTION(name) name##_evolution(),
#include "core/evolutions/evolution_list.inc"
#undef EVOLUTION
  };
  return list;
}

}  // namespace mes
