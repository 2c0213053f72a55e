// SPDX-License-Identifier: GPL-3.0-or-later
// Dear ImGui in the program's window: context, fonts, theme, scale, and the decision which of the two gets an event.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/ui/screen/glfw_window.h"
#include "app/ui/screen/theme.h"
#include "imgui.h"

namespace mes {

/// Guarantees: text has the resolution of the framebuffer at every content scale; fonts are rasterised again only
/// when the scale changes, or letters of another size are requested. Dear ImGui measures lengths in screen
/// coordinates; `unit()` of them are one logical pixel. Threads: the window's. One at a time.
/// The meaning of arrow keys and the space bar in a dialog.
enum class DialogKeys : std::uint8_t {
  own,       ///< the dialog handles them itself
  controls,  ///< arrows go from control to control, and the space bar presses the marked one
};

class Gui {
 public:
  Gui(GlfwWindow& window, std::filesystem::path assets);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Uses the theme, contrast and size of the settings.
  void begin_frame(const Settings& settings);
  void end_frame();

  float unit() const { return unit_; }
  /// Framebuffer pixels per logical pixel of the drawing. It does not depend on the size of the panels, except that a
  /// projector enlarges both.
  double drawing_scale() const;
  const ThemeColors& colors() const { return colors_; }
  ImFont* bold() const { return bold_; }
  enum class Look : std::uint8_t { plain, bold, italic };
  /// The font for letters of `size` logical pixels, sharp even if they are large. A size that was not requested
  /// before is loaded with the next frame (`lacks_letters`), and letters of another size replace it until then.
  ImFont* letters(Look look, double size) const;
  bool lacks_letters() const { return wanted_sizes_ != loaded_sizes_; }
  ImFont* small() const { return small_; }

  /// True if a panel, popup or menu is at this framebuffer position, or has captured the pointer.
  bool wants_pointer(Vec2 px) const;
  /// True if the pointer has rested on an item long enough for a tooltip.
  bool is_resting() const;
  /// True if the pointer is on an item, but not yet long enough: another frame is needed without an event.
  bool is_about_to_rest() const;
  /// True while the dimming behind a dialog appears or disappears: another frame is needed without an event.
  bool is_fading() const;
  /// True while an arrow key goes from one menu to the next: another frame is needed without an event.
  bool is_changing_menus() const;
  /// True while a field takes typed text.
  bool wants_text() const;
  /// True if this frame has shown the last move of a drag: the next frame must end it before any other event is read.
  bool holds_release() const { return held_release_.has_value(); }
  /// True while a button of the mouse holds a control of a panel, such as a slider.
  bool holds_control() const;
  /// True while a popup, menu or dialog is open.
  bool has_popup() const;
  /// Closes the topmost popup or menu; returns false if there was none.
  bool close_popup();
  /// Closes all popups and menus, and takes the keyboard from a field, which keeps its text.
  void leave_panels();
  /// For dialogs shown while a flag is set: opens the popup if `open`, and closes it if not. Returns true if the
  /// caller must fill it and then call ImGui::EndPopup().
  static bool begin_dialog(const char* id, bool open, ImGuiWindowFlags flags, DialogKeys keys = DialogKeys::own);

 private:
  void load_fonts(double scale);
  void follow_mouse();
  static void let_keys_choose_rows();

  GlfwWindow& window_;
  std::filesystem::path assets_;
  std::optional<Vec2> held_release_;  // where the button that ended a drag was released
  double font_scale_ = 0.0;
  Theme theme_ = Theme::light;
  bool for_projector_ = false;
  ThemeColors colors_;
  float unit_ = 1.0F;
  ImFont* bold_ = nullptr;
  static constexpr std::size_t kLetterSizes = 4;
  static constexpr std::size_t kLooks = 3;
  using Letters = std::array<ImFont*, kLooks>;
  Letters usual_letters_{};
  std::array<Letters, kLetterSizes> large_letters_{};
  mutable unsigned wanted_sizes_ = 0;  // one bit per size; set when a size is requested
  unsigned loaded_sizes_ = 0;
  ImFont* small_ = nullptr;
};

}  // namespace mes
