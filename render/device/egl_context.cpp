// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/device/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <utility>

namespace mes::render {
namespace {

Error unavailable(const std::string& what) {
  return {.code = ErrorCode::no_display, .text = "no OpenGL 3.3 for drawing: " + what};
}

bool has_library(const char* name) {
  void* const handle = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}

/// The first library whose absence would make epoxy end the program; empty if all are present.
std::string missing_library() {
  if (!has_library("libEGL.so.1")) return "there is no libEGL.so.1";
  if (!has_library("libOpenGL.so.0") && !has_library("libGL.so.1")) return "there is no libGL.so.1";
  return {};
}

bool has_client_extension(const char* name) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

/// The display of an attempt: displays without a display server come first.
EGLDisplay open_display(std::size_t attempt) {
  if (attempt == 0) {
    if (!has_client_extension("EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }
  if (attempt == 1) {
    if (!has_client_extension("EGL_EXT_platform_device") || !has_client_extension("EGL_EXT_device_enumeration")) {
      return EGL_NO_DISPLAY;
    }
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (eglQueryDevicesEXT(1, &device, &count) == EGL_FALSE || count == 0) return EGL_NO_DISPLAY;
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  }
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}
constexpr std::size_t kAttempts = 3;

}  // namespace

struct EglContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { close(); }

  void close() {
    if (display == EGL_NO_DISPLAY) return;
    // Another context may be current by now.
    if (context != EGL_NO_CONTEXT && eglGetCurrentContext() == context) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglReleaseThread();
    }
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    // The display stays initialised: the process has only one, other contexts may use it, and drivers leak memory when
    // they are unloaded.
    display = EGL_NO_DISPLAY;
    context = EGL_NO_CONTEXT;
  }

  /// Returns the failed step; empty on success.
  std::string open(std::size_t attempt) {
    display = open_display(attempt);
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) == EGL_FALSE) {
      display = EGL_NO_DISPLAY;
      return "EGL cannot be started";
    }
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) {
      return "EGL cannot draw without a window";
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return "EGL offers no desktop OpenGL";
    constexpr std::array<EGLint, 5> kWanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, kWanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
      return "EGL has no configuration for OpenGL";
    }
    constexpr std::array<EGLint, 7> kVersion{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, kVersion.data());
    if (context == EGL_NO_CONTEXT) return "the driver has no core profile 3.3";
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
      return "the context cannot be made current";
    }
    return {};
  }
};

Expected<EglContext> EglContext::create() {
  if (const std::string missing = missing_library(); !missing.empty()) return std::unexpected(unavailable(missing));
  std::string reason;
  for (std::size_t attempt = 0; attempt < kAttempts; ++attempt) {
    auto impl = std::make_unique<Impl>();
    const std::string problem = impl->open(attempt);
    if (problem.empty()) return EglContext(std::move(impl));
    if (reason.empty()) reason = problem;
  }
  return std::unexpected(unavailable(reason));
}

EglContext::EglContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EglContext::~EglContext() = default;
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;

std::string EglContext::description() const {
  const auto text = [](GLenum name) {
    const auto* bytes = glGetString(name);
    return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace mes::render
