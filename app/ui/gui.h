// SPDX-License-Identifier: GPL-3.0-or-later
// Dear ImGui in our window: context, fonts, theme, scale, and who gets an event.
#pragma once

#include <filesystem>

#include "app/ui/glfw_window.h"
#include "app/ui/theme.h"
#include "imgui.h"

namespace mes {

/// What it guarantees: text is drawn at the framebuffer's own resolution at every content scale; fonts are made again
/// only when the scale changes. Lengths given to Dear ImGui are screen coordinates; `unit()` of them is one logical
/// pixel. Threads: the window's. One at a time.
class Gui {
 public:
  Gui(GlfwWindow& window, std::filesystem::path assets);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Theme, contrast and size are those of the settings.
  void begin_frame(const Settings& settings);
  void end_frame();

  float unit() const { return unit_; }
  /// Framebuffer pixels per logical pixel of the drawing: the size of the panels is no matter of the drawing, but for
  /// a projector both are larger.
  double drawing_scale() const;
  const ThemeColors& colors() const { return colors_; }
  ImFont* bold() const { return bold_; }
  ImFont* small() const { return small_; }

  /// A panel, popup or menu lies at this framebuffer position, or has hold of the pointer.
  bool wants_pointer(Vec2 px) const;
  /// The pointer has lain on something long enough that it may be explained.
  bool is_resting() const;
  /// It lies on something, but not yet so long: the next frame must come by itself.
  bool is_about_to_rest() const;
  /// The darkening behind a dialog comes or goes: the next frame must come by itself.
  bool is_fading() const;
  /// Text is being typed.
  bool wants_text() const;
  /// A popup, menu or dialog is open.
  bool has_popup() const;
  /// Closes the topmost popup or menu; false when there was none.
  bool close_popup();
  /// For dialogs that are shown while a flag of ours is set: opens the popup with the flag, closes it without. True:
  /// fill it, then ImGui::EndPopup().
  static bool begin_dialog(const char* id, bool open, ImGuiWindowFlags flags);

 private:
  void load_fonts(double scale);

  GlfwWindow& window_;
  std::filesystem::path assets_;
  double font_scale_ = 0.0;
  Theme theme_ = Theme::light;
  bool for_projector_ = false;
  ThemeColors colors_;
  float unit_ = 1.0F;
  ImFont* bold_ = nullptr;
  ImFont* small_ = nullptr;
};

}  // namespace mes
