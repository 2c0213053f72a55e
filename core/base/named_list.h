// SPDX-License-Identifier: GPL-3.0-or-later
// A list of objects with ids.
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

/// Objects with ids, in the order of insertion. Whoever holds an object keeps it, also after its removal from the list.
template <class T>
class NamedList {
 public:
  /// The id must be new.
  void add(std::string id, std::shared_ptr<const T> thing) {
    MES_ASSERT(find(id) == nullptr);
    ids_.push_back(std::move(id));
    things_.push_back(std::move(thing));
  }
  /// Returns false if no object has the id.
  bool remove(std::string_view id) {
    const auto found = std::ranges::find(ids_, id);
    if (found == ids_.end()) return false;
    things_.erase(things_.begin() + (found - ids_.begin()));
    ids_.erase(found);
    return true;
  }
  /// Returns null if no object has the id.
  std::shared_ptr<const T> find(std::string_view id) const {
    const auto found = std::ranges::find(ids_, id);
    return found == ids_.end() ? nullptr : things_[static_cast<std::size_t>(found - ids_.begin())];
  }
  std::span<const std::string> ids() const { return ids_; }
  std::span<const std::shared_ptr<const T>> all() const { return things_; }

 private:
  std::vector<std::string> ids_;
  std::vector<std::shared_ptr<const T>> things_;  // parallel to `ids_`
};

}  // namespace mes
