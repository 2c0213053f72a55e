// SPDX-License-Identifier: GPL-3.0-or-later
// The third coordinates of a file, which the plane has no room for. Private to core/io.
#pragma once

#include <optional>
#include <string_view>

namespace mes {

/// Notes whether all are equal: then leaving them out loses nothing.
class Heights {
 public:
  void add(double z) {
    if (!first_) first_ = z;
    differ_ = differ_ || z != *first_;
  }
  bool differ() const { return differ_; }
  static constexpr std::string_view kRemark = "heights are left out";

 private:
  std::optional<double> first_;
  bool differ_ = false;
};

}  // namespace mes
