// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of actions. Keys (through a `Keymap`), menus, toolbar tooltips, the help overlay and `mesecina list
// actions` all read it. The effect of an action and its condition are bound elsewhere (actions/action_bindings.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/actions/key_chord.h"

namespace mes {

enum class ActionId : std::uint8_t {
  new_document,
  open,
  save,
  save_as,
  share,
  keep_degrees,
  map_system,
  trace_picture,
  picture_to_samples,
  make_shape,
  write_text,
  snapshot,
  copy_picture,
  record,
  make_video,
  export_figure,
  export_center_lines,
  export_cells,
  quit,
  undo,
  redo,
  select_all,
  invert_selection,
  deselect,
  delete_selection,
  repair_sampling,
  decimate_sampling,
  select_curve,
  grow_selection,
  shrink_selection,
  select_sources,
  canvas_menu,
  copy,
  cut,
  paste,
  duplicate,
  mirror_x,
  mirror_y,
  first_alignment,  // in the order of `Alignment`
  last_alignment = first_alignment + 5,
  distribute_x,
  distribute_y,
  put_on_line,
  put_on_circle,
  add_circle,
  first_contour_change,  // in the order of `ContourChange`
  last_contour_change = first_contour_change + 5,
  contours_along_crust,
  first_nudge,  // left, right, up, down by a pixel, then the same by ten
  last_nudge = first_nudge + 7,
  tool_select,
  tool_insert,
  tool_spray,
  tool_brush,
  brush_erase,
  brush_thin,
  brush_refine,
  tool_ball,
  tool_measure,
  tool_annotate,
  keep_measurement,
  keep_highlight,
  center_line_between,
  toggle_snap,
  toggle_handles,
  toggle_insertion_preview,
  zoom_in,
  zoom_out,
  fit,
  fit_selection,
  previous_view,
  toggle_panels,
  toggle_layers,
  toggle_bundles,
  toggle_statistics,
  toggle_parameters,
  toggle_log,
  toggle_selection,
  toggle_curves,
  curves_of_samples,
  mark_corners,
  toggle_branches,
  toggle_persistence,
  toggle_sampling,
  toggle_experiments,
  add_experiment,
  toggle_legend,
  toggle_key,
  toggle_scale_bar,
  toggle_axes,
  toggle_grid,
  toggle_annotations,
  put_marks_back,
  add_pane,
  close_panes,
  toggle_free_cameras,
  toggle_differences,
  toggle_evolution,
  toggle_theme,
  projector_mode,
  presenter_mode,
  full_screen,
  first_bundle,  // the bundles of the digits 1 to 9
  last_bundle = first_bundle + 8,
  next_bundle,
  previous_bundle,
  balls_inner,  // the three in the order of `FamilyKind`
  balls_polar,
  balls_own,
  save_bundle,
  import_bundles,
  export_bundles,
  undo_bundles,
  cancel_computation,
  resume_computation,
  hold_update,
  precision_naive,  // the four in the order of `Precision`
  precision_fast,
  precision_exact,
  precision_exact_roots,
  toggle_union_shortcut,
  toggle_pole_propagation,
  evolution_first,
  evolution_play_back,
  evolution_back,
  evolution_stop,
  evolution_forward,
  evolution_play,
  evolution_previous,
  evolution_next,
  toggle_lesson,
  mark_step,
  present_lesson,
  export_lesson,
  demo,
  classic_keys,
  write_keys,
  command_palette,
  open_menus,
  help,
  manual,
};
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(ActionId::manual) + 1;

/// The action at this index, from 0, of a series that begins with `first`.
constexpr ActionId nth(ActionId first, std::size_t place) {
  return static_cast<ActionId>(static_cast<std::size_t>(first) + place);
}
constexpr std::size_t length_of_series(ActionId first, ActionId last) {
  return static_cast<std::size_t>(last) - static_cast<std::size_t>(first) + 1;
}
inline constexpr std::size_t kNudges = length_of_series(ActionId::first_nudge, ActionId::last_nudge);
inline constexpr std::size_t kNumberedBundles = length_of_series(ActionId::first_bundle, ActionId::last_bundle);

enum class ActionGroup : std::uint8_t { file, edit, tools, view, compute, help };
std::string_view title_of(ActionGroup group);

/// The situation in which the keys of an action are valid.
enum class ActionContext : std::uint8_t { always, with_selection };

struct ActionDescriptor {
  ActionId id = ActionId::help;
  std::string public_id;  ///< kebab case, stable
  std::string name;       ///< the name shown in menus
  std::string tooltip;    ///< one sentence, no full stop
  ActionGroup group = ActionGroup::file;
  ActionContext context = ActionContext::always;
  bool repeats = false;                ///< holding the key down repeats the action
  std::vector<std::string_view> keys;  ///< the default keys (keymap.h can change them)
};

/// True for actions that change neither the document nor the overlays of the canvas. They work at any time: during a
/// gesture, while a list is open, and, if their key types nothing, while the user is typing.
bool works_at_any_time(ActionId id);

/// Holding this key down holds the update, as Alt does; many window managers take Alt for themselves.
inline constexpr char32_t kHoldKey = 'W';

/// Every action, in the order of `ActionId`.
std::span<const ActionDescriptor> action_descriptors();
const ActionDescriptor& descriptor_of(ActionId id);

/// Mouse gestures: they are not actions but belong on the same help page.
struct GestureDescriptor {
  std::string_view input;
  std::string_view meaning;
};
std::span<const GestureDescriptor> gesture_descriptors();

}  // namespace mes
