// SPDX-License-Identifier: GPL-3.0-or-later
// Files and arguments that many commands are tested with.
#pragma once

#include <string>
#include <vector>

namespace mes::test {

constexpr const char* kBean = "assets/shapes/bean.poff";
constexpr const char* kDude = "tests/data/earcut_dude.poff";
constexpr const char* kEditedBean = "tests/data/edited_bean.json";  ///< a session

inline std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace mes::test
