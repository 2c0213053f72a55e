// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

#include <mutex>
#include <set>

namespace mes {

std::string_view keep_text(std::string text) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> texts;
  const std::lock_guard lock(mutex);
  return *texts.insert(std::move(text)).first;
}

}  // namespace mes
