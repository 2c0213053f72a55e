// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/menus.h"

#include <algorithm>

#include "core/base/assert.h"

namespace mes {
namespace {

std::vector<ActionId> series(ActionId first, ActionId last) {
  std::vector<ActionId> out;
  for (std::size_t i = 0; i < length_of_series(first, last); ++i) out.push_back(nth(first, i));
  return out;
}

std::vector<MenuPart> made_parts() {
  return {
      {"File", {ActionId::new_document, ActionId::open}},
      {"File", {ActionId::keep_degrees, ActionId::map_system}},
      {"File", {ActionId::save, ActionId::save_as, ActionId::share}},
      {"File", {ActionId::picture_to_samples, ActionId::trace_picture, ActionId::export_figure}},
      {"File",
       {ActionId::export_center_lines, ActionId::export_cells, ActionId::snapshot, ActionId::copy_picture,
        ActionId::record, ActionId::make_video}},
      {"File", {ActionId::quit}},
      {"Edit", {ActionId::undo, ActionId::redo}},
      {"Edit", {ActionId::copy, ActionId::cut, ActionId::paste, ActionId::duplicate, ActionId::delete_selection}},
      {"Edit",
       {ActionId::select_all, ActionId::invert_selection, ActionId::select_sources, ActionId::deselect,
        ActionId::canvas_menu}},
      {"Edit > Along the curve", {ActionId::select_curve, ActionId::grow_selection, ActionId::shrink_selection}},
      {"Edit > Along the curve", {ActionId::repair_sampling, ActionId::decimate_sampling}},
      {"Edit", {ActionId::toggle_selection, ActionId::toggle_curves}},
      {"Edit > Arrange", {ActionId::mirror_x, ActionId::mirror_y}},
      {"Edit > Arrange", series(ActionId::first_alignment, ActionId::last_alignment)},
      {"Edit > Arrange", {ActionId::distribute_x, ActionId::distribute_y}},
      {"Edit > Arrange", {ActionId::put_on_line, ActionId::put_on_circle, ActionId::add_circle}},
      {"Edit > Contours", series(ActionId::first_contour_change, ActionId::last_contour_change)},
      {"Edit > Contours", {ActionId::contours_along_crust}},
      {"View",
       {ActionId::fit, ActionId::fit_selection, ActionId::previous_view, ActionId::zoom_in, ActionId::zoom_out}},
      {"View > Panels",
       {ActionId::toggle_layers, ActionId::toggle_bundles, ActionId::toggle_selection, ActionId::toggle_curves,
        ActionId::toggle_sampling, ActionId::toggle_branches, ActionId::toggle_persistence,
        ActionId::toggle_statistics, ActionId::toggle_parameters, ActionId::toggle_experiments,
        ActionId::toggle_lesson, ActionId::toggle_log}},
      {"View > Panels", {ActionId::toggle_panels}},
      {"View > Legend and scale",
       {ActionId::toggle_legend, ActionId::toggle_key, ActionId::toggle_scale_bar, ActionId::toggle_axes,
        ActionId::toggle_grid, ActionId::toggle_annotations}},
      {"View > Legend and scale", {ActionId::put_marks_back}},
      {"View > Bundles",
       {ActionId::save_bundle, ActionId::import_bundles, ActionId::export_bundles, ActionId::undo_bundles}},
      {"View > Bundles", {ActionId::balls_inner, ActionId::balls_polar, ActionId::balls_own}},
      {"View > Bundles", {ActionId::next_bundle, ActionId::previous_bundle}},
      {"View", {ActionId::presenter_mode, ActionId::full_screen, ActionId::projector_mode, ActionId::toggle_theme}},
      {"View > Canvas",
       {ActionId::add_pane, ActionId::close_panes, ActionId::toggle_free_cameras, ActionId::toggle_differences}},
      {"Evolution",
       {ActionId::evolution_forward, ActionId::evolution_back, ActionId::evolution_play,
        ActionId::evolution_play_back, ActionId::evolution_stop, ActionId::evolution_first}},
      {"Evolution", {ActionId::toggle_evolution}},
      {"Tools", {ActionId::tool_select, ActionId::tool_insert, ActionId::tool_spray, ActionId::tool_ball}},
      {"Tools > Brush", {ActionId::tool_brush, ActionId::brush_erase, ActionId::brush_thin, ActionId::brush_refine}},
      {"Tools", {ActionId::tool_measure, ActionId::tool_annotate}},
      {"Tools", {ActionId::keep_measurement, ActionId::keep_highlight, ActionId::center_line_between}},
      {"Tools", {ActionId::toggle_snap}},
      {"Tools", {ActionId::toggle_handles, ActionId::toggle_insertion_preview}},
      {"Tools > Number type",
       {ActionId::precision_naive, ActionId::precision_fast, ActionId::precision_exact,
        ActionId::precision_exact_roots}},
      {"Tools", {ActionId::toggle_union_shortcut, ActionId::toggle_pole_propagation}},
      {"Tools", {ActionId::hold_update, ActionId::cancel_computation, ActionId::resume_computation}},
      {"Shapes",
       {ActionId::make_shape, ActionId::write_text, ActionId::curves_of_samples, ActionId::mark_corners,
        ActionId::toggle_curves}},
      {"Help", {ActionId::command_palette, ActionId::open_menus, ActionId::help, ActionId::manual}},
      {"Help > Lessons",
       {ActionId::present_lesson, ActionId::export_lesson, ActionId::mark_step, ActionId::toggle_lesson}},
      {"Help", {ActionId::demo}},
      {"Help", {ActionId::classic_keys, ActionId::write_keys}},
  };
}

}  // namespace

std::span<const MenuPart> menu_parts() {
  static const std::vector<MenuPart> parts = made_parts();
  return parts;
}

std::span<const ActionId> actions_in_menu(std::string_view path, std::size_t part) {
  for (const MenuPart& one : menu_parts())
    if (one.path == path && part-- == 0) return one.actions;
  MES_ASSERT(false);
  return {};
}

std::string_view menu_of(ActionId id) {
  const auto found = std::ranges::find_if(
      menu_parts(), [id](const MenuPart& part) { return std::ranges::count(part.actions, id) != 0; });
  return found == menu_parts().end() ? std::string_view() : found->path;
}

}  // namespace mes
