// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/systems/coordinate_system.h"

#include <cmath>

#include "tests/fuzz/reader_checks.h"

/// The description of a coordinate system, as a map or the file beside it has one.
void mes::fuzz::run_coordinate_system(std::string_view bytes) {
  const auto system = mes::find_coordinate_system(bytes);
  require_little_memory(bytes.size(), 10'000, kMemoryOfProj);
  if (!system) return require_error(system.error(), {});
  require_message(system->title());
  require(std::isfinite(system->unit_size) && system->unit_size > 0.0, "a unit has a size");
  require(system->major_axis > 0.0 && system->minor_axis > 0.0, "the Earth is not flat");
  const auto again = require_read(mes::find_coordinate_system(system->id));
  require(again.unit == system->unit && again.is_geographic == system->is_geographic,
          "the id of a system is that of the same: " + system->id);
}
