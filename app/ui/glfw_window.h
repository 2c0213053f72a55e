// SPDX-License-Identifier: GPL-3.0-or-later
// One window with an OpenGL context, and its events in the program's own terms.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/actions/key_chord.h"
#include "app/canvas/canvas.h"
#include "core/base/error.h"
#include "core/base/vec2.h"

struct GLFWwindow;
struct GLFWcursor;

namespace mes {

/// Positions are framebuffer pixels, y down.
class WindowListener {
 public:
  virtual ~WindowListener() = default;
  virtual void on_pointer_moved(Vec2 px, Modifiers modifiers) = 0;
  virtual void on_pointer_left() = 0;
  virtual void on_button(PointerButton button, bool pressed, Modifiers modifiers) = 0;
  virtual void on_wheel(double steps) = 0;
  /// A key that is no typed symbol (key_chord.h), by what it says on the present layout.
  virtual void on_key(const KeyChord& chord, bool repeated) = 0;
  virtual void on_typed(char32_t symbol, bool repeated) = 0;
  virtual void on_space(bool held) = 0;
  virtual void on_files_dropped(std::vector<std::string> files) = 0;
  virtual void on_close_wanted() = 0;
  /// Something happened that may change the picture, or the window was uncovered.
  virtual void on_anything() = 0;
};

/// What it guarantees: when `create` succeeds an OpenGL 3.3 core context is current; the destructor takes everything
/// back, GLFW included. One at a time. Threads: the main one, but for `wake`.
class GlfwWindow {
 public:
  struct Options {
    std::string title;
    int width = 1280;  ///< logical pixels
    int height = 800;
  };
  static Expected<std::unique_ptr<GlfwWindow>> create(const Options& options);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  GLFWwindow* handle() const { return window_; }
  void set_listener(WindowListener* listener) { listener_ = listener; }

  void poll();
  /// Sleeps until an event, `wake`, or the time is over; 0 = no limit.
  void wait(double seconds);
  /// Ends a `wait`. From any thread while the window exists.
  static void wake();

  void swap();
  void set_title(const std::string& title);
  void set_pointer_shape(PointerShape shape);
  /// Where a button went down since the last call, in screen coordinates: by the time of a late frame the pointer may
  /// be elsewhere, and the panels would take the press for one there.
  std::optional<Vec2> take_press() { return std::exchange(press_, std::nullopt); }
  struct Size {
    int width = 0;
    int height = 0;
  };
  Size framebuffer_size() const;
  Size size() const;
  /// Framebuffer pixels per screen coordinate.
  double pixel_ratio() const;
  /// Framebuffer pixels per logical pixel, as the desktop wants it.
  double content_scale() const;
  bool is_minimized() const;

 private:
  explicit GlfwWindow(GLFWwindow* window);
  void install_callbacks();
  void keep_on_screen();
  Vec2 to_framebuffer(double x, double y) const;
  void key(int key, int scancode, int action, int modifiers);
  void tell_gui(int key, int scancode, int action, int modifiers);
  void tell_gui_of_releases();

  GLFWwindow* window_;
  WindowListener* listener_ = nullptr;
  GLFWcursor* crosshair_ = nullptr;
  GLFWcursor* hand_ = nullptr;
  PointerShape shape_ = PointerShape::arrow;
  std::string title_;
  Vec2 pointer_;  // as of the last event, in screen coordinates
  std::optional<Vec2> press_;
  struct Release {
    int key;
    int scancode;
    int modifiers;
  };
  std::vector<int> just_pressed_;  // since the last frame
  std::vector<Release> releases_;  // of those; Dear ImGui hears of them after the next frame
  bool key_repeats_ = false;       // of the key whose typed text comes next
};

}  // namespace mes
