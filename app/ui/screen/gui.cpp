// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/screen/gui.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "imgui_impl_glfw.h"
#include "imgui_impl_opengl3.h"
#include "imgui_internal.h"
#include "render/device/gl_dialect.h"
#include "render/image/text.h"

namespace mes {
namespace {

constexpr float kTextPx = 15.0F;
constexpr float kSmallTextPx = 12.5F;
constexpr double kProjectorScale = 1.35;
constexpr float kRestSeconds = 0.4F;  // before a tooltip; a shorter time shows tooltips of items on the way

// Latin, Greek, and the few symbols that messages and panels use.
constexpr std::array<ImWchar, 15> kGlyphs{0x0020, 0x017F, 0x0391, 0x03F5, 0x2010, 0x2032, 0x2113, 0x2113,
                                          0x2190, 0x2194, 0x2202, 0x2265, 0x25CF, 0x25CF, 0};

// Sizes beyond the usual one, in logical pixels; each is also scaled down for sizes above the previous one.
constexpr std::array<double, 4> kLargeLetters{24.0, 40.0, 64.0, 120.0};

ImFont* add_font(ImFontAtlas& atlas, const std::filesystem::path& file, float size) {
  std::error_code error;
  // Dear ImGui ends the program if a font file is broken.
  if (!std::filesystem::is_regular_file(file, error) || !render::Font::read(file)) return nullptr;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  return atlas.AddFontFromFileTTF(file.c_str(), size, &config, kGlyphs.data());
}

/// The scale at which panels, dialogs and the drawing have room beside each other. In steps, since each new scale loads
/// the fonts.
double largest_scale(GlfwWindow::Size size) {
  constexpr double kLeastWidth = 512.0;
  constexpr double kLeastHeight = 384.0;
  constexpr double kSteps = 8.0;
  const double room = std::min(size.width / kLeastWidth, size.height / kLeastHeight);
  return std::max(1.0, std::floor(kSteps * room) / kSteps);
}

}  // namespace

Gui::Gui(GlfwWindow& window, std::filesystem::path assets) : window_(window), assets_(std::move(assets)) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the program keeps the layout, not Dear ImGui
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would keep an idle window awake
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  // Callbacks are forwarded by GlfwWindow.
  ImGui_ImplGlfw_InitForOpenGL(window_.handle(), false);
  ImGui_ImplOpenGL3_Init(render::shader_version());
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Gui::load_fonts(double scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  const auto fonts = assets_ / "fonts";
  const auto size = [scale](float px) { return std::round(px * static_cast<float>(scale)); };
  ImFont* regular = add_font(atlas, fonts / "Inter-Regular.otf", size(kTextPx));
  if (regular == nullptr) {
    // The built-in font is a bitmap of 13 pixels: whole multiples keep it sharp.
    ImFontConfig config;
    config.SizePixels = 13.0F * static_cast<float>(std::max(1.0, std::round(scale)));
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    regular = atlas.AddFontDefault(&config);
  }
  bold_ = add_font(atlas, fonts / "Inter-SemiBold.otf", size(kTextPx));
  if (bold_ == nullptr) bold_ = regular;
  ImFont* italic = add_font(atlas, fonts / "Inter-Italic.otf", size(kTextPx));
  if (italic == nullptr) italic = regular;
  usual_letters_ = {regular, bold_, italic};
  for (std::size_t i = 0; i < kLetterSizes; ++i) {
    if ((wanted_sizes_ >> i & 1U) == 0) continue;
    const char* const files[kLooks] = {"Inter-Regular.otf", "Inter-SemiBold.otf", "Inter-Italic.otf"};
    for (std::size_t look = 0; look < kLooks; ++look) {
      large_letters_[i][look] = add_font(atlas, fonts / files[look], size(static_cast<float>(kLargeLetters[i])));
      if (large_letters_[i][look] == nullptr) large_letters_[i][look] = usual_letters_[look];
    }
  }
  loaded_sizes_ = wanted_sizes_;
  small_ = add_font(atlas, fonts / "Inter-Regular.otf", size(kSmallTextPx));
  if (small_ == nullptr) small_ = regular;
  atlas.Build();
}

ImFont* Gui::letters(Look look, double size) const {
  const auto of = static_cast<std::size_t>(look);
  constexpr double kStillSharp = 1.2;
  if (size <= kStillSharp * static_cast<double>(kTextPx)) return usual_letters_[of];
  const auto larger = std::ranges::find_if(kLargeLetters, [size](double letters) { return size <= letters; });
  const auto i = static_cast<std::size_t>(std::min(larger, kLargeLetters.end() - 1) - kLargeLetters.begin());
  wanted_sizes_ |= 1U << i;
  return (loaded_sizes_ >> i & 1U) != 0 ? large_letters_[i][of] : usual_letters_[of];
}

void Gui::begin_frame(const Settings& settings) {
  const double ratio = window_.pixel_ratio();
  const double enlarged = settings.interface_scale * (settings.for_projector ? kProjectorScale : 1.0);
  const double wanted = std::clamp(window_.content_scale() * enlarged, 0.5, 8.0);
  const double scale = std::min(wanted, largest_scale(window_.framebuffer_size()));
  const bool is_new_scale = scale != font_scale_;
  if (is_new_scale || lacks_letters()) {
    const bool is_first = font_scale_ == 0.0;
    font_scale_ = scale;
    unit_ = static_cast<float>(scale / ratio);
    load_fonts(scale);
    // Do not destroy all device objects: Dear ImGui keeps the sizes of its old buffers, so it would write beyond the
    // new, empty ones and draw nothing from then on. The first texture is created with those objects.
    if (!is_first) {
      ImGui_ImplOpenGL3_DestroyFontsTexture();
      ImGui_ImplOpenGL3_CreateFontsTexture();
    }
  }
  if (is_new_scale || settings.theme != theme_ || settings.for_projector != for_projector_) {
    theme_ = settings.theme;
    for_projector_ = settings.for_projector;
    colors_ = theme_colors(theme_, for_projector_);
    apply_theme(ImGui::GetStyle(), colors_, unit_);
  }
  ImGui::GetIO().FontGlobalScale = static_cast<float>(1.0 / ratio);
  ImGui_ImplOpenGL3_NewFrame();
  follow_mouse();
  let_keys_choose_rows();
  ImGui::NewFrame();
}

// Dear ImGui does not apply the last move of a drag if the button is up in the same frame.
void Gui::follow_mouse() {
  ImGuiIO& io = ImGui::GetIO();
  const Vec2 last{io.MousePos.x, io.MousePos.y};
  const bool was_down = io.MouseDown[0];
  ImGui_ImplGlfw_NewFrame();
  std::optional<Vec2> at = std::exchange(held_release_, std::nullopt);
  if (!at) {
    at = window_.take_click();
    if (at && *at != last && was_down && !io.MouseDown[0] && ImGui::GetCurrentContext()->ActiveId != 0) {
      held_release_ = at;
      io.MouseDown[0] = true;
    }
  }
  if (at) io.MousePos = {static_cast<float>(at->x), static_cast<float>(at->y)};
}

// Arrow keys and Enter choose rows of menus and lists, and arrow keys go through the controls of some dialogs, where Enter
// presses the default button. Elsewhere they belong to the table of actions.
void Gui::let_keys_choose_rows() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiWindow* const top = context.OpenPopupStack.empty() ? nullptr : context.OpenPopupStack.back().Window;
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  if (top == nullptr || (top->Flags & ImGuiWindowFlags_NoNavInputs) != 0) return;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  if ((top->Flags & ImGuiWindowFlags_Modal) != 0) return;
  // Dear ImGui marks the first row unseen when a menu opens; then the first key would mark the second. A field that is
  // being edited is marked unseen too, and Tab goes on from it.
  if (context.NavDisableHighlight && context.ActiveId == 0) {
    context.NavInitRequest = false;
    context.NavInitResultId = 0;
    context.NavId = 0;
  }
  // Dear ImGui knows only the space bar for this.
  const auto is_down = [](ImGuiKey key) { return ImGui::IsKeyDown(ImGui::GetKeyIndex(key)); };
  if (is_down(ImGuiKey_Enter) || is_down(ImGuiKey_KeyPadEnter)) io.NavInputs[ImGuiNavInput_Activate] = 1.0F;
}

double Gui::drawing_scale() const {
  return std::clamp(window_.content_scale() * (for_projector_ ? kProjectorScale : 1.0), 0.5, 8.0);
}

void Gui::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Gui::wants_pointer(Vec2 px) const {
  // Dear ImGui's own answer is that of its last frame; the pointer may have moved onto a panel since.
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.ActiveId != 0 || has_popup()) return true;
  const double ratio = window_.pixel_ratio();
  const ImVec2 at(static_cast<float>(px.x / ratio), static_cast<float>(px.y / ratio));
  // Uses the stack of open popups, because their windows exist for a frame longer.
  constexpr int kNotPanels = ImGuiWindowFlags_NoMouseInputs | ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip;
  for (const ImGuiWindow* window : context.Windows) {
    // Dear ImGui's fallback window, for items outside all windows, is active from the beginning of each frame to its
    // end.
    if (!window->Active || window->Hidden || window->IsFallbackWindow || (window->Flags & kNotPanels) != 0) continue;
    if (window->OuterRectClipped.Contains(at)) return true;
  }
  return false;
}

bool Gui::is_resting() const {
  return ImGui::GetCurrentContext()->HoveredIdTimer > kRestSeconds;
}

bool Gui::is_about_to_rest() const {
  return ImGui::GetCurrentContext()->HoveredIdPreviousFrame != 0 && !is_resting();
}

bool Gui::is_fading() const {
  const float dim = ImGui::GetCurrentContext()->DimBgRatio;
  return dim > 0.0F && dim < 1.0F;
}

bool Gui::wants_text() const {
  // Dear ImGui's own answer is a frame late when a field takes or loses the keyboard; a key in between would be lost.
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.ActiveId != 0 && context.ActiveId == context.InputTextState.ID;
}

bool Gui::holds_control() const {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.ActiveId != 0 && context.ActiveIdSource == ImGuiInputSource_Mouse && !wants_text();
}

bool Gui::begin_dialog(const char* id, bool open, ImGuiWindowFlags flags, DialogKeys keys) {
  const bool was_open = ImGui::IsPopupOpen(id);
  if (!open && !was_open) return false;
  if (!was_open) ImGui::OpenPopup(id);
  flags |= ImGuiWindowFlags_NoSavedSettings;
  if (keys == DialogKeys::own) flags |= ImGuiWindowFlags_NoNavInputs;
  if (!ImGui::BeginPopupModal(id, nullptr, flags)) return false;
  if (open) return true;
  ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return false;
}

bool Gui::close_popup() {
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size == 0) return false;
  ImGui::ClosePopupToLevel(ImGui::GetCurrentContext()->OpenPopupStack.Size - 1, true);
  return true;
}

void Gui::leave_panels() {
  if (wants_text()) ImGui::ClearActiveID();
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) ImGui::ClosePopupToLevel(0, true);
}

bool Gui::is_changing_menus() const {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavMoveForwardToNextFrame || context.NavMoveSubmitted || context.NavJustMovedToId != 0;
}

bool Gui::has_popup() const {
  return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0 || is_changing_menus();
}

}  // namespace mes
