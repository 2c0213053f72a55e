// SPDX-License-Identifier: GPL-3.0-or-later
// A page has no library GDAL.
#include "core/io/maps/gdal_library.h"

namespace mes {

Expected<const GdalLibrary*> gdal_library() {
  return std::unexpected(
      Error{ErrorCode::bad_input, "this format needs the library GDAL, which a browser does not have"});
}

}  // namespace mes
