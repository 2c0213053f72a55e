// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/screen/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "imgui_impl_glfw.h"

namespace mes {
namespace {

Modifiers modifiers_of(int bits) {
  return {(bits & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0, (bits & GLFW_MOD_SHIFT) != 0,
          (bits & GLFW_MOD_ALT) != 0};
}

// Cursor events have no modifiers.
Modifiers modifiers_now(GLFWwindow* window) {
  const auto held = [window](int left, int right) {
    return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
  };
  return {held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) || held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER),
          held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT), held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

bool is_modifier(int code) {
  return (code >= GLFW_KEY_LEFT_SHIFT && code <= GLFW_KEY_LEFT_SUPER) ||
         (code >= GLFW_KEY_RIGHT_SHIFT && code <= GLFW_KEY_RIGHT_SUPER);
}

char32_t named_key(int code) {
  switch (code) {
    case GLFW_KEY_ESCAPE: return key::escape;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return key::enter;
    case GLFW_KEY_TAB: return key::tab;
    case GLFW_KEY_BACKSPACE: return key::backspace;
    case GLFW_KEY_DELETE: return key::del;
    case GLFW_KEY_HOME: return key::home;
    case GLFW_KEY_END: return key::end;
    case GLFW_KEY_LEFT: return key::left;
    case GLFW_KEY_RIGHT: return key::right;
    case GLFW_KEY_UP: return key::up;
    case GLFW_KEY_DOWN: return key::down;
    case GLFW_KEY_PAGE_UP: return key::page_up;
    case GLFW_KEY_PAGE_DOWN: return key::page_down;
    case GLFW_KEY_MENU: return key::menu;
    default: break;
  }
  if (code >= GLFW_KEY_F1 && code <= GLFW_KEY_F12) return key::f1 + static_cast<char32_t>(code - GLFW_KEY_F1);
  return 0;
}

// The label of the key on the user's layout, or on the American one if that has no Latin letters.
char32_t printed_key(int code, int scancode) {
  const char* name = glfwGetKeyName(code, scancode);
  if (name != nullptr && name[0] > ' ' && name[0] <= '~' && name[1] == '\0')
    return static_cast<char32_t>(name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0]);
  if (code > GLFW_KEY_SPACE && code <= GLFW_KEY_GRAVE_ACCENT) return static_cast<char32_t>(code);
  return 0;
}

GlfwWindow* self_of(GLFWwindow* window) {
  return static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
}

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

}  // namespace

Expected<std::unique_ptr<GlfwWindow>> GlfwWindow::create(const Options& options) {
  const auto refuse = [](const std::string& what) {
    return std::unexpected(
        Error{ErrorCode::no_display,
              fmt::format("{}: {}; mesecina render draws pictures without a display", what, last_glfw_error())});
  };
  if (glfwInit() != GLFW_TRUE) return refuse("cannot open a window");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  // A lecture goes on when the pointer is used on another screen.
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "mesecina");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "mesecina");
  GLFWwindow* window = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    auto error = refuse("cannot open a window with OpenGL 3.3");
    glfwTerminate();
    return error;
  }
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  return std::unique_ptr<GlfwWindow>(new GlfwWindow(window));
}

GlfwWindow::GlfwWindow(GLFWwindow* window)
    : window_(window), shows_rest_(std::getenv("MESECINA_SHOWS_REST") != nullptr) {
  glfwSetWindowUserPointer(window_, this);
  glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
  crosshair_ = glfwCreateStandardCursor(GLFW_CROSSHAIR_CURSOR);
  hand_ = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
  install_callbacks();
  keep_on_screen();
}

// A size from another screen may be too large for this one.
void GlfwWindow::keep_on_screen() {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  int x = 0;
  int y = 0;
  Size free;
  glfwGetMonitorWorkarea(monitor, &x, &y, &free.width, &free.height);
  const Size now = size();
  if (free.width < 1 || free.height < 1 || (now.width <= free.width && now.height <= free.height)) return;
  glfwSetWindowSize(window_, std::min(now.width, free.width), std::min(now.height, free.height));
  glfwSetWindowPos(window_, x, y);
}

GlfwWindow::~GlfwWindow() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void GlfwWindow::install_callbacks() {
  // Dear ImGui gets all events too; the listener decides which of both acts on them.
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    GlfwWindow* self = self_of(window);
    self->pointer_ = {x, y};
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    self->listener_->on_pointer_moved(self->to_framebuffer(x, y), modifiers_now(window));
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
    GlfwWindow* self = self_of(window);
    ImGui_ImplGlfw_CursorEnterCallback(window, entered);
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    if (entered == GLFW_FALSE) self->listener_->on_pointer_left();
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int bits) {
    GlfwWindow* self = self_of(window);
    ImGui_ImplGlfw_MouseButtonCallback(window, button, action, bits);
    if (action == GLFW_PRESS && !self->press_) self->press_ = self->pointer_;
    if (action == GLFW_RELEASE) self->release_ = self->pointer_;
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    // The press happened where the last move ended; the present position may belong to later events.
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const PointerButton which = button == GLFW_MOUSE_BUTTON_LEFT    ? PointerButton::left
                                : button == GLFW_MOUSE_BUTTON_RIGHT ? PointerButton::right
                                                                    : PointerButton::middle;
    self->listener_->on_button(which, action == GLFW_PRESS, modifiers_of(bits));
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
    GlfwWindow* self = self_of(window);
    ImGui_ImplGlfw_ScrollCallback(window, x, y);
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    self->listener_->on_wheel(y);
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int code, int scancode, int action, int bits) {
    GlfwWindow* self = self_of(window);
    if (self->shows_rest_ && code == GLFW_KEY_PAUSE) {
      if (action == GLFW_PRESS) ++self->rest_asked_;
      return;
    }
    self->tell_gui(code, scancode, action, bits);
    self->key(code, scancode, action, bits);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int symbol) {
    GlfwWindow* self = self_of(window);
    ImGui_ImplGlfw_CharCallback(window, symbol);
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    self->listener_->on_typed(static_cast<char32_t>(symbol), self->key_repeats_);
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) {
    GlfwWindow* self = self_of(window);
    ImGui_ImplGlfw_WindowFocusCallback(window, focused);
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    if (focused == GLFW_FALSE) self->listener_->on_space(false);
    if (focused == GLFW_FALSE) self->listener_->on_key_held(0, false);
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    GlfwWindow* self = self_of(window);
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    self->listener_->on_files_dropped({paths, paths + count});
  });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) {
    GlfwWindow* self = self_of(window);
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    if (self->listener_ == nullptr) return;
    self->listener_->on_anything();
    self->listener_->on_close_wanted();
  });
  const auto redraw = [](GLFWwindow* window) {
    if (GlfwWindow* self = self_of(window); self->listener_ != nullptr) self->listener_->on_anything();
  };
  glfwSetWindowRefreshCallback(window_, redraw);
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) {
    if (GlfwWindow* self = self_of(window); self->listener_ != nullptr) self->listener_->on_anything();
  });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* window, float, float) {
    if (GlfwWindow* self = self_of(window); self->listener_ != nullptr) self->listener_->on_anything();
  });
}

// Dear ImGui polls the keys once per frame, so it would miss a key pressed and released between two frames.
void GlfwWindow::tell_gui(int code, int scancode, int action, int bits) {
  const bool is_new = std::ranges::find(just_pressed_, code) != just_pressed_.end();
  if (action == GLFW_RELEASE && is_new) {
    releases_.push_back({code, scancode, bits});
    return;
  }
  std::erase_if(releases_, [&](const Release& release) { return release.key == code; });
  if (action == GLFW_PRESS && !is_new) just_pressed_.push_back(code);
  ImGui_ImplGlfw_KeyCallback(window_, code, scancode, action, bits);
}

void GlfwWindow::tell_gui_of_releases() {
  just_pressed_.clear();
  if (releases_.empty()) return;
  for (const Release& release : std::exchange(releases_, {}))
    ImGui_ImplGlfw_KeyCallback(window_, release.key, release.scancode, GLFW_RELEASE, release.modifiers);
  if (listener_ != nullptr) listener_->on_anything();
}

void GlfwWindow::key(int code, int scancode, int action, int bits) {
  if (listener_ == nullptr) return;
  listener_->on_anything();
  key_repeats_ = action == GLFW_REPEAT;
  if (code == GLFW_KEY_SPACE && action != GLFW_REPEAT) listener_->on_space(action == GLFW_PRESS);
  if (is_modifier(code) && action != GLFW_REPEAT) listener_->on_modifiers(modifiers_now(window_));
  if (action != GLFW_REPEAT)
    if (const char32_t symbol = printed_key(code, scancode)) listener_->on_key_held(symbol, action == GLFW_PRESS);
  if (action == GLFW_RELEASE) return;
  KeyChord chord{named_key(code), modifiers_of(bits)};
  if (chord.symbol == 0) chord.symbol = printed_key(code, scancode);
  // Symbols arrive as text (on_typed), because the layout decides which keys type them.
  if (chord.symbol == 0 || code == GLFW_KEY_SPACE || is_typed_symbol(chord)) return;
  listener_->on_key(chord, key_repeats_);
}

Vec2 GlfwWindow::to_framebuffer(double x, double y) const {
  const double ratio = pixel_ratio();
  return {x * ratio, y * ratio};
}

std::optional<Vec2> GlfwWindow::take_click() {
  return std::exchange(press_ ? press_ : release_, std::nullopt);
}

void GlfwWindow::swap() {
  glfwSwapBuffers(window_);
  tell_gui_of_releases();
}

void GlfwWindow::set_title(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  show_title();
}

void GlfwWindow::show_title() {
  const std::string shown = rest_answered_ == 0 ? title_ : fmt::format("{} ({})", title_, rest_answered_);
  glfwSetWindowTitle(window_, shown.c_str());
}

void GlfwWindow::answer_rest() {
  rest_answered_ = rest_asked_;
  show_title();
}

void GlfwWindow::set_pointer_shape(PointerShape shape) {
  if (glfwGetInputMode(window_, GLFW_CURSOR) == GLFW_CURSOR_HIDDEN)
    glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_NORMAL);
  if (shape == shape_) return;
  shape_ = shape;
  GLFWcursor* cursor = shape == PointerShape::crosshair ? crosshair_ : shape == PointerShape::hand ? hand_ : nullptr;
  glfwSetCursor(window_, cursor);
}

GlfwWindow::Size GlfwWindow::framebuffer_size() const {
  Size out;
  glfwGetFramebufferSize(window_, &out.width, &out.height);
  return out;
}

GlfwWindow::Size GlfwWindow::size() const {
  Size out;
  glfwGetWindowSize(window_, &out.width, &out.height);
  return out;
}

double GlfwWindow::pixel_ratio() const {
  const Size inner = framebuffer_size();
  const Size outer = size();
  return outer.width > 0 && inner.width > 0 ? static_cast<double>(inner.width) / outer.width : 1.0;
}

double GlfwWindow::content_scale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::clamp(static_cast<double>(std::max(x, y)), 0.5, 8.0);
}

GlfwWindow::Frame GlfwWindow::frame() const {
  Frame out{.size = size()};
  glfwGetWindowPos(window_, &out.x, &out.y);
  return out;
}

bool GlfwWindow::is_full_screen() const {
  return glfwGetWindowMonitor(window_) != nullptr;
}

GlfwWindow::Size GlfwWindow::windowed_size() const {
  return is_full_screen() ? windowed_.size : size();
}

void GlfwWindow::set_full_screen(bool is_full) {
  if (is_full == is_full_screen()) return;
  if (!is_full)
    return glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.size.width,
                                windowed_.size.height, GLFW_DONT_CARE);
  windowed_ = frame();
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  GLFWmonitor* best = nullptr;
  long long most = -1;
  for (int i = 0; i < count; ++i) {
    const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    int x = 0;
    int y = 0;
    glfwGetMonitorPos(monitors[i], &x, &y);
    const auto shared = [](int from, int length, int begin, int room) {
      return static_cast<long long>(std::max(0, std::min(from + length, begin + room) - std::max(from, begin)));
    };
    const long long area = shared(windowed_.x, windowed_.size.width, x, mode->width) *
                           shared(windowed_.y, windowed_.size.height, y, mode->height);
    if (area > most) best = monitors[i];
    most = std::max(most, area);
  }
  if (best == nullptr) return;
  const GLFWvidmode* const mode = glfwGetVideoMode(best);
  glfwSetWindowMonitor(window_, best, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool GlfwWindow::is_minimized() const {
  return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

}  // namespace mes
