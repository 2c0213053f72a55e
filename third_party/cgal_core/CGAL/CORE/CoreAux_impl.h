// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the place of CGAL's header of this name, which it includes, for one function. CORE's own `core_error` appends
// warnings to a file `Core_Diagnostics` in the current folder, and ends the program when it cannot, or for an error; after
// the warning of a division by zero its callers end the program. Here errors and divisions by zero are thrown, other
// warnings dropped.
#pragma once

#define core_error core_error_in_a_file
#include_next <CGAL/CORE/CoreAux_impl.h>
#undef core_error

#include <stdexcept>
#include <string>

namespace CORE {

inline void core_error(std::string message, std::string /*file*/, int /*line*/, bool is_error) {
  if (is_error || message.find("division by zero") != std::string::npos) throw std::domain_error(message);
}

}  // namespace CORE
