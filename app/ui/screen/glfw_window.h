// SPDX-License-Identifier: GPL-3.0-or-later
// One window with an OpenGL context, and its events in the program's own terms.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/actions/key_chord.h"
#include "app/actions/pointer_input.h"
#include "core/base/error.h"
#include "core/base/geometry/vec2.h"

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
  /// A key that types no symbol (key_chord.h), by its label on the present layout.
  virtual void on_key(const KeyChord& chord, bool repeated) = 0;
  virtual void on_typed(char32_t symbol, bool repeated) = 0;
  virtual void on_space(bool held) = 0;
  /// A key of the keyboard went down or up, by its label on the present layout (`KeyChord::symbol`). The symbol 0
  /// means that all keys are up.
  virtual void on_key_held(char32_t symbol, bool held) = 0;
  /// Ctrl, Shift or Alt went down or up, wherever the pointer is.
  virtual void on_modifiers(Modifiers modifiers) = 0;
  virtual void on_files_dropped(std::vector<std::string> files) = 0;
  virtual void on_close_wanted() = 0;
  /// Any event that may change the picture, including the window being uncovered.
  virtual void on_anything() = 0;
};

/// Guarantees: after `create` succeeds, a context of OpenGL 3.3 core is current; the destructor releases everything,
/// GLFW included. One window at a time. Threads: the main one, except for `wake`.
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
  /// Sleeps until an event, `wake`, or the end of the time; 0 means no limit.
  void wait(double seconds);
  /// Ends a `wait`. Callable from any thread while the window exists.
  static void wake();

  void swap();
  void set_title(const std::string& title);
  /// For tests of the window, which must know when all their input has become visible. If MESECINA_SHOWS_REST is set,
  /// a press of Pause requests an answer, and `answer_rest` appends the number of presses so far to the title.
  bool is_asked_for_rest() const { return rest_asked_ > rest_answered_; }
  void answer_rest();
  void set_pointer_shape(PointerShape shape);
  /// Where a button was pressed since the last call, then where it was released, in screen coordinates. When a late
  /// frame begins, the pointer may be elsewhere, and panels would see the click there.
  std::optional<Vec2> take_click();
  struct Size {
    int width = 0;
    int height = 0;
  };
  Size framebuffer_size() const;
  Size size() const;
  /// Framebuffer pixels per screen coordinate.
  double pixel_ratio() const;
  /// Framebuffer pixels per logical pixel, as the desktop sets it.
  double content_scale() const;
  bool is_minimized() const;
  /// Covers the screen that shows most of the window, or puts the window back where it was.
  void set_full_screen(bool is_full);
  bool is_full_screen() const;
  /// The size that the window has without full screen.
  Size windowed_size() const;
  /// The handle with which other programs put a window above this one: "x11:" and its number in hexadecimal; empty if
  /// it has none.
  std::string desktop_handle() const;

 private:
  explicit GlfwWindow(GLFWwindow* window);
  void install_callbacks();
  void keep_on_screen();
  Vec2 to_framebuffer(double x, double y) const;
  void key(int key, int scancode, int action, int modifiers);
  void tell_gui(int key, int scancode, int action, int modifiers);
  void tell_gui_of_releases();
  void show_title();

  GLFWwindow* window_;
  WindowListener* listener_ = nullptr;
  GLFWcursor* crosshair_ = nullptr;
  GLFWcursor* hand_ = nullptr;
  PointerShape shape_ = PointerShape::arrow;
  std::string title_;
  struct Frame {
    int x = 0;
    int y = 0;
    Size size;
  };
  Frame frame() const;
  Frame windowed_;  // while the window covers the screen: its frame before
  Vec2 pointer_;    // at the last event, in screen coordinates
  std::optional<Vec2> press_;
  std::optional<Vec2> release_;
  struct Release {
    int key;
    int scancode;
    int modifiers;
  };
  std::vector<int> just_pressed_;  // since the last frame
  std::vector<Release> releases_;  // releases of these keys; reported to Dear ImGui after the next frame
  bool key_repeats_ = false;       // for the key whose typed text comes next
  bool shows_rest_ = false;
  int rest_asked_ = 0;
  int rest_answered_ = 0;
};

}  // namespace mes
