// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the screen of an X server, and the names of its windows.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/window/window_driver.h"

struct _XDisplay;

namespace mes::test {

/// A connection to a server that runs as long as this object.
class XConnection {
 public:
  /// `display` as in the environment variable DISPLAY.
  explicit XConnection(const std::string& display);

  bool is_open() const { return display_ != nullptr; }
  /// All of the screen; empty if the server does not answer.
  Screenshot shoot() const;
  /// Names of all windows that have one.
  std::vector<std::string> window_names() const;
  /// Drags a file onto the window whose name has these words, and drops it in the middle. Returns true once the window
  /// has taken it.
  bool drop(const std::string& words, const std::string& file) const;
  /// The text that the owner of the clipboard gives; empty without one.
  std::string clipboard() const;

 private:
  std::shared_ptr<_XDisplay> display_;
};

}  // namespace mes::test
