// SPDX-License-Identifier: GPL-3.0-or-later
// A registry that is replaced while the program runs.
#pragma once

#include <memory>
#include <utility>

#include "core/graph/registry.h"

namespace mes {

/// All copies read the registry that was last set through any of them. A job on another thread owns the registry that
/// it started with.
///
/// Smallest use:
///     LiveRegistry registry(builtins());
///     const LiveRegistry of_a_window = registry;
///     const auto of_a_job = of_a_window.share();
///     registry.set(std::make_shared<const Registry>(changed));
///     of_a_window.now().find_layer("points");
///
/// Cost: copies and `share` share ownership. Threads: one for all copies; any thread may read the registry itself.
class LiveRegistry {
 public:
  /// The registry must outlive the copies, and all results of `share`.
  LiveRegistry(const Registry& registry) : LiveRegistry(Shared(Shared(), &registry)) {}
  LiveRegistry(const Registry&& registry) = delete;
  explicit LiveRegistry(std::shared_ptr<const Registry> registry)
      : present_(std::make_shared<Shared>(std::move(registry))) {}

  /// Valid until the next `set`.
  const Registry& now() const { return **present_; }
  std::shared_ptr<const Registry> share() const { return *present_; }
  void set(std::shared_ptr<const Registry> registry) { *present_ = std::move(registry); }

 private:
  using Shared = std::shared_ptr<const Registry>;
  std::shared_ptr<Shared> present_;
};

}  // namespace mes
