// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesecina/version.h>

#include <tuple>

namespace mesecina {
inline namespace v1 {

static_assert(kVersion == MESECINA_VERSION, "core/library/mesecina/version.h has the version of the project");

std::string_view version() noexcept {
  return kVersion;
}

bool is_compatible(int major, int minor, int patch) noexcept {
  if (major != kVersionMajor || (major == 0 && minor != kVersionMinor)) return false;
  return std::tuple(kVersionMinor, kVersionPatch) >= std::tuple(minor, patch);
}

}  // namespace v1
}  // namespace mesecina
