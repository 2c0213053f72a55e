// SPDX-License-Identifier: GPL-3.0-or-later
// Deleters for the objects of C libraries.
#pragma once

namespace mes {

/// For std::unique_ptr: calls the library's function that destroys the object.
template <auto kDestroy>
struct DestroyedBy {
  void operator()(auto* object) const { kDestroy(object); }
};

}  // namespace mes
