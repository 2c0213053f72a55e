// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <optional>
#include <system_error>

#include "app/cli/command_help.h"
#include "app/cli/command_options.h"
#include "app/cli/manual.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/picture_request.h"
#include "app/cli/requests.h"
#include "app/cli/style_request.h"
#include "app/export/page_size.h"
#include "app/store/layer_text.h"
#include "core/base/assert.h"
#include "core/base/coordinate_range.h"
#include "core/io/format.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

std::string help_of_export_formats() {
  std::string out;
  for (const LayerTextFormat& format : layer_text_formats()) {
    if (!out.empty()) out += ";\n";
    out += fmt::format("{}: {}", format.name, format.help);
  }
  return out;
}

constexpr const char* kExamples = R"(Examples:
  mesecina shape.poff
  mesecina compute shape.poff --layers medial-axis,curve
  mesecina render shape.poff --layers interior-voronoi-disks,curve,medial-axis,points -o shape.png
  mesecina export shape.poff --layer medial-axis --format csv -o axis.csv
  mesecina evolve shape.poff --evolution smooth --steps 12 -o smooth.poff
  mesecina list layers

Exit codes: 0 done, 1 could not be completed, 2 usage, 3 bad input, 4 output impossible (or no display), 130 interrupted.)";

/// Everything the parser fills in.
struct Arguments {
  std::vector<std::string> files;
  ComputeRequest compute;
  SweepRequest sweep;
  BranchesRequest branches;
  PersistenceRequest persistence;
  ResampleRequest repair;
  ResampleRequest decimate;
  ExportRequest exported;
  RenderRequest render;
  PlayRequest play;
  DemoRequest demo;
  LessonRequest lesson;
  EvolveRequest evolve;
  ShapeCommand shape;
  SampleRequest sample;
  TextCommand text;
  ListRequest list;
  ManualRequest manual;
  CompletionsRequest completions;
};

/// In lines of some hundred characters, all but the first indented.
std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t kWidth = 100;
  std::string out;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column + end > kWidth) {
      out.back() = '\n';
      out.append(indent, ' ');
      column = indent;
    }
    out.append(text.substr(0, end)) += ' ';
    column += end + 1;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  out.pop_back();
  return out;
}

/// What is read, and how; into `file`, `from` and `reading` of the request.
template <class Request>
void add_input(CLI::App& command, Request& request) {
  command.add_option("FILE", request.file, "Samples to read, or - for standard input")->required();
  command.add_option("--from", request.from,
                     "Format of the input, when it is not to be found out (" + ids_of(format_descriptors()) + ")");
  add_reading(command, request.reading);
}

void add_source(CLI::App& command, Source& source) {
  add_input(command, source);
  command.add_option("--precision", source.precision,
                     "Number type: " + ids_of(kPrecisionDescriptors) + "; default: fast");
  command
      .add_option("--set", source.settings,
                  "Set a parameter, NAME=VALUE (mesecina list parameters);\nmay be repeated")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// "one-column (84mm), ...".
std::string page_preset_words() {
  std::string out;
  for (const PagePreset& preset : page_presets())
    out += (out.empty() ? "" : ", ") + std::string(preset.name) + " (" + std::string(preset.size) + ')';
  return out;
}

/// ".png, .svg, ...".
std::string picture_extension_words() {
  std::string out(kPixelExtension);
  for (const figure::Format& format : figure::formats()) out += ", " + std::string(format.extension);
  return out;
}

/// What stands on a picture to explain it.
template <class Request>
void add_explanations(CLI::App& command, Request& to) {
  command.add_flag("--legend,!--no-legend", to.with_legend,
                   "With a colour map: whether its colour bar is drawn; default: yes");
  command.add_flag("--key", to.with_key, "With all layers in the legend, and a sample of how each is drawn");
  command.add_flag("--scale-bar", to.marks.bar,
                   "A line of a round length, with its length in the units of the samples");
  command.add_flag("--axes", to.marks.axes, "Numbers along the lower and the left edge");
  command.add_flag("--grid", to.marks.grid, "Faint lines at round numbers, those of the axes");
  command.add_flag("!--no-annotations", to.with_annotations,
                   "Leave out text, arrows, dimensions and highlights that a session holds");
}

/// An option whose value is a place; `to` gets it.
CLI::Option* add_place(CLI::App& command, const std::string& name, std::function<void(const PaperPlace&)> to,
                       const std::string& explanation) {
  return command.add_option_function<std::string>(
      name,
      [name, to = std::move(to)](const std::string& text) {
        const auto place = parse_place(text);
        if (!place)
          throw CLI::ValidationError(name + " expects " + one_of(place_corners()) +
                                     ", and perhaps millimetres from there to 5080, as in top-left:5,7.5, not " +
                                     in_quotes(text));
        to(*place);
      },
      explanation);
}

void add_places(CLI::App& command, RenderRequest& to) {
  add_place(
      command, "--legend-at", [&to](const PaperPlace& place) { to.legend_at = place; },
      "Where the legend stands, CORNER or CORNER:XMM,YMM: top-left, top-right,\n"
      "bottom-left or bottom-right, so many millimetres from its sides (of 96\n"
      "pixels an inch, times --scale); default: the corner where it hides least");
  add_place(
      command, "--scale-bar-at",
      [&to](const PaperPlace& place) {
        to.marks.bar = true;
        to.marks.bar_at = place;
      },
      "With a scale bar there, as for --legend-at");
}

void add_title(CLI::App& command, std::string& title) {
  command.add_option("--title", title,
                     "Words above the drawing, with as much LaTeX as annotations have:\n"
                     "\"Crust of $\\varepsilon$-samples\"");
}

void add_film(CLI::App& command, FilmRequest& film) {
  command.add_option("--frames", film.frames, "Folder for the pictures 00001.png ... and manifest.json");
  command.add_option("--video", film.video, "A video, .mp4 or .webm; needs ffmpeg");
  command.add_option("--size", film.size, "Width and height in pixels, WxH")->capture_default_str();
  command.add_option("--fps", film.fps, "Pictures a second, 1 to 120")->capture_default_str();
  add_explanations(command, film);
  command.add_flag("!--no-source", film.with_source,
                   "Leave the session out of manifest.json: with it the manifest can be given\n"
                   "as FILE");
  add_title(command, film.title);
  command.add_option("--shard", film.shard,
                     "I/N: only every Nth picture, beginning with the Ith, under the same names");
}

void describe_commands(CLI::App& app, Arguments& to) {
  app.name("mesecina");
  app.description(
      "Sample-based geometry in the plane, live: Delaunay, Voronoi, one-step crust, inner balls, medial axis.\n"
      "With FILEs or nothing it opens the window; every result can also be had without one.");
  app.set_version_flag("--version", "mesecina " MESECINA_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.add_option("FILE", to.files, "Samples to open in the window");
  app.option_defaults()->always_capture_default(false);
  app.require_subcommand(0, 1);

  CLI::App* const compute = app.add_subcommand("compute", "Counts and measures of structures and layers, as JSON");
  add_source(*compute, to.compute.source);
  compute->add_option("--layers", to.compute.layers,
                      "Comma list of layer ids (mesecina list layers), or all;\n"
                      "default: those visible at start");
  compute->add_flag("!--no-timing", to.compute.with_timing, "Leave out times: equal input gives equal bytes");
  compute->add_flag("--digest", to.compute.with_digests,
                    "Add a digest to each layer: a function of what it draws, equal to that of `play`");
  compute->add_option("-o,--output", to.compute.output, "Write to this file instead of standard output");
  add_force(*compute, to.compute.force);

  CLI::App* const sweep =
      app.add_subcommand("sweep", "Counts and measures while a parameter goes through its values, as CSV");
  add_source(*sweep, to.sweep.source);
  sweep
      ->add_option("--parameter", to.sweep.parameter,
                   "NAME=FROM..TO, as in lambda-limit=0..20 (mesecina list parameters)")
      ->required();
  sweep->add_option("--steps", to.sweep.steps, "How many steps from the first value to the last, both of them shown")
      ->required();
  sweep->add_option("--layers", to.sweep.layers,
                    "Comma list of layer ids (mesecina list layers), or all;\n"
                    "default: those visible at start");
  sweep->add_option("-o,--output", to.sweep.output, "Write to this file instead of standard output");
  add_force(*sweep, to.sweep.force);
  sweep->footer(
      "One line for each value; the columns are the numbers that `compute` gives for these layers and their "
      "structures.");

  CLI::App* const branches = app.add_subcommand("branches", "The branches of an axis with their measures, as CSV");
  add_source(*branches, to.branches.source);
  branches
      ->add_option("--layer", to.branches.layer,
                   "Which axis: medial-axis, lambda-medial-axis, angle-medial-axis or\n"
                   "cover-medial-axis, whose limits are parameters")
      ->capture_default_str();
  branches->add_option("-o,--output", to.branches.output, "Write to this file instead of standard output");
  add_force(*branches, to.branches.force);
  branches->footer(
      "One line for each branch, the longest first: its ends (leaf, junction, cut by the filter, or none of a loop "
      "or a "
      "point),\n"
      "length, radius of its balls, and the largest lambda and object angle in degrees. Lengths add up to the "
      "layer's.");

  CLI::App* const persistence = app.add_subcommand(
      "persistence", "Births and deaths of components and holes of growing disks or balls, as CSV");
  add_source(*persistence, to.persistence.source);
  persistence
      ->add_option("--of", to.persistence.of,
                   "What grows: samples, as disks of one radius; or the inner, polar or own balls, where\na ball of "
                   "radius r has the radius sqrt(r^2 + a^2) at a growth of a")
      ->capture_default_str();
  persistence->add_option("-o,--output", to.persistence.output, "Write to this file instead of standard output");
  add_force(*persistence, to.persistence.force);
  persistence->footer(
      "One line for each class of the alpha complexes of the samples, the longest first: dimension (0: component,\n"
      "1: hole), radii of birth and death, the sample of the component or the centre of the circle that fills the\n"
      "hole, and the edge that joins or closes. What stays has no death. Of balls, births and deaths are growths;\n"
      "those below 0 are of what the balls have before they grow.");

  const auto add_resampling = [](CLI::App& command, ResampleRequest& request, const char* epsilon) {
    add_input(command, request);
    command.add_option("--epsilon", request.epsilon, epsilon)->capture_default_str();
    command.add_option("-o,--output", request.output, "Write to this file instead of standard output");
    add_force(command, request.force);
  };
  CLI::App* const repair = app.add_subcommand("repair", "Samples inserted where the curve has too few of them");
  add_resampling(*repair, to.repair,
                 "Curve edges are halved while half their length is more than this part of the\n"
                 "distance of their ends to the axis; above 0, at most 1");
  repair->footer(
      "New samples lie on a spline through the others, interrupted at corners. What was done is said on standard\n"
      "error, and what could not be: no number of samples is dense enough at a corner.");
  CLI::App* const decimate =
      app.add_subcommand("decimate", "Samples taken away that the curve and the topology of the axis do not need");
  add_resampling(*decimate, to.decimate,
                 "The rest is to have, along the curve, half the distance of neighbours at most this\n"
                 "part of their distance to the axis; above 0, at most 1");
  decimate->footer(
      "The curve goes through the rest in the same order, and the axis has as many components and cycles as before.");

  CLI::App* const exported = app.add_subcommand("export", "The geometry of layers, as text");
  add_source(*exported, to.exported.source);
  exported
      ->add_option("--layer", to.exported.layer,
                   "Layer id (mesecina list layers);\nfor geojson, wkt and svg-path also a comma list, or all")
      ->required();
  exported->add_option("--format", to.exported.format, help_of_export_formats())->required();
  exported->add_option("-o,--output", to.exported.output, "Write to this file instead of standard output");
  add_force(*exported, to.exported.force);

  CLI::App* const render =
      app.add_subcommand("render", "A picture of layers, in pixels or as vector graphics; needs no display");
  add_source(*render, to.render.source);
  render->add_option("--layers", to.render.layers,
                     "Comma list of layer ids, or all; default: those of the session, if FILE\n"
                     "is one or carries one, and else those visible at start.\n"
                     "They are drawn in the order of mesecina list layers, the first at\n"
                     "the bottom, however they are listed here");
  render
      ->add_option("--bundle", to.render.bundle,
                   "Layers, their order and their styles as in a bundle: its name\n"
                   "(mesecina list bundles) or a file of bundles, .json or .bnd, of which\n"
                   "the first is taken, or that of FILE:NAME")
      ->excludes("--layers");
  CLI::Option* const size = render
                                ->add_option("--size", to.render.size,
                                             "Width and height in pixels, WxH; in vector formats a pixel is\n"
                                             "1/96 inch")
                                ->capture_default_str();
  render
      ->add_option("--figure-size", to.render.figure_size,
                   "Size of a vector format on paper: WxH, or a width to which the height\n"
                   "follows, with units mm, cm, in, pt or px, as in 84mmx60mm;\n"
                   "or " +
                       page_preset_words())
      ->excludes(size);
  render->add_option("--bounds", to.render.bounds, "Of a vector format: view, or tight to cut it to what is drawn")
      ->capture_default_str();
  render->add_option("--rasterize", to.render.rasterized,
                     "Layers that become pictures in a vector format: of thousands of shapes\n"
                     "a picture is smaller");
  render->add_option("--dpi", to.render.dpi, "Dots an inch of these pictures, from 10 to 2400")
      ->capture_default_str();
  render->add_option("--view", to.render.view,
                     "fit, or X0,Y0,X1,Y1: two corners of what must be seen. fit shows the\n"
                     "samples and the layers that count for it, with a margin of 5 %;\n"
                     "default: what the session shows, and else fit");
  render
      ->add_option("--scale", to.render.scale,
                   "Factor for line widths and point sizes, as for a denser screen;\n"
                   "dots of samples shrink where they would run together")
      ->capture_default_str();
  render->add_option("--background", to.render.background, "RRGGBB, or transparent (none)")->capture_default_str();
  render
      ->add_option("--set-style", to.render.styles,
                   "Change the style of a layer, LAYER:KEY=VALUE[,KEY=VALUE...]; may be repeated.\n"
                   "Keys: " +
                       style_keys() +
                       ".\n"
                       "point-size and line-width are in pixels, or on paper with a unit, as in\n"
                       "0.5pt; color-map is the name of a map (mesecina list color-maps) or none,\n"
                       "range is LOW:HIGH or fit; dashed, flat and thin-when-dense are on or off")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* const compare =
      render->add_option("--compare", to.render.compared,
                         "Panes side by side, WHAT=VALUE,VALUE[,VALUE...]: precision, family (a, p,\n"
                         "b: the layers of these balls), bundle, step (of --evolution), or a\n"
                         "parameter (mesecina list parameters), as in precision=naive,exact.\n"
                         "All panes show the same part of the plane, unless --free-cameras is given");
  render
      ->add_flag("--free-cameras", to.render.has_free_cameras,
                 "Show in each pane all that is in it, each at a scale of its own")
      ->needs(compare);
  render->add_flag("--differences", to.render.with_differences, "Mark what only some of the panes have")
      ->needs(compare);
  render
      ->add_option("--evolution", to.render.evolution,
                   "Evolution of --compare step=..., NAME or NAME:KEY=VALUE[,KEY=VALUE...] with\n"
                   "its parameters and seed (mesecina list evolutions, parameters)")
      ->needs(compare);
  render->add_option("--image", to.render.image,
                     "A picture (PNG, JPEG, BMP, PGM) below everything else (the layer image), FILE or\n"
                     "FILE:X,Y,WIDTH: its centre and width in the units of the samples;\n"
                     "without them it is laid into the box around the samples");
  add_explanations(*render, to.render);
  add_places(*render, to.render);
  add_title(*render, to.render.title);
  render->add_flag("!--no-source", to.render.with_source,
                   "Leave out of the picture what it is of: without this PNG, SVG, PDF and\n"
                   "Ipe files hold samples, view and layers, and can be given as FILE");
  render->add_option("--to", to.render.format,
                     "Format of the picture: " + one_of(picture_formats()) +
                         "; default: as the\n"
                         "name of the output says, and png for standard output");
  render
      ->add_option("-o,--output", to.render.output,
                   "The picture, " + picture_extension_words() + "; - for standard output")
      ->required();
  add_force(*render, to.render.force);

  CLI::App* const play = app.add_subcommand("play", "What happened in a session, once more, step by step");
  play->add_option("SESSION", to.play.session, "A saved session, .json, or - for standard input")->required();
  add_film(*play, to.play.film);
  play->footer("Without --frames and --video: one line of JSON a step, with digests of document and layers.");

  CLI::App* const demo = app.add_subcommand(
      "demo", "The paper's video: the one-step axis, the general pipeline, smoothing; needs no display");
  add_film(*demo, to.demo.film);

  CLI::App* const lesson =
      app.add_subcommand("lesson", "The steps of a lesson, listed or as slides; needs no display");
  lesson
      ->add_option("LESSON", to.lesson.file,
                   "A session with a lesson, .json or a file that carries it, - for standard\ninput, or the name of "
                   "one that comes with the program\n(mesecina list lessons)")
      ->required();
  lesson->add_option("--pdf", to.lesson.pdf, "Slides as vector graphics, a page a step; - for standard output");
  lesson->add_option(
      "--html", to.lesson.html,
      "Slides in one file for a browser, with keys and nothing from elsewhere;\n- for standard output");
  lesson->add_option("--frames", to.lesson.frames, "Folder for a picture a step, 00001.png ..., and manifest.json");
  lesson->add_option("--video", to.lesson.video,
                     "A video that shows each step for its seconds, .mp4 or .webm; needs ffmpeg");
  lesson->add_option("--vtt", to.lesson.vtt,
                     "The captions with the times of the steps, as WebVTT; - for standard output");
  lesson->add_option("--size", to.lesson.size, "Width and height of these pictures in pixels, WxH")
      ->capture_default_str();
  lesson->add_option("--steps", to.lesson.steps, "Only these steps, as in 2-4 or 1,3-5; default: all");
  lesson
      ->add_option("--figure-size", to.lesson.figure_size,
                   "Size of a page of PDF and HTML: WxH, with units mm, cm, in, pt or px, as in 297mmx210mm;\n"
                   "or " +
                       page_preset_words())
      ->capture_default_str();
  lesson->add_option("--scale", to.lesson.scale, "Factor for line widths and point sizes of drawings")
      ->capture_default_str();
  lesson->add_option("--background", to.lesson.background, "RRGGBB, or transparent (none)")->capture_default_str();
  add_explanations(*lesson, to.lesson);
  lesson->add_flag("!--no-source", to.lesson.with_source,
                   "Leave the session out of the PDF, and of manifest.json of the frames: with it\n"
                   "the PDF can be given as LESSON");
  add_force(*lesson, to.lesson.force);
  lesson->footer("Without an output: one line a step, with its number, how long it is to be shown, and its name.");

  CLI::App* const evolve = app.add_subcommand("evolve", "Samples after some steps of an evolution, as POFF");
  evolve->add_option("FILE", to.evolve.file, "Samples to read, or - for standard input")->required();
  evolve->add_option("--from", to.evolve.from,
                     "Format of the input, when it is not to be found out (" + ids_of(format_descriptors()) + ")");
  add_reading(*evolve, to.evolve.reading);
  evolve->add_option("--evolution", to.evolve.evolution, "Evolution id (mesecina list evolutions)")->required();
  evolve->add_option("--steps", to.evolve.steps, "How many steps")->required();
  evolve->add_option("--seed", to.evolve.seed, "Of the random numbers, where an evolution draws any")
      ->capture_default_str();
  evolve
      ->add_option("--set", to.evolve.settings,
                   "Set a parameter of evolutions, NAME=VALUE (mesecina list\nparameters); may be repeated")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  evolve->add_option("-o,--output", to.evolve.output, "Write to this file instead of standard output");
  add_force(*evolve, to.evolve.force);

  CLI::App* const shape = describe_shape(app, to.shape);
  CLI::App* const sample = describe_sample(app, to.sample);
  CLI::App* const text = describe_text(app, to.text);

  CLI::App* const list = app.add_subcommand("list", "What there is to name");
  std::string things;
  for (const std::string& thing : listed_things()) things += (things.empty() ? "" : "|") + thing;
  list->add_option("WHAT", to.list.what, things)->required();
  list->add_flag("--json", to.list.as_json, "As JSON");

  CLI::App* const manual =
      app.add_subcommand("manual", "All keys, layers, parameters, formats, commands: as Markdown");
  manual->add_flag("--man", to.manual.as_man_page, "The commands and keys as a man page instead");
  manual->add_option("-o,--output", to.manual.output, "Write to this file instead of standard output");

  CLI::App* const completions =
      app.add_subcommand("completions", "A script that completes commands and options in a shell");
  completions->add_option("SHELL", to.completions.shell, "bash, zsh or fish")->required();
  completions->add_option("-o,--output", to.completions.output, "Write to this file instead of standard output");

  for (CLI::App* const command : {compute, sweep, branches, persistence, repair, decimate, exported, render, play,
                                  demo, lesson, evolve, shape, sample, text, list, manual, completions})
    command->set_help_flag("-h,--help", "Print this help and exit");
  // An empty value is most likely an unset variable of a script, and never the same as no option.
  const auto is_not_empty = [](const std::string& value) { return std::string(value.empty() ? "is empty" : ""); };
  for (CLI::App* const command : app.get_subcommands({}))
    for (CLI::Option* const option : command->get_options())
      if (option->get_expected_max() > 0) option->check(is_not_empty);
  name_values(app);
  // At the end, or each command would have it too.
  app.footer(std::string(kExamples) + "\n\nInput: " + wrapped(coordinate_range_in_words(), 7));
}

/// The program itself first, then its commands.
std::vector<CommandHelp> all_commands() {
  // Parsing changes what a parser says of its defaults, so this is one that has parsed nothing.
  CLI::App app;
  Arguments arguments;
  describe_commands(app, arguments);
  return help_of(app);
}

Expected<void> run_command(const CLI::App& command, const Arguments& arguments) {
  Interruption interruption;
  const auto run = [&](const auto& request, auto function) -> Expected<void> {
    if (const auto good = settings_of(request.source, true); !good) return std::unexpected(good.error());
    return function(request, interruption);
  };
  if (command.get_name() == "compute") return run(arguments.compute, run_compute);
  if (command.get_name() == "sweep") return run(arguments.sweep, run_sweep);
  if (command.get_name() == "branches") return run(arguments.branches, run_branches);
  if (command.get_name() == "persistence") return run(arguments.persistence, run_persistence);
  if (command.get_name() == "repair") return run_repair(arguments.repair, interruption);
  if (command.get_name() == "decimate") return run_decimate(arguments.decimate, interruption);
  if (command.get_name() == "export") return run(arguments.exported, run_export);
  if (command.get_name() == "render") return run(arguments.render, run_render);
  if (command.get_name() == "demo") return run_demo(arguments.demo, interruption);
  if (command.get_name() == "lesson") return run_lesson(arguments.lesson, interruption);
  if (command.get_name() == "play") return run_play(arguments.play, interruption);
  if (command.get_name() == "evolve") return run_evolve(arguments.evolve, interruption);
  if (command.get_name() == "shape") return run_shape(arguments.shape, interruption);
  if (command.get_name() == "sample") return run_sample(arguments.sample, interruption);
  if (command.get_name() == "text") return run_text(arguments.text, interruption);
  if (command.get_name() == "manual") return run_manual(arguments.manual, all_commands(), interruption);
  if (command.get_name() == "completions")
    return run_completions(arguments.completions, all_commands(), interruption);
  return run_list(arguments.list, interruption);
}

/// What CLI11 says, in one line and with the way to more.
int refuse(const CLI::App& app, const std::string& text) {
  std::string line = text;
  std::ranges::replace(line, '\n', ' ');
  while (line.ends_with(' ') || line.ends_with('.')) line.pop_back();
  std::string command = "mesecina";
  for (const CLI::App* chosen : app.get_subcommands()) command += ' ' + chosen->get_name();
  return report({ErrorCode::usage, line + "; see " + command + " --help", {}, 0, 0});
}

/// For a first word that is not a file, does not look like the name of one, and is nearly a command: that command.
std::optional<Error> mistaken_command(const CLI::App& app, const std::vector<std::string>& files) {
  if (files.empty() || files.front().find_first_of("./") != std::string::npos) return std::nullopt;
  const std::string& word = files.front();
  if (std::filesystem::exists(word)) return std::nullopt;
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  const std::vector<std::string_view> names(commands.begin(), commands.end());
  constexpr std::size_t kMostMistakes = 2;
  const std::string_view nearest = nearest_names(word, names).front();
  if (edit_distance(word, nearest) > kMostMistakes) return std::nullopt;
  return Error{ErrorCode::usage,
               "unknown command " + in_quotes(word) + "; did you mean " + std::string(nearest) + '?',
               {},
               0,
               0};
}

int run(int argc, const char* const* argv, const OpenWindow& open_window) {
  CLI::App app;
  Arguments arguments;
  describe_commands(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    // Help and version: results, so they go to stdout.
    const int code = app.exit(done);
    return std::fflush(stdout) == 0 ? code
                                    : report({ErrorCode::cannot_write, "cannot be written", "standard output", 0, 0});
  } catch (const CLI::ParseError& error) {
    if (app.get_subcommands().empty())
      if (const auto mistake = mistaken_command(app, app["FILE"]->as<std::vector<std::string>>()))
        return report(*mistake);
    return refuse(app, error.what());
  }
  if (const auto chosen = app.get_subcommands(); !chosen.empty()) {
    if (!arguments.files.empty()) return refuse(app, "unexpected " + in_quotes(arguments.files.front()));
    const auto done = run_command(*chosen.front(), arguments);
    return done ? kExitDone : report(done.error());
  }
  if (const auto mistake = mistaken_command(app, arguments.files)) return report(*mistake);
  return open_window(std::move(arguments.files));
}

}  // namespace

int run_command_line(int argc, const char* const* argv, const OpenWindow& open_window) {
  try {
    return run(argc, argv, open_window);
  } catch (const std::bad_alloc&) {
    return report({ErrorCode::out_of_memory, "there is not enough memory", {}, 0, 0});
  } catch (const std::system_error& error) {
    return report({ErrorCode::out_of_memory, "the system refuses: " + std::string(error.what()), {}, 0, 0});
  } catch (const std::exception& error) {
    return report({ErrorCode::cannot_compute, error.what(), {}, 0, 0});
  }
}

}  // namespace mes::cli
