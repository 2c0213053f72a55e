// SPDX-License-Identifier: GPL-3.0-or-later
// The structures of this room, a line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/certificate/axis_certificate.h"

namespace mes {

/// After the rooms that it uses.
inline void add_certificate_structures(Registry& registry) {
  registry.add_structure<AxisCertificate, Delaunay, Labels, InnerBalls>();
}

}  // namespace mes
