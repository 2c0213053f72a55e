// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/menus.h"

#include <algorithm>

#include "core/base/assert.h"

namespace mes {
namespace {

using Id = ActionId;

std::vector<ActionId> series(ActionId first, ActionId last) {
  std::vector<ActionId> out;
  for (std::size_t i = 0; i < length_of_series(first, last); ++i) out.push_back(nth(first, i));
  return out;
}

std::vector<MenuPart> made_parts() {
  return {
      {"File", {Id::new_document, Id::open}},
      {"File", {Id::keep_degrees}},
      {"File", {Id::save, Id::save_as, Id::share}},
      {"File", {Id::picture_to_samples, Id::trace_picture, Id::export_figure}},
      {"File",
       {Id::export_center_lines, Id::export_cells, Id::snapshot, Id::copy_picture, Id::record, Id::make_video}},
      {"File", {Id::quit}},
      {"Edit", {Id::undo, Id::redo}},
      {"Edit", {Id::copy, Id::cut, Id::paste, Id::duplicate, Id::delete_selection}},
      {"Edit", {Id::select_all, Id::invert_selection, Id::select_sources, Id::deselect, Id::canvas_menu}},
      {"Edit > Along the curve", {Id::select_curve, Id::grow_selection, Id::shrink_selection}},
      {"Edit > Along the curve", {Id::repair_sampling, Id::decimate_sampling}},
      {"Edit", {Id::toggle_selection, Id::toggle_curves}},
      {"Edit > Arrange", {Id::mirror_x, Id::mirror_y}},
      {"Edit > Arrange", series(Id::first_alignment, Id::last_alignment)},
      {"Edit > Arrange", {Id::distribute_x, Id::distribute_y}},
      {"Edit > Arrange", {Id::put_on_line, Id::put_on_circle, Id::add_circle}},
      {"Edit > Contours", series(Id::first_contour_change, Id::last_contour_change)},
      {"Edit > Contours", {Id::contours_along_crust}},
      {"View", {Id::fit, Id::fit_selection, Id::previous_view, Id::zoom_in, Id::zoom_out}},
      {"View > Panels",
       {Id::toggle_layers, Id::toggle_bundles, Id::toggle_selection, Id::toggle_curves, Id::toggle_sampling,
        Id::toggle_branches, Id::toggle_persistence, Id::toggle_statistics, Id::toggle_parameters,
        Id::toggle_experiments, Id::toggle_lesson, Id::toggle_log}},
      {"View > Panels", {Id::toggle_panels}},
      {"View > Legend and scale",
       {Id::toggle_legend, Id::toggle_key, Id::toggle_scale_bar, Id::toggle_axes, Id::toggle_grid,
        Id::toggle_annotations}},
      {"View > Legend and scale", {Id::put_marks_back}},
      {"View > Bundles", {Id::save_bundle, Id::import_bundles, Id::export_bundles, Id::undo_bundles}},
      {"View > Bundles", {Id::balls_inner, Id::balls_polar, Id::balls_own}},
      {"View > Bundles", {Id::next_bundle, Id::previous_bundle}},
      {"View", {Id::presenter_mode, Id::full_screen, Id::projector_mode, Id::toggle_theme}},
      {"View > Canvas", {Id::add_pane, Id::close_panes, Id::toggle_free_cameras, Id::toggle_differences}},
      {"Evolution",
       {Id::evolution_forward, Id::evolution_back, Id::evolution_play, Id::evolution_play_back, Id::evolution_stop,
        Id::evolution_first}},
      {"Evolution", {Id::toggle_evolution}},
      {"Tools", {Id::tool_select, Id::tool_insert, Id::tool_spray, Id::tool_ball}},
      {"Tools > Brush", {Id::tool_brush, Id::brush_erase, Id::brush_thin, Id::brush_refine}},
      {"Tools", {Id::tool_measure, Id::tool_annotate}},
      {"Tools", {Id::keep_measurement, Id::keep_highlight}},
      {"Tools", {Id::toggle_snap}},
      {"Tools", {Id::toggle_handles, Id::toggle_insertion_preview}},
      {"Tools > Number type",
       {Id::precision_naive, Id::precision_fast, Id::precision_exact, Id::precision_exact_roots}},
      {"Tools", {Id::toggle_union_shortcut, Id::toggle_pole_propagation}},
      {"Tools", {Id::hold_update, Id::cancel_computation, Id::resume_computation}},
      {"Shapes", {Id::make_shape, Id::write_text, Id::curves_of_samples, Id::mark_corners, Id::toggle_curves}},
      {"Help", {Id::command_palette, Id::help, Id::manual}},
      {"Help > Lessons", {Id::present_lesson, Id::export_lesson, Id::mark_step, Id::toggle_lesson}},
      {"Help", {Id::demo}},
      {"Help", {Id::classic_keys, Id::write_keys}},
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
