// SPDX-License-Identifier: GPL-3.0-or-later
// A page has no library PROJ. Maps in longitude and latitude are read without it.
#include "core/io/systems/proj_library.h"

namespace mes {

Expected<const ProjLibrary*> proj_library() {
  return std::unexpected(Error{ErrorCode::bad_input, "maps need the library PROJ, which a browser does not have"});
}

ProjContext new_context(const ProjLibrary& proj) {
  return {nullptr, ProjDeleter{&proj}};
}

}  // namespace mes
