// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/certificate/axis_certificate.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_certificate_structures(Registry& registry) {
  registry.add_structure<AxisCertificate, Delaunay, Labels, InnerBalls>();
}

}  // namespace mes
