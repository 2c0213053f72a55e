// SPDX-License-Identifier: GPL-3.0-or-later
// A browser draws on its page only.
#include "render/device/egl_context.h"

namespace mes::render {

struct EglContext::Impl {};

Expected<EglContext> EglContext::create() {
  return std::unexpected(
      Error{.code = ErrorCode::no_display, .text = "a browser draws on its page, and nowhere else"});
}

EglContext::EglContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EglContext::~EglContext() = default;
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;

std::string EglContext::description() const {
  return {};
}

}  // namespace mes::render
