// SPDX-License-Identifier: GPL-3.0-or-later
// A list of things that are known by their ids.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/assert.h"

namespace mes {

/// Things that are known by their ids, in the order in which they were added. Whoever holds one keeps it, also after it
/// has been removed here.
template <class T>
class NamedList {
 public:
  /// Its id must be new.
  void add(std::string id, std::shared_ptr<const T> thing) {
    MES_ASSERT(find(id) == nullptr);
    ids_.push_back(std::move(id));
    things_.push_back(std::move(thing));
  }
  /// False: there is none.
  bool remove(std::string_view id) {
    const auto found = std::ranges::find(ids_, id);
    if (found == ids_.end()) return false;
    things_.erase(things_.begin() + (found - ids_.begin()));
    ids_.erase(found);
    return true;
  }
  /// Null: there is none.
  std::shared_ptr<const T> find(std::string_view id) const {
    const auto found = std::ranges::find(ids_, id);
    return found == ids_.end() ? nullptr : things_[static_cast<std::size_t>(found - ids_.begin())];
  }
  std::span<const std::string> ids() const { return ids_; }
  std::span<const std::shared_ptr<const T>> all() const { return things_; }

 private:
  std::vector<std::string> ids_;
  std::vector<std::shared_ptr<const T>> things_;  // as many as ids
};

}  // namespace mes
