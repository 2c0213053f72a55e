// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/own_font.h"

#include <system_error>

namespace mes {

Expected<FontFile> own_font(const std::filesystem::path& assets) {
  FontFile out{.path = assets / "fonts" / "Inter-Regular.otf", .index = 0, .name = "Inter"};
  std::error_code error;
  if (!std::filesystem::is_regular_file(out.path, error))
    return std::unexpected(
        Error{ErrorCode::bad_input, "the font of the program is missing; name another one", out.path.string()});
  return out;
}

}  // namespace mes
