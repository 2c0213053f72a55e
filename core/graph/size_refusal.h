// SPDX-License-Identifier: GPL-3.0-or-later
// What a structure throws that would become too large.
#pragma once

#include "core/base/error.h"

namespace mes {

/// Thrown inside a structure that would hold more than can be computed or drawn. It becomes a failed node like any other
/// `GeometryError`, but says nothing against the results of number types, so the theorem light goes without it.
struct SizeRefusal : GeometryError {
  using GeometryError::GeometryError;
};

}  // namespace mes
