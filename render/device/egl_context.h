// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context without a window or a display server, for pictures from the command line and for tests.
//
// Guarantees: `create` returns a current context of OpenGL 3.3 core or later, or an error `no_display` whose
// text names the missing part. The context stays current on the thread that created it until it is destroyed.
//
// Smallest use:
//     auto context = EglContext::create();
//     if (!context) return std::unexpected(context.error());
//     GlDevice device;
//
// Cost: 10 to 100 ms to create. Threads: creation, use and destruction on the same one.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"

namespace mes::render {

class EglContext {
 public:
  static Expected<EglContext> create();
  ~EglContext();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;

  /// The vendor's name of the renderer and its version, for messages and logs.
  std::string description() const;

 private:
  struct Impl;
  explicit EglContext(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mes::render
