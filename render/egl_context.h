// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context without a window or a display server, for pictures from the command line and for tests.
//
// What it guarantees: either a current OpenGL 3.3 core (or better) context, or an error of code `no_display` that
// says what is missing. It stays current on the creating thread until destroyed.
//
// Smallest use:
//     auto context = EglContext::create();
//     if (!context) return std::unexpected(context.error());
//     GlDevice device;
//
// Cost: 10 to 100 ms to create. Threads: create, use and destroy on one.
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

  /// Vendor's name of the renderer and the version, for messages and logs.
  std::string description() const;

 private:
  struct Impl;
  explicit EglContext(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mes::render
