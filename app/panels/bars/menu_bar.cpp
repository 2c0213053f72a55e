// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/menu_bar.h"

#include <fmt/core.h>
#include <array>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>

#include "app/panels/bars/interface_sizes.h"
#include "app/picture/canvas_look.h"
#include "app/ui/theme.h"
#include "app/ui/widgets.h"
#include "core/document/contour_edit.h"
#include "core/edit/arrangement.h"
#include "render/convert.h"

namespace mes {
namespace {

void action_item(const MenuBar& menu, ActionId id, const std::string& label = {}) {
  mes::action_item(menu.gui, menu.actions, id, label);
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
  action_item(menu, ActionId::new_document);
  action_item(menu, ActionId::open);
  recent_files_menu(menu);
  action_item(menu, ActionId::keep_degrees);
  ImGui::Separator();
  action_item(menu, ActionId::save);
  action_item(menu, ActionId::save_as);
  if (menu.actions.is_bound(ActionId::share)) action_item(menu, ActionId::share);
  ImGui::Separator();
  action_item(menu, ActionId::picture_to_samples);
  action_item(menu, ActionId::trace_picture);
  action_item(menu, ActionId::export_figure);
  geometry_menu(menu);
  action_item(menu, ActionId::export_center_lines);
  action_item(menu, ActionId::export_cells);
  for (const ActionId id : {ActionId::snapshot, ActionId::copy_picture, ActionId::record, ActionId::make_video})
    action_item(menu, id);
  ImGui::Separator();
  action_item(menu, ActionId::quit);
}

void arrange_menu(const MenuBar& menu) {
  if (!ImGui::BeginMenu("Arrange")) return;
  for (const ActionId id : {ActionId::mirror_x, ActionId::mirror_y}) action_item(menu, id);
  ImGui::Separator();
  for (std::size_t i = 0; i < kAlignments; ++i) action_item(menu, nth(ActionId::first_alignment, i));
  ImGui::Separator();
  for (const ActionId id : {ActionId::distribute_x, ActionId::distribute_y}) action_item(menu, id);
  ImGui::Separator();
  for (const ActionId id : {ActionId::put_on_line, ActionId::put_on_circle, ActionId::add_circle})
    action_item(menu, id);
  ImGui::EndMenu();
}

void contours_menu(const MenuBar& menu) {
  if (!ImGui::BeginMenu("Contours")) return;
  for (std::size_t i = 0; i < kContourChanges; ++i) action_item(menu, nth(ActionId::first_contour_change, i));
  ImGui::Separator();
  action_item(menu, ActionId::contours_along_crust);
  ImGui::EndMenu();
}

void edit_menu(const MenuBar& menu) {
  const auto with_step = [](const char* verb, const std::string& step) {
    return step.empty() ? std::string(verb) : std::string(verb) + ": " + step;
  };
  action_item(menu, ActionId::undo, with_step("Undo", menu.editor.undo_name()));
  action_item(menu, ActionId::redo, with_step("Redo", menu.editor.redo_name()));
  ImGui::Separator();
  for (const ActionId id :
       {ActionId::copy, ActionId::cut, ActionId::paste, ActionId::duplicate, ActionId::delete_selection})
    action_item(menu, id);
  ImGui::Separator();
  for (const ActionId id :
       {ActionId::select_all, ActionId::invert_selection, ActionId::select_sources, ActionId::deselect})
    action_item(menu, id);
  action_item(menu, ActionId::canvas_menu);
  if (ImGui::BeginMenu("Along the curve")) {
    for (const ActionId id : {ActionId::select_curve, ActionId::grow_selection, ActionId::shrink_selection})
      action_item(menu, id);
    ImGui::Separator();
    for (const ActionId id : {ActionId::repair_sampling, ActionId::decimate_sampling}) action_item(menu, id);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  for (const ActionId id : {ActionId::toggle_selection, ActionId::toggle_curves}) action_item(menu, id);
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
  for (const ActionId id :
       {ActionId::fit, ActionId::fit_selection, ActionId::previous_view, ActionId::zoom_in, ActionId::zoom_out})
    action_item(menu, id);
  ImGui::Separator();
  if (ImGui::BeginMenu("Panels")) {
    for (const ActionId id : {ActionId::toggle_layers, ActionId::toggle_bundles, ActionId::toggle_selection,
                              ActionId::toggle_curves, ActionId::toggle_sampling, ActionId::toggle_branches,
                              ActionId::toggle_persistence, ActionId::toggle_statistics, ActionId::toggle_parameters,
                              ActionId::toggle_experiments, ActionId::toggle_lesson, ActionId::toggle_log})
      action_item(menu, id);
    ImGui::Separator();
    action_item(menu, ActionId::toggle_panels);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Legend and scale")) {
    for (const ActionId id : {ActionId::toggle_legend, ActionId::toggle_key, ActionId::toggle_scale_bar,
                              ActionId::toggle_axes, ActionId::toggle_grid, ActionId::toggle_annotations})
      action_item(menu, id);
    ImGui::Separator();
    action_item(menu, ActionId::put_marks_back);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (ImGui::BeginMenu("Bundles")) {
    for (const ActionId id :
         {ActionId::save_bundle, ActionId::import_bundles, ActionId::export_bundles, ActionId::undo_bundles})
      action_item(menu, id);
    ImGui::Separator();
    for (const ActionId id : {ActionId::balls_inner, ActionId::balls_polar, ActionId::balls_own})
      action_item(menu, id);
    ImGui::Separator();
    for (const ActionId id :
         {ActionId::next_bundle, ActionId::previous_bundle, ActionId::presenter_mode, ActionId::full_screen})
      action_item(menu, id);
    ImGui::EndMenu();
  }
  for (const ActionId id : {ActionId::toggle_theme, ActionId::projector_mode}) action_item(menu, id);
  if (ImGui::BeginMenu("Canvas")) {
    for (const ActionId id :
         {ActionId::add_pane, ActionId::close_panes, ActionId::toggle_free_cameras, ActionId::toggle_differences})
      action_item(menu, id);
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
  for (const ActionId id : {ActionId::evolution_forward, ActionId::evolution_back, ActionId::evolution_play,
                            ActionId::evolution_play_back, ActionId::evolution_stop, ActionId::evolution_first})
    action_item(menu, id);
  ImGui::Separator();
  action_item(menu, ActionId::toggle_evolution);
}

void shapes_menu(const MenuBar& menu) {
  action_item(menu, ActionId::make_shape);
  action_item(menu, ActionId::write_text);
  for (const ActionId id : {ActionId::curves_of_samples, ActionId::mark_corners, ActionId::toggle_curves})
    action_item(menu, id);
  if (!menu.shapes.empty()) ImGui::Separator();
  for (const SampleShape& shape : menu.shapes) {
    if (ImGui::MenuItem(shape.name.c_str())) menu.open_shape(shape);
    tooltip(menu.gui, shape.description);
  }
}

void lessons_menu(const MenuBar& menu) {
  for (const ActionId id :
       {ActionId::present_lesson, ActionId::export_lesson, ActionId::mark_step, ActionId::toggle_lesson})
    action_item(menu, id);
  if (!menu.lessons.empty()) ImGui::Separator();
  for (const ShippedLesson& lesson : menu.lessons) {
    if (ImGui::MenuItem(lesson.title.c_str())) menu.open_lesson(lesson);
    tooltip(menu.gui, "Open this lesson and present it");
  }
}

}  // namespace

float MenuBar::draw() const {
  if (!ImGui::BeginMainMenuBar()) return 0.0F;
  const float height = ImGui::GetWindowHeight();
  if (ImGui::BeginMenu("File")) {
    file_menu(*this);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit")) {
    edit_menu(*this);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    view_menu(*this);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Evolution")) {
    evolution_menu(*this);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Tools")) {
    for (const ActionId id :
         {ActionId::tool_select, ActionId::tool_insert, ActionId::tool_spray, ActionId::tool_ball})
      action_item(*this, id);
    if (ImGui::BeginMenu("Brush")) {
      for (const ActionId id :
           {ActionId::tool_brush, ActionId::brush_erase, ActionId::brush_thin, ActionId::brush_refine})
        action_item(*this, id);
      ImGui::EndMenu();
    }
    for (const ActionId id : {ActionId::tool_measure, ActionId::tool_annotate}) action_item(*this, id);
    ImGui::Separator();
    for (const ActionId id : {ActionId::keep_measurement, ActionId::keep_highlight}) action_item(*this, id);
    ImGui::Separator();
    action_item(*this, ActionId::toggle_snap);
    snap_menu(*this);
    for (const ActionId id : {ActionId::toggle_handles, ActionId::toggle_insertion_preview}) action_item(*this, id);
    ImGui::Separator();
    if (ImGui::BeginMenu("Number type")) {
      for (const ActionId id : {ActionId::precision_naive, ActionId::precision_fast, ActionId::precision_exact,
                                ActionId::precision_exact_roots})
        action_item(*this, id);
      ImGui::EndMenu();
    }
    for (const ActionId id : {ActionId::toggle_union_shortcut, ActionId::toggle_pole_propagation})
      action_item(*this, id);
    ImGui::Separator();
    for (const ActionId id : {ActionId::hold_update, ActionId::cancel_computation, ActionId::resume_computation})
      action_item(*this, id);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Shapes")) {
    shapes_menu(*this);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Help")) {
    action_item(*this, ActionId::command_palette);
    action_item(*this, ActionId::help);
    action_item(*this, ActionId::manual);
    if (ImGui::BeginMenu("Lessons")) {
      lessons_menu(*this);
      ImGui::EndMenu();
    }
    action_item(*this, ActionId::demo);
    ImGui::Separator();
    for (const ActionId id : {ActionId::classic_keys, ActionId::write_keys}) action_item(*this, id);
    ImGui::Separator();
    ImGui::MenuItem("Mesecina " MESECINA_VERSION, nullptr, false, false);
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace mes
