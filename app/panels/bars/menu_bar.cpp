// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/menu_bar.h"

#include <fmt/core.h>
#include <array>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>
#include <span>

#include "app/actions/menus.h"
#include "app/panels/bars/interface_sizes.h"
#include "app/picture/paper/canvas_look.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/widgets.h"
#include "imgui_internal.h"
#include "render/device/convert.h"

namespace mes {
namespace {

void action_item(const MenuBar& menu, ActionId id, const std::string& label = {}) {
  mes::action_item(menu.gui, menu.actions, id, label);
}

// A window that cannot do something lacks its row.
void action_items(const MenuBar& menu, std::string_view path, std::size_t part = 0) {
  for (const ActionId id : actions_in_menu(path, part))
    if (menu.actions.is_bound(id)) action_item(menu, id);
}

void recent_files_menu(const MenuBar& menu) {
  const auto recent = menu.settings.recent_files;  // a copy, because opening a file changes the list
  if (!ImGui::BeginMenu("Recent files", !recent.empty())) return;
  for (const std::string& file : recent) {
    const std::filesystem::path path(file);
    ImGui::PushID(file.c_str());
    if (ImGui::MenuItem(path.filename().c_str())) menu.open_file(file);
    tooltip(menu.gui, file);
    ImGui::PopID();
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Clear this list")) menu.settings.recent_files.clear();
  ImGui::EndMenu();
}

// Exports all visible layers in one file.
void geometry_menu(const MenuBar& menu) {
  if (!ImGui::BeginMenu("Export geometry")) return;
  for (const LayerTextFormat& format : layer_text_formats()) {
    if (!format.is_of_many) continue;
    if (ImGui::MenuItem(std::string(format.title).c_str())) menu.export_geometry(format);
    tooltip(menu.gui, "All visible layers: " + std::string(format.help));
  }
  ImGui::EndMenu();
}

void file_menu(const MenuBar& menu) {
  action_items(menu, "File", 0);
  recent_files_menu(menu);
  action_items(menu, "File", 1);
  ImGui::Separator();
  action_items(menu, "File", 2);
  ImGui::Separator();
  action_items(menu, "File", 3);
  geometry_menu(menu);
  action_items(menu, "File", 4);
  ImGui::Separator();
  action_items(menu, "File", 5);
}

void arrange_menu(const MenuBar& menu) {
  if (!ImGui::BeginMenu("Arrange")) return;
  for (std::size_t part = 0; part < 4; ++part) {
    if (part != 0) ImGui::Separator();
    action_items(menu, "Edit > Arrange", part);
  }
  ImGui::EndMenu();
}

void contours_menu(const MenuBar& menu) {
  if (!ImGui::BeginMenu("Contours")) return;
  action_items(menu, "Edit > Contours", 0);
  ImGui::Separator();
  action_items(menu, "Edit > Contours", 1);
  ImGui::EndMenu();
}

void edit_menu(const MenuBar& menu) {
  const auto with_step = [](const char* verb, const std::string& step) {
    return step.empty() ? std::string(verb) : std::string(verb) + ": " + step;
  };
  action_item(menu, ActionId::undo, with_step("Undo", menu.editor.undo_name()));
  action_item(menu, ActionId::redo, with_step("Redo", menu.editor.redo_name()));
  ImGui::Separator();
  action_items(menu, "Edit", 1);
  ImGui::Separator();
  action_items(menu, "Edit", 2);
  if (ImGui::BeginMenu("Along the curve")) {
    action_items(menu, "Edit > Along the curve", 0);
    ImGui::Separator();
    action_items(menu, "Edit > Along the curve", 1);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  action_items(menu, "Edit", 3);
  arrange_menu(menu);
  contours_menu(menu);
}

void snap_menu(const MenuBar& menu) {
  if (!ImGui::BeginMenu("Snap to")) return;
  SnapSettings& snap = menu.settings.snap;
  ImGui::MenuItem("Samples", nullptr, &snap.samples);
  ImGui::MenuItem("Centres of balls", nullptr, &snap.centers);
  ImGui::MenuItem("Voronoi vertices", nullptr, &snap.vertices);
  tooltip(menu.gui, "Centres of circles through three samples, in documents of at most 20,000");
  ImGui::MenuItem("Circles of balls", nullptr, &snap.circles);
  ImGui::MenuItem("Curves", nullptr, &snap.curves);
  tooltip(menu.gui, "The curves of a drawing, map, picture or shape, from which samples were taken");
  ImGui::MenuItem("Grid", nullptr, &snap.grid);
  tooltip(menu.gui, "Lines at round numbers, even when they are hidden");
  ImGui::MenuItem("Pixels", nullptr, &snap.pixels);
  tooltip(menu.gui, "If nothing else is near: coordinates with as few digits as distinguish pixels of the screen");
  ImGui::EndMenu();
}

void canvas_menu(const MenuBar& menu) {
  struct Choice {
    const char* name;
    std::optional<Rgb> color;
  };
  static constexpr std::array<Choice, 5> kChoices{{{"Like the theme", {}},
                                                   {"White", kWhiteCanvas},
                                                   {"Light grey", kLightGreyCanvas},
                                                   {"Dark", kDarkCanvas},
                                                   {"Black", kBlackCanvas}}};
  std::optional<Rgb>& background = menu.settings.canvas_background;
  for (const Choice& choice : kChoices)
    if (ImGui::MenuItem(choice.name, nullptr, background == choice.color)) background = choice.color;
  ImGui::Separator();
  glm::vec3 color = render::to_vec3(canvas_background(menu.settings));
  ImGui::SetNextItemWidth(180 * menu.gui.unit());
  if (ImGui::ColorPicker3(
          "##color", glm::value_ptr(color),
          ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_DisplayHex))
    background = render::to_rgb(color);
}

void view_menu(const MenuBar& menu) {
  action_items(menu, "View", 0);
  ImGui::Separator();
  if (ImGui::BeginMenu("Panels")) {
    action_items(menu, "View > Panels", 0);
    ImGui::Separator();
    action_items(menu, "View > Panels", 1);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Legend and scale")) {
    action_items(menu, "View > Legend and scale", 0);
    ImGui::Separator();
    action_items(menu, "View > Legend and scale", 1);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (ImGui::BeginMenu("Bundles")) {
    action_items(menu, "View > Bundles", 0);
    ImGui::Separator();
    action_items(menu, "View > Bundles", 1);
    ImGui::Separator();
    action_items(menu, "View > Bundles", 2);
    ImGui::EndMenu();
  }
  action_items(menu, "View", 1);
  if (ImGui::BeginMenu("Canvas")) {
    action_items(menu, "View > Canvas");
    ImGui::Separator();
    canvas_menu(menu);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Interface size")) {
    for (const int percent : kInterfacePercents)
      if (ImGui::MenuItem(fmt::format("{} %", percent).c_str(), nullptr, has_interface_size(menu.settings, percent)))
        menu.settings.interface_scale = percent / 100.0;
    ImGui::EndMenu();
  }
  if (ImGui::MenuItem("Reset layers")) menu.editor.change_layers("Reset layers", [&] { menu.layers.reset(); });
  tooltip(menu.gui, "Reset the order, visibility and style of every layer");
}

void evolution_menu(const MenuBar& menu) {
  for (const auto& evolution : menu.evolution.evolutions()) {
    if (ImGui::MenuItem(evolution->descriptor.name.c_str(), nullptr,
                        menu.evolution.choice().evolution == evolution)) {
      menu.settings.show_evolution = true;
      menu.evolution.choose(evolution);
    }
    tooltip(menu.gui, evolution->descriptor.tooltip);
  }
  ImGui::Separator();
  action_items(menu, "Evolution", 0);
  ImGui::Separator();
  action_items(menu, "Evolution", 1);
}

void shapes_menu(const MenuBar& menu) {
  action_items(menu, "Shapes");
  if (!menu.shapes.empty()) ImGui::Separator();
  for (const SampleShape& shape : menu.shapes) {
    if (ImGui::MenuItem(shape.name.c_str())) menu.open_shape(shape);
    tooltip(menu.gui, shape.description);
  }
}

void lessons_menu(const MenuBar& menu) {
  action_items(menu, "Help > Lessons");
  if (!menu.lessons.empty()) ImGui::Separator();
  for (const ShippedLesson& lesson : menu.lessons) {
    if (ImGui::MenuItem(lesson.title.c_str())) menu.open_lesson(lesson);
    tooltip(menu.gui, "Open this lesson and present it");
  }
}

void tools_menu(const MenuBar& menu) {
  action_items(menu, "Tools", 0);
  if (ImGui::BeginMenu("Brush")) {
    action_items(menu, "Tools > Brush");
    ImGui::EndMenu();
  }
  action_items(menu, "Tools", 1);
  ImGui::Separator();
  action_items(menu, "Tools", 2);
  ImGui::Separator();
  action_items(menu, "Tools", 3);
  snap_menu(menu);
  action_items(menu, "Tools", 4);
  ImGui::Separator();
  if (ImGui::BeginMenu("Number type")) {
    action_items(menu, "Tools > Number type");
    ImGui::EndMenu();
  }
  action_items(menu, "Tools", 5);
  ImGui::Separator();
  action_items(menu, "Tools", 6);
}

void help_menu(const MenuBar& menu) {
  action_items(menu, "Help", 0);
  if (ImGui::BeginMenu("Lessons")) {
    lessons_menu(menu);
    ImGui::EndMenu();
  }
  action_items(menu, "Help", 1);
  ImGui::Separator();
  action_items(menu, "Help", 2);
  ImGui::Separator();
  ImGui::MenuItem("Mesecina " MESECINA_VERSION, nullptr, false, false);
}

struct MenuTitle {
  const char* text;
  void (*draw)(const MenuBar&);
};
constexpr std::array<MenuTitle, 7> kMenus{{{"File", file_menu},
                                           {"Edit", edit_menu},
                                           {"View", view_menu},
                                           {"Evolution", evolution_menu},
                                           {"Tools", tools_menu},
                                           {"Shapes", shapes_menu},
                                           {"Help", help_menu}}};
constexpr const char* kOtherMenus = "More";

// The number of titles from the first on for which the bar has room; the others are in a last menu.
std::size_t shown_menus(float room) {
  const auto width = [](const char* title) {
    return ImGui::CalcTextSize(title).x + 2 * ImGui::GetStyle().ItemSpacing.x;
  };
  float all = 0.0F;
  for (const MenuTitle& title : kMenus) all += width(title.text);
  if (all <= room) return kMenus.size();
  std::size_t out = 0;
  float used = width(kOtherMenus) + width(kMenus[0].text);
  while (used <= room) used += width(kMenus[++out].text);
  return out;
}

}  // namespace

float MenuBar::draw(bool opens) const {
  if (!ImGui::BeginMainMenuBar()) return 0.0F;
  const float height = ImGui::GetWindowHeight();
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGuiWindow& bar = *context.CurrentWindow;
  if (opens) {
    ImGui::OpenPopup(kMenus[0].text);
    bar.NavLastIds[ImGuiNavLayer_Menu] = bar.GetID(kMenus[0].text);  // from there arrow keys go on
  }
  const auto draw_menu = [&](const MenuTitle& menu) {
    // Dear ImGui closes the menu that an arrow key leaves, and only marks the next title.
    if (context.NavJustMovedToId == ImGui::GetID(menu.text)) ImGui::OpenPopup(menu.text);
    if (!ImGui::BeginMenu(menu.text)) return;
    menu.draw(*this);
    ImGui::EndMenu();
  };
  const std::span<const MenuTitle> menus(kMenus);
  const std::size_t shown = shown_menus(ImGui::GetContentRegionAvail().x);
  for (const MenuTitle& menu : menus.first(shown)) draw_menu(menu);
  if (shown < menus.size() && ImGui::BeginMenu(kOtherMenus)) {
    for (const MenuTitle& menu : menus.subspan(shown)) draw_menu(menu);
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
  // In a menu without a marked row an arrow key also asks for the first row, which is not one of the bar.
  if (context.NavMoveForwardToNextFrame) {
    context.NavInitRequest = false;
    context.NavInitResultId = 0;
  }
  return height;
}

}  // namespace mes
