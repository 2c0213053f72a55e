// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/manual/manual.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>
#include <vector>

#include "app/actions/keymap.h"
#include "app/cli/console/output.h"
#include "app/cli/manual/man_page.h"
#include "app/cli/manual/markdown.h"
#include "app/cli/requests/requests.h"
#include "app/layers/words/verdict_word.h"
#include "app/picture/paper/rich_text.h"
#include "app/store/looks/bundles.h"
#include "app/store/looks/color_maps.h"
#include "app/store/sample_shapes.h"
#include "app/store/texts/layer_text.h"
#include "core/base/geometry/coordinate_range.h"
#include "core/document/settings/parameter.h"
#include "core/evolutions/evolution.h"
#include "core/formula/formula.h"
#include "core/graph/registry.h"
#include "core/graph/structure.h"
#include "core/graph/table_columns.h"
#include "core/io/bundle_file.h"
#include "core/io/format_spec.h"
#include "core/io/session/session.h"
#include "core/io/text/text_numbers.h"
#include "core/shapes/shape.h"

namespace mes::cli {
namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::vector<std::string>>;

// The keys that only the classic keymap has: "`Ctrl+L` Open..., `Ctrl+X` Quit".
std::string classic_keys() {
  const Keymap standard = Keymap::standard();
  const Keymap classic = Keymap::classic();
  std::string out;
  for (const ActionDescriptor& action : action_descriptors())
    for (const std::string& key : classic.keys_of(action.id))
      if (std::ranges::count(standard.keys_of(action.id), key) == 0)
        out += (out.empty() ? "" : ", ") + ("`" + key + "` " + plain(action.name));
  return out;
}

void write_actions(Markdown& page) {
  page.section("Keys and commands of the window");
  page.paragraph(
      "Each command has a key, a place in a menu or a button; `?` shows the keys in the window. `Ctrl+K` finds\n"
      "commands, layers, bundles, parameters, evolutions, shapes, recent files and headings of this manual by some\n"
      "letters of their names, or by another word for them, as \"screenshot\" or \"prune\". *Help > Manual* shows "
      "this\n"
      "text in the window, where Enter goes to the next place with the words in its field.");
  page.paragraph(
      "In dialogs arrow keys go from control to control, or from row to row of a list; the space bar presses the "
      "one\n"
      "that is marked, Enter the default button, and Esc closes the dialog.");
  page.paragraph(
      "The file `$XDG_CONFIG_HOME/mesecina/keys.conf` (`~/.config/mesecina/keys.conf`) gives commands other keys,\n"
      "by lines such as `tool-spray = D Ctrl+Shift+D`: the id of a command, and its keys; none take all keys away.\n"
      "A key is taken from the command that had it. *Help > Write or reread the file of keys* makes that file with "
      "every\n"
      "command in it, and reads one that is there again; it is read when the program starts, too, and lines that "
      "cannot be used are named in one message.");
  page.paragraph(
      "*Help > Classic Mesecina keys* chooses those that the program of 2007 to 2009 had, where they differ:\n" +
      classic_keys() + ". It had no keys for tools, but ways of pressing the mouse; those are as below.");
  for (const ActionGroup group : {ActionGroup::file, ActionGroup::edit, ActionGroup::tools, ActionGroup::view,
                                  ActionGroup::compute, ActionGroup::help}) {
    Rows rows;
    for (const ActionDescriptor& action : action_descriptors())
      if (action.group == group)
        rows.push_back({plain(action.name), code(action.keys), plain(action.tooltip), code(action.public_id)});
    page.subsection(title_of(group));
    page.table({"Command", "Keys", "What it does", "Id"}, rows);
  }
}

void write_gestures(Markdown& page) {
  Rows rows;
  for (const GestureDescriptor& gesture : gesture_descriptors())
    rows.push_back({plain(gesture.input), plain(gesture.meaning)});
  page.section("Gestures");
  page.table({"With the mouse", "What it does"}, rows);
}

void write_layers(const Registry& registry, Markdown& page) {
  page.section("Layers");
  page.paragraph(
      "In the order in which they are stacked at first, the lowest first; dragging rows of the panel restacks\n"
      "them. *Number* is what a colour map can colour by. *Paper*: one of the layers of the paper of 2007.\n"
      "*At start*: shown until you choose otherwise.");
  for (const LayerGroup group : kLayerGroups) {
    Rows rows;
    for (const LayerDescriptor& layer : registry.layers())
      if (layer.group == group && !layer.is_removed)
        rows.push_back({plain(layer.name), code(layer.id), plain(layer.tooltip), plain(layer.scalar),
                        layer.in_paper ? "yes" : "", layer.visible_at_start ? "yes" : ""});
    if (rows.empty()) continue;
    page.subsection(title_of(group));
    page.table({"Layer", "Id", "What it shows", "Number", "Paper", "At start"}, rows);
  }
}

void write_starting_bundles(const Registry& registry, Markdown& page, const fs::path& assets) {
  Rows rows;
  for (const Bundle& bundle : read_starting_bundles(registry.layers(), assets).bundles) {
    std::vector<std::string_view> shown;
    for (const LayerConfiguration::Entry& entry : bundle.layers.layers)
      if (entry.visible) shown.push_back(entry.layer);
    rows.push_back({plain(bundle.name), code(shown)});
  }
  page.section("Bundles to begin with");
  page.paragraph("A bundle is layers, their order and their styles under a name. Layers are given bottom first.");
  page.table({"Bundle", "Layers"}, rows);
}

void write_color_maps(Markdown& page, const fs::path& assets) {
  Rows rows;
  for (const render::ColorMap& map : load_color_maps(assets, {}).maps)
    rows.push_back({code(map.name), std::to_string(map.colors.size()),
                    map.is_categorical ? "for whole numbers, one colour each" : "with all colours between them"});
  page.section("Colour maps");
  page.table({"Map", "Colours", ""}, rows);
}

std::string number_text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

Rows rows_of(std::span<const Parameter> parameters) {
  Rows rows;
  for (const Parameter& parameter : parameters)
    rows.push_back({code(parameter.id), plain(parameter.explanation),
                    fmt::format("{} to {}{}", number_text(parameter.low), number_text(parameter.high),
                                parameter.is_whole ? ", whole" : ""),
                    plain(parameter.unit), number_text(parameter.default_value)});
  return rows;
}

const std::vector<std::string>& parameter_titles() {
  static const std::vector<std::string> titles{"Parameter", "What it does", "Range", "Unit", "Default"};
  return titles;
}

void write_computation(const Registry& registry, Markdown& page) {
  page.section("Number types");
  page.paragraph("Chosen in the status bar, or by `--precision`.");
  Rows rows;
  for (const PrecisionDescriptor& precision : kPrecisionDescriptors)
    rows.push_back({plain(precision.name), code(precision.id), plain(precision.explanation)});
  page.table({"Number type", "Id", "What it means"}, rows);

  page.section("Parameters of the computation");
  page.paragraph("Set in the panel of parameters, or by `--set NAME=VALUE`.");
  page.table(parameter_titles(), rows_of(registry.parameters()));
}

void write_verdict(Markdown& page) {
  page.section("Verdict on the samples");
  page.paragraph(
      "The theorem: if the samples are dense enough, the Voronoi edges that the one-step crust keeps are the medial "
      "axis of the union of the inner balls. The program proves this for the samples at hand with exact arithmetic. "
      "The "
      "light at the right end of the status bar has the result, and its tooltip, the panel of sampling and "
      "`mesecina compute` have the same words.");
  Rows rows;
  for (const TheoremLight light :
       {TheoremLight::green, TheoremLight::yellow, TheoremLight::red, TheoremLight::none}) {
    const VerdictWord word = verdict_word({.light = light}, false, Checking::done);
    rows.push_back({plain(word.word), code(name_of(light)), plain(sentence_of(light)), plain(word.meaning)});
  }
  page.table({"Light", "Id", "In words", "Meaning"}, rows);
  page.paragraph(fmt::format(
      "The verdict also has the epsilon of the samples, the smallest for which each point of the curve has a sample "
      "within epsilon times its local feature size, that is, its distance to the medial axis. Where the curves are "
      "not "
      "known it is estimated from the samples. It is measured for up to {} samples, and for more while the panel of "
      "sampling or the layer `sampling-epsilon` shows it.",
      kMostSamplesMeasuredUnasked));
  page.paragraph(
      "Exempt: at a corner the distance to the medial axis is 0, so no density would be enough there; at the end of "
      "a "
      "curve, or where curves meet, the samples do not tell the distance. Such samples do not count for the epsilon. "
      "The verdict says how many they are, as in \"epsilon 0.241 (2 corners exempt)\".");
}

void write_evolutions(const Registry& registry, Markdown& page) {
  page.section("Evolutions");
  page.paragraph(
      "Steps of a computation that moves the samples or adds some; on the slider of the window, or by\n"
      "`mesecina evolve`.");
  for (const auto& each : registry.evolutions().all()) {
    const EvolutionDescriptor& evolution = each->descriptor;
    page.subsection(evolution.name);
    page.paragraph(fmt::format("{}. Id {}.{}", plain(evolution.tooltip), code(evolution.id),
                               evolution.is_random ? " Random: the seed decides." : ""));
    page.table(parameter_titles(), rows_of(parameters_of(*each)));
  }
}

void write_shapes(const Registry& registry, Markdown& page) {
  page.section("Shapes");
  page.paragraph(
      "What `mesecina shape NAME` makes, with its parameters and their defaults, set by `--set KEY=VALUE`. Curves "
      "are\n"
      "sampled by `--samples`, `--spacing`, or some 400 times; sets of points and balls have as many as `--samples`\n"
      "says. Equal seeds give equal samples. Formulas know t, pi, e, deg (pi / 180), + - * / ^, ?:, comparisons, "
      "and\n" +
      formula_functions_in_words() + '.');
  Rows rows;
  for (const auto& each : registry.shapes().all()) {
    const ShapeDescriptor& shape = *each;
    std::string parameters;
    const auto add = [&](std::string_view id, const std::string& value) {
      parameters += (parameters.empty() ? "" : ", ") + code(std::string(id) + '=' + value);
    };
    for (const Parameter& parameter : shape.parameters) {
      std::string value;
      append_number(value, parameter.default_value);
      add(parameter.id, value);
    }
    for (const FormulaParameter& formula : shape.formulas) add(formula.id, std::string(formula.default_text));
    rows.push_back({plain(shape.name), code(shape.id), plain(shape.explanation), parameters});
  }
  page.table({"Shape", "Id", "What it is", "Parameters"}, rows);
}

void write_structures(const Registry& registry, Markdown& page) {
  page.section("Structures");
  page.paragraph(
      "What is computed, and from what; only what a layer shown needs is. `mesecina compute` gives the counters of\n"
      "each, the panel of statistics shows them. `mesecina export FILE --structure ID --table NAME --format csv` "
      "writes a\n"
      "table, and `--format npy` writes it for NumPy; `mesecina list structures --json` describes all columns. "
      "Positions in\n"
      "the table of a map in degrees are longitude and latitude, unless it has directions as well; lengths are in "
      "metres,\n"
      "or in kilometres if the map is wider than a hemisphere.");
  const StructureSet structures = registry.make_structures();
  Rows rows;
  for (const auto& structure : structures.all()) {
    std::vector<std::string_view> inputs;
    for (const Structure* input : structure->inputs()) inputs.push_back(input->id());
    std::vector<std::string_view> readers;
    for (const LayerDescriptor& layer : registry.layers())
      if (!layer.is_removed && std::ranges::find(layer.structures, structure->id()) != layer.structures.end())
        readers.push_back(layer.id);
    const std::vector<TableColumns> tables = structure->table_columns();
    std::vector<std::string_view> names;
    for (const TableColumns& table : tables) names.push_back(table.name);
    rows.push_back({code(structure->id()), code(inputs), code(readers), code(names)});
  }
  page.table({"Structure", "Made from", "Read by the layers", "Tables"}, rows);
}

// Made by the program itself, so that the examples are valid.
Session example_session() {
  SampleData data;
  data.positions = {{0, 0}, {4, 0}, {2, 3}};
  data.contours = {{true, {0, 1, 2}}};
  Session out;
  out.title = "Triangle";
  out.data = std::make_shared<const SampleData>(std::move(data));
  out.entries = {TimelineEdit{.name = "Move", .moved = {{2, {2, 3.5}}}},
                 TimelineEdit{.name = "Annotate",
                              .annotations = Annotations{{.kind = AnnotationKind::leader,
                                                          .text = "top",
                                                          .anchors = {{.at = {2, 3.5}, .samples = {2}}},
                                                          .shift = {22, -22}}}},
                 TimelineEdit{.name = "Insert", .inserted = {{1, 2}}}, Undone{}};
  out.lesson = {"Three samples",
                {{.caption = "# Before\n\nA **triangle**"},
                 {.caption = "# After\n\nOne corner of $P$ has moved", .position = 2, .seconds = 5.0}}};
  return out;
}

Bundle example_bundle(const Registry& registry) {
  const LayerIndex layer = registry.find_layer("medial-axis");
  const LayerStyle style = layer == kNoLayer ? LayerStyle() : registry.layers()[layer].style;
  return {.name = "Axis alone", .layers = {.layers = {{.layer = "medial-axis", .visible = true, .style = style}}}};
}

void write_formats(const Registry& registry, Markdown& page) {
  page.section("Files");
  Rows rows;
  for (const auto& each : registry.formats().all()) {
    const FormatDescriptor& format = each->descriptor;
    rows.push_back({plain(format.name), code(format.id),
                    code(std::vector<std::string_view>(format.extensions.begin(), format.extensions.end())),
                    format.can_read ? "yes" : "", format.can_write ? "yes" : ""});
  }
  page.table({"Format of samples", "Id", "Names end in", "Read", "Written"}, rows);
  page.paragraph(
      "The format is found by what a file holds, then by its name; `--from ID` overrides both. Files appear\n"
      "complete or not at all.");
  page.paragraph(
      "Lengths have the unit of the file where it has one: an SVG that of the width and height of its page (mm, cm, "
      "in "
      "or pt), otherwise px of 1/96 inch; a DXF that of `$INSUNITS`; Ipe pt; a map that of its plane. Scale bar, "
      "status "
      "bar, `compute` and the totals of centre lines have it, and sessions and POFF (`# unit mm`) keep it.");

  page.subsection("Geometry of layers");
  Rows exported;
  for (const LayerTextFormat& format : layer_text_formats())
    exported.push_back({plain(format.title), code(format.name), plain(format.help), format.is_of_many ? "yes" : ""});
  page.table({"Format", "Id", "What `mesecina export` writes", "Several layers"}, exported);
  Rows columns;
  for (const PrimitiveKind kind : kAllPrimitiveKinds)
    columns.push_back({std::string(name_of(kind)), code(csv_columns(kind))});
  page.paragraph(
      "CSV has a column `kind` where a layer has several kinds of primitives, and `scalar` where it has one. The\n"
      "header names the columns of one kind; the others fill the same places. A ray begins at `x,y` and a line goes\n"
      "through it; `dx,dy` is a direction, of no particular length, where a segment has its other end. Angles of "
      "arcs\n"
      "are radians, counter-clockwise.");
  page.table({"Kind", "What the columns of a line are"}, columns);
  page.paragraph(
      "Coordinates are those of the document, with all their digits. Of a map GeoJSON is in longitude and latitude "
      "on\n"
      "WGS 84, CSV and WKT in the coordinate system of the map; radii, directions and angles are in the plane, which "
      "is\n"
      "in metres for a map in degrees. GeoJSON and WKT have no circles: a circle, a disk\n"
      "or an arc has 96 sides a turn there, and GeoJSON names its centre and radius. Chains of GeoJSON have the "
      "scalar\n"
      "of each of their segments. An arc of a parabola is a quadratic Bézier curve with the control point `xc,yc`: a "
      "curve\n"
      "in `svg-path` too, and sides within 1/1024 of the distance from its focus elsewhere. Rays and lines are in\n"
      "`csv` alone; elsewhere they are left out, with a message.");

  page.subsection("The range of coordinates");
  page.paragraph(
      "Whatever brings them, files, sessions, tools or evolutions:\n" + std::string(coordinate_range_in_words()) +
      ".\nBinary exponents are compared, which differ by at most 100, so that a little more than 2^100 may pass. "
      "What is\n"
      "out of range is refused with its place, and never changed. In the window, and in the steps of an evolution, "
      "a\n"
      "coordinate that is too small beside the others becomes 0.\n"
      "Inside the range all lengths, radii and positions are finite, and decisions about samples exact. Areas are\n"
      "finite as long as no coordinate is above 2^180 (1e54); beyond that the disk of a very flat triangle may be "
      "larger\n"
      "than any double. Multiplied by a power of two that stays in range, an input gives the same picture multiplied "
      "by\n"
      "it.");

  page.subsection("POFF and WPOFF");
  page.paragraph(
      "`POFF n 0 0`, then x and y of each of n points; `WPOFF n 0 0`, then x, y and radius of each of n balls. "
      "White\n"
      "space is free: numbers may be spread over lines in any way, `#` begins a comment. But lines that all have "
      "another\n"
      "number of columns, such as three in POFF, are an error; so is a line that stands out where each other line "
      "is\n"
      "one point.");

  page.subsection("Sessions");
  page.paragraph(
      "One JSON object: the data as they were opened, everything that happened since, and how they are looked at.\n"
      "`samples` holds x and y in turn, `balls` x, y and radius; `points` of a contour are numbers of samples, from\n"
      "0. Entries of the timeline name samples and balls by the order in which they came into being. Each place of "
      "an\n"
      "annotation is `at` x and y, or `follows` a sample, or the centre of the circle through three, or `balls`: "
      "the\n"
      "centre of one, the crossing of two on the left of the way from the first to the second, or with `along` the "
      "place "
      "of equal power\n"
      "on the line of their centres, shifted by that multiple of the way between them, the place of equal power of\n"
      "three, or a place on the bisector of the crossings of the first two and the last two, `along` it by a "
      "multiple of their\n"
      "distance; `scales` multiplies the radii. Keys and entries that are not known are skipped. A kind of "
      "annotation that is\n"
      "not known is refused, as it would have to be undone, and `schema` is 2 where there are highlights or places "
      "on balls, 1\n"
      "otherwise. A file with a greater one is refused. A `lesson` has steps: a caption, the number of entries of "
      "the timeline that are done "
      "(`position`),\n"
      "and, where they differ from what the timeline says there, `layers`, `settings` and `view`, as in the "
      "session.\n"
      "A small one, without layers:");
  page.block(write_session(example_session()), "json");

  page.subsection("Bundles");
  page.paragraph(
      "One JSON object with a list of bundles, layers bottom first. `.bnd` files of the Mesecina of 2007 and 2009 "
      "are\n"
      "read, not written.");
  const Bundle bundle = example_bundle(registry);
  page.block(write_bundles({&bundle, 1}), "json");

  page.subsection("Maps of one's own");
  page.paragraph(
      "A file `NAME.map` in `colormaps` of the data folder: triples `red green blue`, numbers from 0 to 1, two "
      "triples\n"
      "at least; `#` begins a comment. Colours between them are interpolated.");
  page.block("0 0 0.5   # dark blue\n1 1 0     # yellow\n");

  page.subsection("Where things are kept");
  page.table({"What", "Where"},
             {{"Bundles, colour maps, unsaved work", "`$XDG_DATA_HOME/mesecina`, or `~/.local/share/mesecina`"},
              {"Settings of the window", "`$XDG_CONFIG_HOME/mesecina`, or `~/.config/mesecina`"},
              {"Shapes, fonts and maps of the program",
               "`assets` beside the program or `../share/mesecina`; `$MESECINA_ASSETS` overrides both"}});
}

void write_annotations(Markdown& page) {
  page.section("Words of annotations");
  page.paragraph(
      "Annotations are written in a small part of LaTeX. Pictures, PDF and SVG have them laid out by the program; "
      "TikZ\n"
      "and Ipe get the source for TeX, with nothing in it but what is listed here. Other commands are shown as they\n"
      "stand, with a message.");
  page.table({"Source", "Meaning"},
             {{"`$...$`", "mathematics: letters in italics, relations with space around them"},
              {"`x_1`, `x^2`, `x_{ij}^{2}`", "sub- and superscripts, within mathematics"},
              {"`\\textbf{}`, `\\textit{}`, `\\emph{}`", "bold, italics"},
              {"`\\mathrm{}`, `\\text{}`", "upright letters, within mathematics"},
              {"`\\\\`, a new line", "another line"},
              {"`\\$`, `\\%`, `\\&`, `\\#`, `\\_`, `\\{`, `\\}`", "the sign itself"},
              {"`\\value`", "what a dimension measures, in four digits; a dimension without words shows it alone"}});
  std::string signs;
  for (const RichSign& sign : rich_text_signs())
    signs += (signs.empty() ? "`\\" : ", `\\") + std::string(sign.command) + "` " + std::string(sign.sign);
  page.paragraph(signs + ".");
}

void write_lessons(Markdown& page) {
  page.section("Captions of lessons");
  page.paragraph(
      "`mesecina lesson` puts the steps of a session's lesson on pages. Captions are written in a small part of\n"
      "Markdown; all else is shown as it stands.");
  page.table({"Source", "Meaning"}, {{"`# A`, `## A`, `### A`", "a heading; the first one is the name of the step"},
                                     {"an empty line", "ends a paragraph; other ends of lines are spaces"},
                                     {"`- A`", "a list"},
                                     {"`**A**`, `*A*`", "bold, italics"},
                                     {"`$...$`", "mathematics, as in annotations"},
                                     {"`\\*`, `\\$`, `\\#`, `\\-`, `\\_`, `\\\\`", "the sign itself"}});
}

void write_commands(Markdown& page, std::span<const CommandHelp> commands) {
  page.section("Command line");
  page.paragraph(
      "Results go to standard output or to the file named by `-o`, everything else to standard error, in lines of\n"
      "the form `mesecina: FILE:LINE:COLUMN: what is wrong`.");
  for (const CommandHelp& command : commands) {
    page.subsection(command.name);
    page.block(command.page);
  }
}

}  // namespace

Expected<void> run_manual(const Registry& registry, const ManualRequest& request,
                          std::span<const CommandHelp> commands, Interruption& interruption) {
  if (auto good = check_output(request.output); !good) return good;
  if (request.as_man_page) return write_output(request.output, man_page(commands), interruption);
  const fs::path assets = find_assets({});
  if (const std::string message = read_starting_bundles(registry.layers(), assets).message; !message.empty())
    return std::unexpected(Error{ErrorCode::bad_input, message});
  return write_output(request.output, manual_text(registry, commands, assets), interruption);
}

std::string manual_text(const Registry& registry, std::span<const CommandHelp> commands, const fs::path& assets) {
  Markdown page("Mesecina: the manual");
  page.introduction(
      "Everything that has a name, written by `mesecina manual` from the tables that the program works with. For a\n"
      "first walk through the window see the [README](../README.md).");
  write_actions(page);
  write_gestures(page);
  write_layers(registry, page);
  write_starting_bundles(registry, page, assets);
  write_color_maps(page, assets);
  write_computation(registry, page);
  write_verdict(page);
  write_evolutions(registry, page);
  write_shapes(registry, page);
  write_structures(registry, page);
  write_formats(registry, page);
  write_annotations(page);
  write_lessons(page);
  write_commands(page, commands);
  return page.text();
}

}  // namespace mes::cli
