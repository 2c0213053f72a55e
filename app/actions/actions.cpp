// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/actions.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"

namespace mes {
namespace {

using enum ActionGroup;
using enum ActionContext;
using Id = ActionId;

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
    {Id::new_document, "new", "New", "Start with an empty plane", "Ctrl+N"},
    {Id::open, "open", "Open...", "Open a session, samples, balls, bundles, or a picture with its source", "Ctrl+O"},
    {Id::save, "save", "Save", "Write the session, or samples and balls, to the file they have", "Ctrl+S"},
    {Id::save_as, "save-as", "Save as...",
     "Write to another file: .json keeps everything, .poff the samples, .wpoff the balls", "Ctrl+Shift+S"},
    {Id::keep_degrees, "keep-degrees", "Keep degrees of maps",
     "Take longitude and latitude of maps (GeoJSON, WKT, KML, GPX, shapefiles) as coordinates in degrees, not "
     "projected to "
     "kilometres; a map that is open is read again"},
    {Id::trace_picture, "trace-picture", "Picture underneath...",
     "Lay a picture below the drawing, to set samples along it"},
    {Id::picture_to_samples, "trace-into-samples", "Trace a picture...",
     "Make samples of the outlines that a silhouette or photograph shows: PNG, JPEG, BMP, PGM"},
    {Id::make_shape, "make-shape", "Make a shape...",
     "Make samples of a shape with parameters: circles, gears, spirals, formulas, random points and more"},
    {Id::write_text, "write-text", "Write a text...",
     "Make samples of the outlines of a text, in any installed font"},
    {Id::snapshot, "snapshot", "Snapshot",
     "Write what is shown to a new picture, in the folder that the button with three dots names", "F3"},
    {Id::copy_picture, "copy-picture", "Copy picture", "Put what is shown on the clipboard, as a picture",
     "Ctrl+Shift+C"},
    {Id::record, "record", "Record", "Write a numbered picture after each change from now on, or end doing so", "F4"},
    {Id::make_video, "make-video", "Make video", "Make a video of the last take with ffmpeg"},
    {Id::export_figure, "export-figure", "Export a figure...",
     "Write what is shown as PDF, SVG, PostScript, Ipe or TikZ, with its size on paper", "Ctrl+E"},
    {Id::quit, "quit", "Quit", "Close the window", "Ctrl+Q"},
});

constexpr auto kEditRows = std::to_array<Row>({
    {Id::undo, "undo", "Undo", "Take back the last step", "Ctrl+Z", always, kRepeats},
    {Id::redo, "redo", "Redo", "Do the step again that was taken back", "Ctrl+Shift+Z Ctrl+Y", always, kRepeats},
    {Id::select_all, "select-all", "Select all", "Select every sample and every ball", "Ctrl+A"},
    {Id::invert_selection, "invert-selection", "Invert selection", "Select what is not selected, and only that",
     "Ctrl+I"},
    {Id::deselect, "deselect", "Deselect",
     "End the gesture under way, take away the card of what was clicked, or select nothing", "Esc"},
    {Id::delete_selection, "delete", "Delete", "Remove what is selected", "Delete Backspace", with_selection},
    {Id::repair_sampling, "repair-sampling", "Repair the sampling",
     "Insert samples on a spline through the others where the curve has too few of them for the theorem"},
    {Id::decimate_sampling, "decimate-sampling", "Decimate the sampling",
     "Remove samples that neither the curve nor the topology of the axis needs"},
    {Id::select_curve, "select-curve", "Select the curve",
     "Select all samples of the curves on which something is selected", "Shift+A"},
    {Id::grow_selection, "grow-selection", "Grow selection", "Select what is next to it on the curve, too", ">",
     always, kRepeats},
    {Id::shrink_selection, "shrink-selection", "Shrink selection",
     "Take out of the selection what is next to something else on the curve", "<", always, kRepeats},
    {Id::select_sources, "select-sources", "Select the samples of what was clicked",
     "Select the samples, or balls, that the element on the card is or comes from"},
    {Id::copy, "copy", "Copy", "Put what is selected on the clipboard, as text: one line of numbers for each sample",
     "Ctrl+C"},
    {Id::cut, "cut", "Cut", "Put what is selected on the clipboard, and remove it", "Ctrl+X"},
    {Id::paste, "paste", "Paste",
     "Add the samples and balls that the text on the clipboard holds: a table, a drawing as SVG, a map, a session",
     "Ctrl+V"},
    {Id::duplicate, "duplicate", "Duplicate", "Add what is selected once more, a little to the lower right",
     "Ctrl+D"},
    {Id::mirror_x, "mirror-x", "Mirror left and right",
     "Reflect what is selected about the vertical line in its middle"},
    {Id::mirror_y, "mirror-y", "Mirror above and below",
     "Reflect what is selected about the horizontal line in its middle"},
    {nth(Id::first_alignment, 0), "align-left", "Align left", "Move what is selected to the x of its left end"},
    {nth(Id::first_alignment, 1), "align-center", "Align at the vertical middle line",
     "Move what is selected to the x of its middle"},
    {nth(Id::first_alignment, 2), "align-right", "Align right", "Move what is selected to the x of its right end"},
    {nth(Id::first_alignment, 3), "align-bottom", "Align at the bottom",
     "Move what is selected to the y of its lower end"},
    {nth(Id::first_alignment, 4), "align-middle", "Align at the horizontal middle line",
     "Move what is selected to the y of its middle"},
    {nth(Id::first_alignment, 5), "align-top", "Align at the top", "Move what is selected to the y of its upper end"},
    {Id::distribute_x, "distribute-x", "Distribute from left to right",
     "Give what is selected equal steps in x, between the outermost two"},
    {Id::distribute_y, "distribute-y", "Distribute from bottom to top",
     "Give what is selected equal steps in y, between the outermost two"},
    {Id::put_on_line, "put-on-line", "Put exactly on a line",
     "Move what is selected to nearby doubles that are collinear as real numbers"},
    {Id::put_on_circle, "put-on-circle", "Put exactly on a circle",
     "Move what is selected to nearby doubles that are cocircular as real numbers"},
    {Id::add_circle, "add-circle", "Circle through three",
     "Add the ball whose circle goes through the three that are selected"},
    {nth(Id::first_contour_change, 0), "join-contours", "Join contours",
     "Link the two selected samples, each the end of an open contour or on none; the two ends of one close it", "J"},
    {nth(Id::first_contour_change, 1), "cut-contours", "Cut contours",
     "Take away the links of contours between selected neighbours", "Shift+J"},
    {nth(Id::first_contour_change, 2), "close-contours", "Close contours",
     "Close the open contours with a selected sample"},
    {nth(Id::first_contour_change, 3), "open-contours", "Open contours",
     "Open the closed contours with a selected sample: between selected neighbours, or before the selected sample"},
    {nth(Id::first_contour_change, 4), "reverse-contours", "Turn contours around",
     "Reverse the order of the contours with a selected sample"},
    {nth(Id::first_contour_change, 5), "forget-contours", "Forget contours",
     "Take away the contours with a selected sample; the samples stay"},
    {Id::contours_along_crust, "contours-along-crust", "Contours along the crust",
     "Make contours of the chains of the crust: of those with a selected sample, or of all"},
});

constexpr auto kToolsRows = std::to_array<Row>({
    {Id::tool_select, "tool-select", "Select and move",
     "Click or box to select; drag a sample or a ball to move it; turn the wheel on a selected ball to change its "
     "radius",
     "V"},
    {Id::tool_insert, "tool-insert", "Insert", "Click to add a sample; keep the button down to place it", "I"},
    {Id::tool_spray, "tool-spray", "Spray", "Drag to draw a stroke of evenly spaced samples", "S"},
    {Id::tool_brush, "tool-brush", "Brush",
     "Drag over samples to erase them, to thin them out or to refine them along the curve; pressed again, the next "
     "of "
     "these three",
     "X"},
    {Id::brush_erase, "brush-erase", "Erase", "Take the brush that erases samples, and balls by their centres"},
    {Id::brush_thin, "brush-thin", "Thin out", "Take the brush that takes away every other sample along the curve"},
    {Id::brush_refine, "brush-refine", "Refine",
     "Take the brush that puts a sample between neighbours along the curve"},
    {Id::tool_ball, "tool-ball", "Ball",
     "Press at the centre of a ball and drag to its circle; a click alone makes nothing", "B"},
    {Id::tool_measure, "tool-measure", "Measure",
     "Click two places for their distance, a third for angle and circle; places on samples follow them", "M"},
    {Id::tool_annotate, "tool-annotate", "Annotate",
     "Click to write on the drawing; drag for an arrow, or from a sample or a vertex for words with a line to it",
     "A"},
    {Id::keep_measurement, "keep-measurement", "Keep measurement",
     "Make what is measured a part of the document: a dimension line, an angle or a radius", "K"},
    {Id::keep_highlight, "keep-highlight", "Keep highlighted",
     "Make what the card of a clicked element highlights a part of the document; it follows the samples and balls",
     "Shift+K"},
    {Id::toggle_snap, "toggle-snap", "Snap",
     "Put what is inserted or moved exactly on nearby samples, centres, Voronoi vertices, circles or lines of the "
     "grid; with Ctrl held it is off",
     "Shift+S"},
    {Id::toggle_handles, "toggle-handles", "Handles of the selection",
     "Show or hide the frame around what is selected, whose handles scale, mirror and turn it", "H"},
    {Id::toggle_insertion_preview, "toggle-insertion-preview", "Preview of an insertion",
     "Show what a sample at the cursor would change: the Delaunay triangles that go, the edges that come and its "
     "Voronoi cell",
     "Shift+I"},
});

constexpr auto kViewRows = std::to_array<Row>({
    {Id::zoom_in, "zoom-in", "Zoom in", "Magnify at the cursor", "+ =", always, kRepeats},
    {Id::zoom_out, "zoom-out", "Zoom out", "Shrink at the cursor", "-", always, kRepeats},
    {Id::fit, "fit", "Fit to view", "Show all samples and balls", "F Home"},
    {Id::fit_selection, "fit-selection", "Fit selection", "Show what is selected", "Shift+F"},
    {Id::previous_view, "previous-view", "Previous view", "Return to where you looked before", "Alt+Left"},
    {Id::toggle_panels, "toggle-panels", "Panels", "Hide all panels, or show them again", "Tab"},
    {Id::toggle_layers, "toggle-layers", "Layers", "Show or hide the list of layers", "L"},
    {Id::toggle_statistics, "toggle-statistics", "Statistics", "Show or hide counts and times of every structure",
     "T"},
    {Id::toggle_parameters, "toggle-parameters", "Parameters", "Show or hide the numbers that steer what is computed",
     "P"},
    {Id::toggle_log, "toggle-log", "Log", "Show or hide what the program has said"},
    {Id::toggle_selection, "toggle-selection", "Selection in numbers",
     "Show or hide coordinates and radii of what is selected, to be set by number or formula", "N"},
    {Id::toggle_curves, "toggle-curves", "Curves and their sampling",
     "Show or hide how samples are taken from the curves of a drawing, map, picture or shape", "Shift+N"},
    {Id::curves_of_samples, "curves-of-samples", "Curves through samples",
     "Lay smooth curves through the samples, in the order of the crust, so that others can be taken of them"},
    {Id::mark_corners, "mark-corners", "Mark corners",
     "Write beside each corner of the curves its angle, as an annotation"},
    {Id::toggle_branches, "toggle-branches", "Branches of the axis",
     "Show or hide the table of the branches of the axis, with histograms of radius and lambda", "Shift+B"},
    {Id::toggle_persistence, "toggle-persistence", "Persistence diagram",
     "Show or hide births and deaths of components and holes while disks about the samples grow, or balls",
     "Shift+G"},
    {Id::toggle_sampling, "toggle-sampling", "Sampling",
     "Show or hide what speaks against the sampling and where, and what can be done about it"},
    {Id::toggle_experiments, "toggle-experiments", "Experiments",
     "Show or hide structures, layers, evolutions and shapes of your own, and what the compiler says of them"},
    {Id::add_experiment, "add-experiment", "Load an experiment...",
     "Compile and load a C++ source with structures of your own; saving it shows the new version"},
    {Id::toggle_legend, "toggle-legend", "Legend", "Show or hide the colour bars of layers with a colour map", "C"},
    {Id::toggle_key, "toggle-key", "Key of layers",
     "Show or hide the names of all visible layers, with a sample of how each is drawn"},
    {Id::toggle_scale_bar, "toggle-scale-bar", "Scale bar",
     "Show or hide a line of a round length, with its length in units of the samples"},
    {Id::toggle_axes, "toggle-axes", "Axes", "Show or hide numbers along the lower and the left edge"},
    {Id::toggle_grid, "toggle-grid", "Grid", "Show or hide faint lines at round numbers, those of the axes", "G"},
    {Id::toggle_annotations, "toggle-annotations", "Annotations",
     "Show or hide text, arrows, dimensions and highlights that were put on the drawing"},
    {Id::put_marks_back, "put-marks-back", "Put legend and scale bar back",
     "Give the legend and the scale bar, where they were dragged, their own places again"},
    {Id::add_pane, "add-pane", "Add a pane",
     "Show the same view once more beside it, with another number type, parameter, family of balls, bundle or "
     "version "
     "of the document; four at most",
     "F6"},
    {Id::close_panes, "close-panes", "Close panes", "Show the main pane alone again", "Shift+F6"},
    {Id::toggle_free_cameras, "toggle-free-cameras", "Free cameras of panes",
     "Let each pane be zoomed and moved by itself; locked again, all show the view of the main one", "Alt+F6"},
    {Id::toggle_differences, "toggle-differences", "Mark differences", "Mark in each pane what not all of them have",
     "Ctrl+F6"},
    {Id::toggle_evolution, "toggle-evolution", "Evolution",
     "Show or hide the slider of evolutions: smooth, subdivide and others, step by step", "E"},
    {Id::toggle_theme, "toggle-theme", "Dark theme",
     "Change between dark and light panels, and the canvas with them unless it has a colour of its own", "Shift+D"},
    {Id::projector_mode, "projector-mode", "Projector mode", "Larger writing and lines, and the strongest contrast",
     "Shift+P"},
    {Id::presenter_mode, "presenter-mode", "Presenter mode",
     "Hide the panels, show the keys that are pressed and a large pointer; bundles are the slides, next and back by "
     "the "
     "Page keys",
     "F5"},
});

constexpr auto kBundleRows = std::to_array<Row>({
    {Id::next_bundle, "next-bundle", "Next bundle",
     "Show the layers as the bundle below has them; in a lesson, go on to its next step", "PageDown"},
    {Id::previous_bundle, "previous-bundle", "Previous bundle",
     "Show the layers as the bundle above has them; in a lesson, go back a step", "PageUp"},
    {Id::balls_inner, "balls-inner", "Inner balls",
     "Balls around the Voronoi vertices inside the curve: show their union where that of others is shown"},
    {Id::balls_polar, "balls-polar", "Polar balls",
     "Balls around the inner poles of samples: show their union where that of others is shown"},
    {Id::balls_own, "balls-own", "Own balls",
     "Balls drawn by you or read from a file: show their union where that of others is shown"},
    {Id::save_bundle, "save-bundle", "Save bundle...", "Save the layers, their order and styles under a name",
     "Ctrl+B"},
    {Id::import_bundles, "import-bundles", "Import bundles...",
     "Add the bundles of a file, .json or the .bnd of 2007 and 2009"},
    {Id::export_bundles, "export-bundles", "Export bundles...", "Write all bundles to a file"},
    {Id::undo_bundles, "undo-bundles", "Undo change of bundles", "Take back the last change of the list of bundles"},
});

constexpr auto kComputeRows = std::to_array<Row>({
    {Id::cancel_computation, "cancel", "Cancel computation", "Stop computing; what is there stays on screen",
     "Ctrl+."},
    {Id::resume_computation, "resume", "Resume computation", "Compute what was cancelled"},
    {Id::hold_update, "hold-update", "Hold the update",
     "Edit while all structures stay as they are; released, they follow at once. W or Alt held while dragging "
     "does the same",
     "Ctrl+H"},
    {Id::precision_naive, "precision-naive", "Naive: plain doubles",
     "Plain doubles everywhere; wrong on degenerate input, to see why it matters"},
    {Id::precision_fast, "precision-fast", "Fast: exact decisions on doubles",
     "Exact decisions on the samples, constructed points rounded to doubles"},
    {Id::precision_exact, "precision-exact", "Exact: rationals",
     "Rational arithmetic for constructed points, roots where they are needed"},
    {Id::precision_exact_roots, "precision-exact-roots", "Exact with roots",
     "Algebraic numbers throughout; slow, the judge of the others"},
    {Id::toggle_union_shortcut, "toggle-union-shortcut", "Certified shortcut for unions",
     "Unions of balls of samples are exact in fast, too, and follow from shared samples where that is certified; "
     "off: the general pipeline in the number type"},
    {Id::toggle_pole_propagation, "toggle-pole-propagation", "Pole labels by propagation",
     "Spread the labels of poles from pole to pole, as Amenta, Choi and Kolluri do; off: by their triangles"},
});

constexpr auto kEvolutionRows = std::to_array<Row>({
    {Id::evolution_first, "evolution-first", "Back to the beginning",
     "Show the samples as they were before the evolution"},
    {Id::evolution_play_back, "evolution-play-back", "Play backwards",
     "Take steps of the evolution back, one after the other"},
    {Id::evolution_back, "evolution-back", "Step back", "Show the state of the evolution before this one",
     "[ Ctrl+Left", always, kRepeats},
    {Id::evolution_stop, "evolution-stop", "Stop the evolution",
     "Stop playing, and give up the step that is being computed"},
    {Id::evolution_forward, "evolution-forward", "Step forward", "Take the next step of the evolution",
     "] Ctrl+Right", always, kRepeats},
    {Id::evolution_play, "evolution-play", "Play the evolution",
     "Take one step after the other, each when the picture of the one before is complete"},
    {Id::evolution_previous, "evolution-previous", "Previous evolution",
     "Choose the evolution before this one, which begins from what is shown", "Ctrl+Up"},
    {Id::evolution_next, "evolution-next", "Next evolution",
     "Choose the evolution after this one, which begins from what is shown", "Ctrl+Down"},
});

constexpr auto kHelpRows = std::to_array<Row>({
    {Id::toggle_lesson, "toggle-lesson", "Steps of the lesson",
     "Show or hide the panel in which a lesson is made: its steps, their order and their captions"},
    {Id::mark_step, "mark-step", "Mark a step",
     "Make a step of the lesson of what is shown now, after the chosen one, or the last one if none is chosen"},
    {Id::present_lesson, "present-lesson", "Present the lesson",
     "Show the steps of the lesson that the session holds, one after the other by the Page keys, with the samples to "
     "be "
     "worked on; Esc ends it and gives back what was there",
     "Shift+F5"},
    {Id::demo, "demo", "Demo", "Play the paper's video, computed live; Esc ends it"},
    {Id::classic_keys, "classic-keys", "Classic Mesecina keys",
     "Use the keys of the program of 2007, or those of this one again; the manual lists what differs"},
    {Id::write_keys, "write-keys", "Write or reread the file of keys",
     "Write a file with all commands and their keys, to be changed by hand; where it is there already, take the keys "
     "from it as it is now"},
    {Id::command_palette, "command-palette", "Find anything...",
     "Find a command, layer, bundle, parameter, evolution, shape or recent file by some letters of its name",
     "Ctrl+Shift+P Ctrl+K"},
    {Id::help, "help", "Keys and gestures", "Show every key", "? F1"},
});

using Table = std::vector<ActionDescriptor>;

std::vector<std::string_view> separated(std::string_view words) {
  std::vector<std::string_view> out;
  while (!words.empty()) {
    out.push_back(words.substr(0, words.find(' ')));
    words.remove_prefix(std::min(out.back().size() + 1, words.size()));
  }
  return out;
}

void add(Table& table, ActionGroup group, std::span<const Row> rows) {
  for (const Row& row : rows)
    table.push_back({row.id, std::string(row.public_id), std::string(row.name), std::string(row.tooltip), group,
                     row.context, row.repeats, separated(row.keys)});
}

void add_nudges(Table& table) {
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
    table.push_back(
        {nth(Id::first_nudge, i),
         "nudge-" + to.name + (is_far ? "-far" : ""),
         "Nudge " + to.name + (is_far ? " by ten" : ""),
         std::string("Move what is selected by ") + (is_far ? "ten pixels" : "one pixel") + " of the screen",
         edit,
         with_selection,
         kRepeats,
         {is_far ? to.far_key : to.key}});
  }
}

void add_bundles(Table& table) {
  constexpr std::string_view kDigits = "123456789";
  constexpr std::array<std::string_view, kNumberedBundles> kOrdinals{"first", "second",  "third",  "fourth", "fifth",
                                                                     "sixth", "seventh", "eighth", "ninth"};
  for (std::size_t i = 0; i < kNumberedBundles; ++i) {
    const std::string_view digit = kDigits.substr(i, 1);
    table.push_back({nth(Id::first_bundle, i),
                     "bundle-" + std::string(digit),
                     "Bundle " + std::string(digit),
                     "Show the layers as the " + std::string(kOrdinals[i]) + " bundle has them",
                     view,
                     always,
                     false,
                     {digit}});
  }
}

Table make_table() {
  Table out;
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
    case Id::snapshot:
    case Id::copy_picture:
    case Id::record:
    case Id::toggle_snap:
    case Id::zoom_in:
    case Id::zoom_out:
    case Id::cancel_computation:
    case Id::resume_computation:
    case Id::hold_update: return true;
    default: return false;
  }
}

std::span<const ActionDescriptor> action_descriptors() {
  static const Table table = make_table();
  return table;
}

const ActionDescriptor& descriptor_of(ActionId id) {
  const ActionDescriptor& found = action_descriptors()[static_cast<std::size_t>(id)];
  MES_ASSERT(found.id == id);
  return found;
}

std::span<const GestureDescriptor> gesture_descriptors() {
  static constexpr std::array<GestureDescriptor, 23> table{{
      {"Wheel", "zoom at the cursor"},
      {"Middle drag, right drag", "pan"},
      {"Space + drag", "pan"},
      {"Click", "select a sample (select tool), add one (insert tool)"},
      {"Click anything drawn",
       "show what it comes from and what it leads to; a sample or a ball that it lies on is selected as well (select "
       "tool)"},
      {"Ctrl + click, Alt + click", "the same for a sample or a ball"},
      {"Double click on a sample", "select its curve"},
      {"Shift + click or box", "add to the selection"},
      {"Ctrl + Shift + click or box", "take out of the selection"},
      {"Drag a sample or a ball", "move it, with the selection it belongs to"},
      {"Drag a handle of the frame",
       "scale, mirror or turn the selection; Shift: about its middle, in steps of 15 degrees"},
      {"W + drag or click, Alt + drag or click",
       "edit, and let all structures follow when the key is released (many window managers take Alt)"},
      {"Drag empty space", "select what the box holds"},
      {"Ctrl + drag empty space", "select what the lasso goes around; add it with Shift at the end"},
      {"Drag with the spray tool", "draw a stroke"},
      {"Drag with the brush", "erase, thin out or refine samples"},
      {"Drag with the ball tool", "draw a ball from its centre"},
      {"Click with the annotation tool", "write words; on a sample or a vertex, with a line to it"},
      {"Drag with the annotation tool", "draw an arrow; from a sample or a vertex, a line to words"},
      {"Drag an annotation", "move it, or one of its ends (annotation tool)"},
      {"Wheel on a selected ball", "change its radius; take it at its centre or its circle"},
      {"Click a number", "type another one, or an expression such as 2/3 or sqrt(2)"},
      {"Drop files on the window", "open them; samples and balls together, bundles besides"},
  }};
  return table;
}

}  // namespace mes
