// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace mes {

/// How an element of a provenance relates to the element that is asked about.
enum class ProvenanceRole : std::uint8_t { itself, origin, product };

}  // namespace mes
