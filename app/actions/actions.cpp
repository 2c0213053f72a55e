// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/actions.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"

namespace mes {
namespace {

using enum ActionGroup;
using enum ActionContext;

struct Row {
  ActionId id;
  std::string_view public_id;
  std::string_view name;
  std::string_view tooltip;
  std::string_view keys{};  // separated by spaces
  ActionContext context = always;
  bool repeats = false;
};
constexpr bool kRepeats = true;

constexpr auto kFileRows = std::to_array<Row>({
    {ActionId::new_document, "new", "New", "Start with an empty plane", "Ctrl+N"},
    {ActionId::open, "open", "Open...", "Open a session, samples, balls, bundles, or a picture with its source",
     "Ctrl+O"},
    {ActionId::save, "save", "Save", "Save the session, or the samples and balls, to the current file", "Ctrl+S"},
    {ActionId::save_as, "save-as", "Save as...",
     "Write to another file: .json keeps everything, .poff the samples, .wpoff the balls", "Ctrl+Shift+S"},
    {ActionId::share, "share", "Share",
     "Copy a link that opens this session; only in a browser, where a page has an address"},
    {ActionId::keep_degrees, "keep-degrees", "Keep degrees of maps",
     "Use longitude and latitude of maps (GeoJSON, WKT, KML, GPX, shapefiles) as coordinates in degrees instead of "
     "projecting them to metres, and those of web maps as they are; an open map is read again"},
    {ActionId::map_system, "map-system", "Coordinate system...",
     "Read the open map, table or drawing again, with positions in the coordinate system that you name, such as "
     "EPSG:25832: results are in it again"},
    {ActionId::trace_picture, "trace-picture", "Picture underneath...",
     "Show a picture below the drawing, to place samples along it"},
    {ActionId::picture_to_samples, "trace-into-samples", "Trace a picture...",
     "Sample the outlines in a silhouette or photograph: PNG, JPEG, BMP, PGM"},
    {ActionId::make_shape, "make-shape", "Make a shape...",
     "Sample a parametric shape: circles, gears, spirals, formulas, random points and more"},
    {ActionId::write_text, "write-text", "Write a text...", "Sample the outlines of a text, in any installed font"},
    {ActionId::snapshot, "snapshot", "Snapshot",
     "Save the view as a new picture, in the folder set under the button with three dots", "F3"},
    {ActionId::copy_picture, "copy-picture", "Copy picture", "Copy the view to the clipboard as a picture",
     "Ctrl+Shift+C"},
    {ActionId::record, "record", "Record", "Start or stop writing a numbered picture after each change", "F4"},
    {ActionId::make_video, "make-video", "Make video", "Make a video of the last take with ffmpeg"},
    {ActionId::export_figure, "export-figure", "Export a figure...",
     "Export the view as PDF, SVG, PostScript, Ipe or TikZ, at a given size on paper", "Ctrl+E"},
    {ActionId::export_center_lines, "export-center-lines", "Export centre lines...",
     "Write the centre lines, smoothed, with their lengths and widths, for maps (GeoJSON, WKT, GeoPackage, "
     "FlatGeobuf) "
     "and drawings (SVG, DXF), or as CSV; with two samples selected, the line between the ends near them"},
    {ActionId::export_cells, "export-cells", "Export Voronoi cells...",
     "Write the Voronoi cell of each sample as a polygon, as GeoJSON, WKT, GeoPackage or FlatGeobuf: within the "
     "outline of a map with points beside it, else within a box"},
    {ActionId::quit, "quit", "Quit", "Close the window", "Ctrl+Q"},
});

constexpr auto kEditRows = std::to_array<Row>({
    {ActionId::undo, "undo", "Undo", "Undo the last step", "Ctrl+Z", always, kRepeats},
    {ActionId::redo, "redo", "Redo", "Redo the step that was undone last", "Ctrl+Shift+Z Ctrl+Y", always, kRepeats},
    {ActionId::select_all, "select-all", "Select all", "Select every sample and every ball", "Ctrl+A"},
    {ActionId::invert_selection, "invert-selection", "Invert selection",
     "Swap selected and unselected samples and balls", "Ctrl+I"},
    {ActionId::deselect, "deselect", "Deselect",
     "End the current gesture, close messages or the card of the clicked element, clear the selection, end the "
     "presentation, or show hidden panels: each press does the next of these that is possible",
     "Esc"},
    {ActionId::delete_selection, "delete", "Delete", "Delete the selection", "Delete Backspace", with_selection},
    {ActionId::repair_sampling, "repair-sampling", "Repair the sampling",
     "Insert samples, on a spline through the existing ones, where the curve has too few for the theorem"},
    {ActionId::decimate_sampling, "decimate-sampling", "Decimate the sampling",
     "Remove samples that neither the curve nor the topology of the axis needs"},
    {ActionId::select_curve, "select-curve", "Select the curve",
     "Select all samples of every curve that has a selected sample", "Shift+A"},
    {ActionId::grow_selection, "grow-selection", "Grow selection", "Add the neighbours on the curve to the selection",
     ">", always, kRepeats},
    {ActionId::shrink_selection, "shrink-selection", "Shrink selection",
     "Remove from the selection the samples with an unselected neighbour on the curve", "<", always, kRepeats},
    {ActionId::select_sources, "select-sources", "Select the samples of the clicked element",
     "Select the samples or balls from which the element on the card derives"},
    {ActionId::canvas_menu, "canvas-menu", "Menu at the cursor",
     "Open the menu of a right click: commands for the sample, annotation or element at the cursor",
     "Menu Shift+F10"},
    {ActionId::copy, "copy", "Copy",
     "Copy the selection to the clipboard as text: one line of numbers for each sample", "Ctrl+C"},
    {ActionId::cut, "cut", "Cut", "Copy the selection to the clipboard and delete it", "Ctrl+X"},
    {ActionId::paste, "paste", "Paste",
     "Add the samples and balls from the text on the clipboard: a table, an SVG drawing, a map or a session",
     "Ctrl+V"},
    {ActionId::duplicate, "duplicate", "Duplicate",
     "Add a copy of the selection, shifted a little to the lower right", "Ctrl+D"},
    {ActionId::mirror_x, "mirror-x", "Mirror left and right",
     "Reflect the selection about the vertical line through its middle"},
    {ActionId::mirror_y, "mirror-y", "Mirror above and below",
     "Reflect the selection about the horizontal line through its middle"},
    {nth(ActionId::first_alignment, 0), "align-left", "Align left", "Align the selection at the x of its left end"},
    {nth(ActionId::first_alignment, 1), "align-center", "Align at the vertical middle line",
     "Align the selection at the x of its middle"},
    {nth(ActionId::first_alignment, 2), "align-right", "Align right",
     "Align the selection at the x of its right end"},
    {nth(ActionId::first_alignment, 3), "align-bottom", "Align at the bottom",
     "Align the selection at the y of its lower end"},
    {nth(ActionId::first_alignment, 4), "align-middle", "Align at the horizontal middle line",
     "Align the selection at the y of its middle"},
    {nth(ActionId::first_alignment, 5), "align-top", "Align at the top",
     "Align the selection at the y of its upper end"},
    {ActionId::distribute_x, "distribute-x", "Distribute from left to right",
     "Space the selection evenly in x, between the outermost two"},
    {ActionId::distribute_y, "distribute-y", "Distribute from bottom to top",
     "Space the selection evenly in y, between the outermost two"},
    {ActionId::put_on_line, "put-on-line", "Put exactly on a line",
     "Move the selected points slightly, to coordinates that lie exactly on one line"},
    {ActionId::put_on_circle, "put-on-circle", "Put exactly on a circle",
     "Move the selected points slightly, to coordinates that lie exactly on one circle"},
    {ActionId::add_circle, "add-circle", "Circle through three",
     "Add the ball whose circle passes through the three selected points"},
    {nth(ActionId::first_contour_change, 0), "join-contours", "Join contours",
     "Link the two selected samples, each an end of an open contour or on no contour; the two ends of one contour "
     "close it",
     "J"},
    {nth(ActionId::first_contour_change, 1), "cut-contours", "Cut contours",
     "Remove the contour links between selected neighbours", "Shift+J"},
    {nth(ActionId::first_contour_change, 2), "close-contours", "Close contours",
     "Close the open contours with a selected sample"},
    {nth(ActionId::first_contour_change, 3), "open-contours", "Open contours",
     "Open the closed contours with a selected sample: between selected neighbours, or before the selected sample"},
    {nth(ActionId::first_contour_change, 4), "reverse-contours", "Reverse contours",
     "Reverse the order of the contours with a selected sample"},
    {nth(ActionId::first_contour_change, 5), "forget-contours", "Forget contours",
     "Remove the contours with a selected sample; the samples stay"},
    {ActionId::contours_along_crust, "contours-along-crust", "Contours along the crust",
     "Turn chains of the crust into contours: those with a selected sample, or all"},
});

constexpr auto kToolsRows = std::to_array<Row>({
    {ActionId::tool_select, "tool-select", "Select and move",
     "Click or drag a box to select; drag a sample or a ball to move it; turn the wheel on a selected ball to change "
     "its radius",
     "V"},
    {ActionId::tool_insert, "tool-insert", "Insert", "Click to add a sample; hold the button down to position it",
     "I"},
    {ActionId::tool_spray, "tool-spray", "Spray", "Drag to draw a stroke of evenly spaced samples", "S"},
    {ActionId::tool_brush, "tool-brush", "Brush",
     "Drag over samples to erase, thin out or refine them along the curve; press again for the next of these three",
     "X"},
    {ActionId::brush_erase, "brush-erase", "Erase",
     "Choose the brush that erases samples, and balls at their centres"},
    {ActionId::brush_thin, "brush-thin", "Thin out",
     "Choose the brush that removes every other sample along the curve"},
    {ActionId::brush_refine, "brush-refine", "Refine",
     "Choose the brush that inserts a sample between neighbours along the curve"},
    {ActionId::tool_ball, "tool-ball", "Ball",
     "Press at the centre of a ball and drag to its circle; a click alone does nothing", "B"},
    {ActionId::tool_measure, "tool-measure", "Measure",
     "Click two points for their distance, a third for angle and circle; points on samples follow them", "M"},
    {ActionId::tool_annotate, "tool-annotate", "Annotate",
     "Click to write on the drawing; drag for an arrow, or from a sample or a vertex for text with a line to it",
     "A"},
    {ActionId::keep_measurement, "keep-measurement", "Keep measurement",
     "Keep the measurement in the document as a dimension line, an angle or a radius", "K"},
    {ActionId::keep_highlight, "keep-highlight", "Keep highlighted",
     "Keep the highlights of the clicked element's card in the document; they follow the samples and balls",
     "Shift+K"},
    {ActionId::center_line_between, "center-line-between", "Centre line between two ends",
     "Show only the centre line between the ends of the axis nearest to two measured points or selected samples; the "
     "ends are an annotation, which follows samples and can be moved, deleted and undone"},
    {ActionId::toggle_snap, "toggle-snap", "Snap",
     "Snap inserted or moved points exactly to nearby samples, centres, Voronoi vertices, circles or grid lines; "
     "hold Ctrl to turn it off",
     "Shift+S"},
    {ActionId::toggle_handles, "toggle-handles", "Handles of the selection",
     "Show or hide the frame around the selection, whose handles scale, mirror and turn it", "H"},
    {ActionId::toggle_insertion_preview, "toggle-insertion-preview", "Preview of an insertion",
     "Show what a sample at the cursor would change: the Delaunay triangles it removes, the edges it adds and its "
     "Voronoi cell",
     "Shift+I"},
});

constexpr auto kViewRows = std::to_array<Row>({
    {ActionId::zoom_in, "zoom-in", "Zoom in", "Magnify at the cursor", "+ =", always, kRepeats},
    {ActionId::zoom_out, "zoom-out", "Zoom out", "Shrink at the cursor", "-", always, kRepeats},
    {ActionId::fit, "fit", "Fit to view", "Show all samples and balls", "F Home"},
    {ActionId::fit_selection, "fit-selection", "Fit selection", "Show the selection", "Shift+F"},
    {ActionId::previous_view, "previous-view", "Previous view", "Return to the view before this one", "Alt+Left"},
    {ActionId::toggle_panels, "toggle-panels", "All panels",
     "Hide all panels, or show them again; Esc shows them, too", "Tab"},
    {ActionId::toggle_layers, "toggle-layers", "Layers", "Show or hide the list of layers", "L"},
    {ActionId::toggle_bundles, "toggle-bundles", "Bundles", "Show or hide the list of bundles", "Shift+L"},
    {ActionId::toggle_statistics, "toggle-statistics", "Statistics",
     "Show or hide counts and times of every structure", "T"},
    {ActionId::toggle_parameters, "toggle-parameters", "Parameters", "Show or hide the parameters of the computation",
     "P"},
    {ActionId::toggle_log, "toggle-log", "Log", "Show or hide the messages of the program"},
    {ActionId::toggle_selection, "toggle-selection", "Selection in numbers",
     "Show or hide coordinates and radii of the selection, to set them by number or formula", "N"},
    {ActionId::toggle_curves, "toggle-curves", "Curves and their sampling",
     "Show or hide how the curves of a drawing, map, picture or shape are sampled", "Shift+N"},
    {ActionId::curves_of_samples, "curves-of-samples", "Curves through samples",
     "Lay smooth curves through the samples, in the order of the crust, so that they can be sampled again"},
    {ActionId::mark_corners, "mark-corners", "Mark corners", "Annotate each corner of the curves with its angle"},
    {ActionId::toggle_branches, "toggle-branches", "Branches of the axis",
     "Show or hide the table of the branches of the axis, with histograms of radius and lambda", "Shift+B"},
    {ActionId::toggle_persistence, "toggle-persistence", "Persistence diagram",
     "Show or hide births and deaths of components and holes as disks around the samples, or balls, grow", "Shift+G"},
    {ActionId::toggle_sampling, "toggle-sampling", "Sampling",
     "Show or hide sampling problems, their locations and fixes"},
    {ActionId::toggle_experiments, "toggle-experiments", "Experiments",
     "Show or hide your own structures, layers, evolutions and shapes, with the messages of the compiler"},
    {ActionId::add_experiment, "add-experiment", "Load an experiment...",
     "Compile and load a C++ source with your own structures; saving the file loads its new version"},
    {ActionId::toggle_legend, "toggle-legend", "Legend", "Show or hide the colour bars of layers with a colour map",
     "C"},
    {ActionId::toggle_key, "toggle-key", "Key of layers",
     "Show or hide the names of all visible layers, with a sample of how each is drawn"},
    {ActionId::toggle_scale_bar, "toggle-scale-bar", "Scale bar",
     "Show or hide a bar of a round length, labelled in units of the samples"},
    {ActionId::toggle_axes, "toggle-axes", "Axes", "Show or hide numbers along the bottom and left edges"},
    {ActionId::toggle_grid, "toggle-grid", "Grid", "Show or hide faint lines at the round numbers of the axes", "G"},
    {ActionId::toggle_annotations, "toggle-annotations", "Annotations",
     "Show or hide text, arrows, dimensions and highlights added to the drawing"},
    {ActionId::put_marks_back, "put-marks-back", "Reset legend and scale bar",
     "Move the legend and the scale bar, where they were dragged, back to their default positions"},
    {ActionId::add_pane, "add-pane", "Add a pane",
     "Show the same view again beside it, with another number type, parameter, family of balls, bundle or version of "
     "the document; at most four panes",
     "F6"},
    {ActionId::close_panes, "close-panes", "Close panes", "Close all panes but the main one", "Shift+F6"},
    {ActionId::toggle_free_cameras, "toggle-free-cameras", "Free cameras of panes",
     "Zoom and pan each pane separately; when locked again, all show the view of the main pane", "Alt+F6"},
    {ActionId::toggle_differences, "toggle-differences", "Mark differences",
     "Mark in each pane what another pane lacks", "Ctrl+F6"},
    {ActionId::toggle_evolution, "toggle-evolution", "Evolution",
     "Show or hide the evolution slider: smooth, subdivide and others, step by step", "E"},
    {ActionId::toggle_theme, "toggle-theme", "Dark theme",
     "Switch between dark and light panels; the canvas follows unless it has its own colour", "Shift+D"},
    {ActionId::projector_mode, "projector-mode", "Projector mode",
     "Use larger text and lines, and the strongest contrast", "Shift+P"},
    {ActionId::presenter_mode, "presenter-mode", "Presenter mode",
     "Fill the screen with the drawing, show pressed keys and a large pointer; bundles are the slides, changed with "
     "the "
     "Page keys",
     "F5"},
    {ActionId::full_screen, "full-screen", "Full screen",
     "Fill the screen with the window, or show it at its former size", "F11"},
});

constexpr auto kBundleRows = std::to_array<Row>({
    {ActionId::next_bundle, "next-bundle", "Next bundle",
     "Show the layers as in the bundle below; in a lesson, go to the next step", "PageDown"},
    {ActionId::previous_bundle, "previous-bundle", "Previous bundle",
     "Show the layers as in the bundle above; in a lesson, go back a step", "PageUp"},
    {ActionId::balls_inner, "balls-inner", "Inner balls",
     "Switch the union layers to the balls around the Voronoi vertices inside the curve"},
    {ActionId::balls_polar, "balls-polar", "Polar balls",
     "Switch the union layers to the balls around the inner poles of the samples"},
    {ActionId::balls_own, "balls-own", "Own balls",
     "Switch the union layers to the balls that you drew or read from a file"},
    {ActionId::save_bundle, "save-bundle", "Save bundle...", "Save the layers, their order and styles under a name",
     "Ctrl+B"},
    {ActionId::import_bundles, "import-bundles", "Import bundles...",
     "Add the bundles of a file, .json or the .bnd of 2007 and 2009"},
    {ActionId::export_bundles, "export-bundles", "Export bundles...", "Write all bundles to a file"},
    {ActionId::undo_bundles, "undo-bundles", "Undo change of bundles", "Undo the last change to the list of bundles"},
});

constexpr auto kComputeRows = std::to_array<Row>({
    {ActionId::cancel_computation, "cancel", "Cancel computation",
     "Stop computing; the present results stay on screen", "Ctrl+."},
    {ActionId::resume_computation, "resume", "Resume computation", "Compute what was cancelled"},
    {ActionId::hold_update, "hold-update", "Hold the update",
     "Edit while all structures stay as they are; when released, they update at once. Holding W or Alt while "
     "dragging does the same",
     "Ctrl+H"},
    {ActionId::precision_naive, "precision-naive", "Naive: plain doubles",
     "Use floating-point numbers without exact decisions; results for degenerate input are wrong, which shows why "
     "exact decisions matter"},
    {ActionId::precision_fast, "precision-fast", "Fast: exact decisions on doubles",
     "Decide exactly on the samples, and round constructed points to doubles"},
    {ActionId::precision_exact, "precision-exact", "Exact: rationals",
     "Compute constructed points with rational numbers, and with roots where they are needed"},
    {ActionId::precision_exact_roots, "precision-exact-roots", "Exact with roots",
     "Use algebraic numbers throughout; slow, the reference for the others"},
    {ActionId::toggle_union_shortcut, "toggle-union-shortcut", "Certified shortcut for unions",
     "Compute unions of inner and polar balls exactly even in fast, and in a shorter way where that is certified; "
     "off: compute them by the general pipeline in the number type"},
    {ActionId::toggle_pole_propagation, "toggle-pole-propagation", "Pole labels by propagation",
     "Spread the labels from pole to pole, as Amenta, Choi and Kolluri do; off: label poles by their triangles"},
});

constexpr auto kEvolutionRows = std::to_array<Row>({
    {ActionId::evolution_first, "evolution-first", "Back to the beginning",
     "Show the samples as they were before the evolution"},
    {ActionId::evolution_play_back, "evolution-play-back", "Play backwards",
     "Undo the steps of the evolution one by one"},
    {ActionId::evolution_back, "evolution-back", "Step back", "Show the state of the evolution before this one",
     "[ Ctrl+Left", always, kRepeats},
    {ActionId::evolution_stop, "evolution-stop", "Stop the evolution",
     "Stop playing and abandon the step being computed"},
    {ActionId::evolution_forward, "evolution-forward", "Step forward", "Take the next step of the evolution",
     "] Ctrl+Right", always, kRepeats},
    {ActionId::evolution_play, "evolution-play", "Play the evolution",
     "Take step after step, each as soon as the previous picture is complete"},
    {ActionId::evolution_previous, "evolution-previous", "Previous evolution",
     "Choose the previous evolution, which begins from the samples shown", "Ctrl+Up"},
    {ActionId::evolution_next, "evolution-next", "Next evolution",
     "Choose the next evolution, which begins from the samples shown", "Ctrl+Down"},
});

constexpr auto kHelpRows = std::to_array<Row>({
    {ActionId::toggle_lesson, "toggle-lesson", "Steps of the lesson",
     "Show or hide the panel for making a lesson: its steps, their order and their captions"},
    {ActionId::mark_step, "mark-step", "Mark a step",
     "Add the present state to the lesson as a step, after the chosen one, or at the end if none is chosen"},
    {ActionId::present_lesson, "present-lesson", "Present the lesson",
     "Step through the lesson of the session with the Page keys, while its samples can be edited; Esc ends it and "
     "restores the document",
     "Shift+F5"},
    {ActionId::export_lesson, "export-lesson", "Export the lesson...",
     "Write the steps of the lesson to a file: PDF, HTML, or a video as MP4 or WebM, by the end of its name"},
    {ActionId::demo, "demo", "Demo", "Play the paper's video, computed live; Esc ends it"},
    {ActionId::classic_keys, "classic-keys", "Classic Mesecina keys",
     "Switch between the keys of the program of 2007 and those of this one; the manual lists the differences"},
    {ActionId::write_keys, "write-keys", "Write or reread the file of keys",
     "Write a file of all commands and their keys, to edit by hand; if it exists already, read the keys from it "
     "again"},
    {ActionId::command_palette, "command-palette", "Find anything...",
     "Find a command, layer, bundle, parameter, evolution, shape, recent file or heading of the manual by some "
     "letters of its name or by another word for it",
     "Ctrl+Shift+P Ctrl+K"},
    {ActionId::open_menus, "open-menus", "Open the menus",
     "Open the first menu; arrow keys go through the menus, Enter chooses, Esc closes", "F10"},
    {ActionId::help, "help", "Keys and gestures", "Show every key", "? F1"},
    {ActionId::manual, "manual", "Manual",
     "Read and search the manual: keys, layers, parameters, files, the command line", "Shift+F1"},
});

using ActionTable = std::vector<ActionDescriptor>;

std::vector<std::string_view> separated(std::string_view words) {
  std::vector<std::string_view> out;
  while (!words.empty()) {
    out.push_back(words.substr(0, words.find(' ')));
    words.remove_prefix(std::min(out.back().size() + 1, words.size()));
  }
  return out;
}

void add(ActionTable& table, ActionGroup group, std::span<const Row> rows) {
  for (const Row& row : rows)
    table.push_back({row.id, std::string(row.public_id), std::string(row.name), std::string(row.tooltip), group,
                     row.context, row.repeats, separated(row.keys)});
}

void add_nudges(ActionTable& table) {
  struct Direction {
    std::string name;
    std::string_view key;
    std::string_view far_key;
  };
  const std::array<Direction, kNudges / 2> directions{{{"left", "Left", "Shift+Left"},
                                                       {"right", "Right", "Shift+Right"},
                                                       {"up", "Up", "Shift+Up"},
                                                       {"down", "Down", "Shift+Down"}}};
  for (std::size_t i = 0; i < kNudges; ++i) {
    const Direction& to = directions[i % directions.size()];
    const bool is_far = i >= directions.size();
    table.push_back({nth(ActionId::first_nudge, i),
                     "nudge-" + to.name + (is_far ? "-far" : ""),
                     "Nudge " + to.name + (is_far ? " by ten" : ""),
                     std::string("Move the selection by ") + (is_far ? "ten pixels" : "one pixel") + " of the screen",
                     edit,
                     with_selection,
                     kRepeats,
                     {is_far ? to.far_key : to.key}});
  }
}

void add_bundles(ActionTable& table) {
  constexpr std::string_view kDigits = "123456789";
  constexpr std::array<std::string_view, kNumberedBundles> kOrdinals{"first", "second",  "third",  "fourth", "fifth",
                                                                     "sixth", "seventh", "eighth", "ninth"};
  for (std::size_t i = 0; i < kNumberedBundles; ++i) {
    const std::string_view digit = kDigits.substr(i, 1);
    table.push_back({nth(ActionId::first_bundle, i),
                     "bundle-" + std::string(digit),
                     "Bundle " + std::string(digit),
                     "Show the layers as in the " + std::string(kOrdinals[i]) + " bundle",
                     view,
                     always,
                     false,
                     {digit}});
  }
}

ActionTable make_table() {
  ActionTable out;
  out.reserve(kActionCount);
  add(out, file, kFileRows);
  add(out, edit, kEditRows);
  add_nudges(out);
  add(out, tools, kToolsRows);
  add(out, view, kViewRows);
  add_bundles(out);
  add(out, view, kBundleRows);
  add(out, compute, kComputeRows);
  add(out, compute, kEvolutionRows);
  add(out, ActionGroup::help, kHelpRows);
  return out;
}

}  // namespace

std::string_view title_of(ActionGroup group) {
  constexpr std::array<std::string_view, 6> titles{"File", "Edit", "Tools", "View", "Computation", "Help"};
  return titles[static_cast<std::size_t>(group)];
}

bool works_at_any_time(ActionId id) {
  switch (id) {
    case ActionId::snapshot:
    case ActionId::copy_picture:
    case ActionId::record:
    case ActionId::toggle_snap:
    case ActionId::zoom_in:
    case ActionId::zoom_out:
    case ActionId::cancel_computation:
    case ActionId::resume_computation:
    case ActionId::hold_update: return true;
    default: return false;
  }
}

std::span<const ActionDescriptor> action_descriptors() {
  static const ActionTable table = make_table();
  return table;
}

const ActionDescriptor& descriptor_of(ActionId id) {
  const ActionDescriptor& found = action_descriptors()[static_cast<std::size_t>(id)];
  MES_ASSERT(found.id == id);
  return found;
}

std::span<const GestureDescriptor> gesture_descriptors() {
  static constexpr std::array<GestureDescriptor, 24> table{{
      {"Wheel", "zoom at the cursor"},
      {"Middle drag, right drag", "pan"},
      {"Space + drag", "pan"},
      {"Click", "select a sample (select tool), add one (insert tool)"},
      {"Click anything drawn",
       "show what it derives from and what it leads to; a sample or a ball under it is selected as well (select "
       "tool)"},
      {"Right click", "open a menu for the sample, annotation or element there"},
      {"Ctrl + click, Alt + click", "the same for a sample or a ball"},
      {"Double click on a sample", "select its curve"},
      {"Shift + click or box", "add to the selection"},
      {"Ctrl + Shift + click or box", "remove from the selection"},
      {"Drag a sample or a ball", "move it, with the selection it belongs to"},
      {"Drag a handle of the frame",
       "scale, mirror or turn the selection; Shift: about its middle, in steps of 15 degrees"},
      {"W + drag or click, Alt + drag or click",
       "edit; all structures follow when the key is released (many window managers reserve Alt)"},
      {"Drag empty space", "select what is in the box"},
      {"Ctrl + drag empty space", "select what the lasso encloses; hold Shift at the end to add it"},
      {"Drag with the spray tool", "draw a stroke"},
      {"Drag with the brush", "erase, thin out or refine samples"},
      {"Drag with the ball tool", "draw a ball from its centre"},
      {"Click with the annotation tool", "write text; on a sample or a vertex, with a line to it"},
      {"Drag with the annotation tool", "draw an arrow; from a sample or a vertex, a line to text"},
      {"Drag an annotation", "move it, or one of its ends (annotation tool)"},
      {"Wheel on a selected ball", "change its radius; point at its centre or its circle"},
      {"Click a number", "type another one, or an expression such as 2/3 or sqrt(2)"},
      {"Drop files on the window", "open them; samples and balls together, bundles as well"},
  }};
  return table;
}

}  // namespace mes
