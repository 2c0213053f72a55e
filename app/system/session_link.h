// SPDX-License-Identifier: GPL-3.0-or-later
// A link that holds a session. Only a page in a browser has an address to which links can lead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mes {

struct SharedLink {
  enum class Kind : std::uint8_t {
    copied,    ///< on the clipboard
    shown,     ///< the clipboard refused it; it is the address of the page
    too_long,  ///< neither
  };
  Kind kind = Kind::too_long;
  std::size_t length = 0;  ///< in bytes
  std::size_t limit = 0;   ///< what servers, mail and messengers pass on
};

/// True if this program has an address.
bool may_share();

/// Copies a link that opens the text of a session. Threads: any but the window's, because the function waits.
SharedLink share_by_link(const std::string& session);

}  // namespace mes
