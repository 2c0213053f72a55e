// SPDX-License-Identifier: GPL-3.0-or-later
// The exception of a structure that would become too large.
#pragma once

#include "core/base/error.h"

namespace mes {

/// Thrown by a structure that would hold more than can be computed or drawn. It causes a failed node like any other
/// `GeometryError`, but says nothing about the results of number types, so the theorem light ignores it.
struct SizeRefusal : GeometryError {
  using GeometryError::GeometryError;
};

}  // namespace mes
