// SPDX-License-Identifier: GPL-3.0-or-later
// What the window has to tell the user.
#pragma once

#include <string>
#include <utility>

namespace mes {

/// A remark stands in the status bar until the next one; a problem stands above the canvas until it is closed or
/// something succeeds that makes it stale.
class Messages {
 public:
  void remark(std::string text) { remark_ = std::move(text); }
  void problem(std::string text) { problem_ = std::move(text); }
  void clear_remark() { remark_.clear(); }
  void clear_problem() { problem_.clear(); }
  const std::string& remark() const { return remark_; }
  const std::string& problem() const { return problem_; }

 private:
  std::string remark_;
  std::string problem_;
};

}  // namespace mes
