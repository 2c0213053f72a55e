// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions of the commands that draw: `render`, `play`, `demo`, `lesson`.
#include <functional>
#include <utility>

#include "app/cli/command_options.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/picture_request.h"
#include "app/cli/requests/style_request.h"
#include "app/export/page_size.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

/// The page sizes in one text: "one-column (84mm), ...".
std::string page_preset_words() {
  std::string out;
  for (const PagePreset& preset : page_presets())
    out += (out.empty() ? "" : ", ") + std::string(preset.name) + " (" + std::string(preset.size) + ')';
  return out;
}

/// The file extensions in one text: ".png, .svg, ...".
std::string picture_extension_words() {
  std::string out(kPixelExtension);
  for (const figure::Format& format : figure::formats()) out += ", " + std::string(format.extension);
  return out;
}

/// Adds the options for explanations on a picture.
template <class Request>
void add_explanations(CLI::App& command, Request& to) {
  command.add_flag("--legend,!--no-legend", to.with_legend,
                   "With a colour map: whether its colour bar is drawn; default: yes");
  command.add_flag("--key", to.with_key, "With all layers in the legend, and a sample of how each is drawn");
  command.add_flag("--scale-bar", to.marks.bar, "A line of a round length, with its length in units of the samples");
  command.add_flag("--axes", to.marks.axes, "Numbers along the lower and the left edge");
  command.add_flag("--grid", to.marks.grid, "Faint lines at round numbers, those of the axes");
  command.add_flag("!--no-annotations", to.with_annotations,
                   "Leave out text, arrows, dimensions and highlights that a session holds");
}

/// Adds an option whose value is a position, which is passed to `to`.
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
      "pixels an inch, times --scale); default: the corner where it hides least.\n"
      "It gives way to a scale bar: next to it, or with fewer layers, or not at all");
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
  command.add_option("--shard", film.shard, "Only every Nth picture, beginning with the Ith, under the same names");
}

}  // namespace

void describe_render(const Registry& registry, CLI::App& app, RenderRequest& to) {
  CLI::App* const render =
      app.add_subcommand("render", "A picture of layers, in pixels or as vector graphics; needs no display");
  add_source(registry, *render, to.source);
  render->add_option("--layers", to.layers,
                     "Layer ids separated by commas, or all; default: those of the session, if FILE\n"
                     "is one or carries one, and else those visible at start.\n"
                     "They are drawn in the order of mesecina list layers, the first at\n"
                     "the bottom, however they are listed here");
  render
      ->add_option("--bundle", to.bundle,
                   "Layers, their order and their styles as in a bundle: its name\n"
                   "(mesecina list bundles) or a file of bundles, .json or .bnd, of which\n"
                   "the first is taken, or that of FILE:NAME")
      ->excludes("--layers");
  CLI::Option* const size = render
                                ->add_option("--size", to.size,
                                             "Width and height in pixels, WxH; in vector formats a pixel is\n"
                                             "1/96 inch")
                                ->capture_default_str();
  render
      ->add_option("--figure-size", to.figure_size,
                   "Size of a vector format on paper: WxH, or a width to which the height\n"
                   "follows, with units mm, cm, in, pt or px, as in 84mmx60mm;\n"
                   "or " +
                       page_preset_words() +
                       ".\n"
                       "Where samples are dense, lines are not made finer than 0.5 pt; the\n"
                       "letters of the legend have 7.5 pt, times --scale, on a small page too,\n"
                       "and 15 pt on a slide")
      ->excludes(size);
  render->add_option("--bounds", to.bounds, "Of a vector format: view, or tight to cut it to what is drawn")
      ->capture_default_str();
  render->add_option("--rasterize", to.rasterized,
                     "Layers that become pictures in a vector format: of thousands of shapes\n"
                     "a picture is smaller");
  render->add_option("--dpi", to.dpi, "Dots an inch of these pictures, from 10 to 2400")->capture_default_str();
  render->add_option("--view", to.view,
                     "fit, or X0,Y0,X1,Y1: two corners of what must be seen. fit shows the\n"
                     "samples and the layers that count for it, with a margin of 5 %;\n"
                     "default: what the session shows, and else fit");
  render->add_option("--scale", to.scale, "Factor for line widths and point sizes, as for a denser screen")
      ->capture_default_str();
  render->add_option("--background", to.background, "RRGGBB, or transparent (none)")->capture_default_str();
  render
      ->add_option("--set-style", to.styles,
                   "Change the style of a layer, LAYER:KEY=VALUE[,KEY=VALUE...]; may be repeated.\n"
                   "Keys: " +
                       style_keys() +
                       ".\n"
                       "point-size and line-width are in pixels, or on paper with a unit, as in\n"
                       "0.5pt; color-map is the name of a map (mesecina list color-maps) or none,\n"
                       "range is LOW:HIGH or fit; dashed, flat and thin-when-dense are on or off.\n"
                       "Where samples are dense, dots and lines are finer than their style says, as in\n"
                       "the window, but not where a size or a width is given, or thin-when-dense=off")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* const compare =
      render->add_option("--compare", to.compared,
                         "Panes side by side, WHAT=VALUE,VALUE[,VALUE...]: precision, family (a, p,\n"
                         "b: the layers of these balls), bundle, step (of --evolution), or a\n"
                         "parameter (mesecina list parameters), as in precision=naive,exact.\n"
                         "All panes show the same part of the plane, unless --free-cameras is given");
  render
      ->add_flag("--free-cameras", to.has_free_cameras,
                 "Show in each pane all that is in it, each at a scale of its own")
      ->needs(compare);
  render->add_flag("--differences", to.with_differences, "Mark what only some of the panes have")->needs(compare);
  render
      ->add_option("--evolution", to.evolution,
                   "Evolution of --compare step=..., NAME or NAME:KEY=VALUE[,KEY=VALUE...] with\n"
                   "its parameters and seed (mesecina list evolutions, parameters);\n"
                   "default: that of the session")
      ->needs(compare);
  render->add_option("--image", to.image,
                     "A picture (PNG, JPEG, BMP, PGM) below everything else (the layer image), FILE or\n"
                     "FILE:X,Y,WIDTH: its centre and width in units of the samples;\n"
                     "without them it is laid into the box around the samples");
  add_explanations(*render, to);
  add_places(*render, to);
  add_title(*render, to.title);
  render->add_flag("!--no-source", to.with_source,
                   "Leave out of the picture what it is of: without this PNG, SVG, PDF and\n"
                   "Ipe files hold samples, view and layers, and can be given as FILE");
  render->add_option("--to", to.format,
                     "Format of the picture: " + one_of(picture_formats()) +
                         "; default: as the\n"
                         "name of the output says, and png for standard output");
  render
      ->add_option("-o,--output", to.output, "The picture, " + picture_extension_words() + "; - for standard output")
      ->required();
  add_force(*render, to.force);
}

void describe_play(CLI::App& app, PlayRequest& to) {
  CLI::App* const play = app.add_subcommand("play", "What happened in a session, once more, step by step");
  play->add_option("SESSION", to.session, "A saved session, .json, or - for standard input")->required();
  add_film(*play, to.film);
  play->footer("Without --frames and --video: one line of JSON a step, with digests of document and layers.");
}

void describe_demo(CLI::App& app, DemoRequest& to) {
  CLI::App* const demo = app.add_subcommand(
      "demo", "The paper's video: the one-step axis, the general pipeline, smoothing; needs no display");
  add_film(*demo, to.film);
}

void describe_lesson(CLI::App& app, LessonRequest& to) {
  CLI::App* const lesson =
      app.add_subcommand("lesson", "The steps of a lesson, listed or as slides; needs no display");
  lesson
      ->add_option("LESSON", to.file,
                   "A session with a lesson, .json or a file that carries it, - for standard\ninput, or the name of "
                   "one that comes with the program\n(mesecina list lessons)")
      ->required();
  lesson->add_option("--pdf", to.pdf, "Slides as vector graphics, a page a step; - for standard output");
  lesson->add_option(
      "--html", to.html,
      "Slides in one file for a browser, with keys and nothing from elsewhere;\n- for standard output");
  lesson->add_option("--web", to.web,
                     "Folder for a page with the program in it, which presents the whole lesson live in a\nbrowser; "
                     "scripts/web.sh makes the program");
  lesson->add_option("--frames", to.frames, "Folder for a picture a step, 00001.png ..., and manifest.json");
  lesson->add_option("--video", to.video,
                     "A video that shows each step for its seconds, .mp4 or .webm; needs ffmpeg");
  lesson->add_option("--vtt", to.vtt, "The captions with the times of the steps, as WebVTT; - for standard output");
  lesson->add_option("--size", to.size, "Width and height of these pictures in pixels, WxH")->capture_default_str();
  lesson->add_option("--steps", to.steps, "Only these steps, as in 2-4 or 1,3-5; default: all");
  lesson
      ->add_option("--figure-size", to.figure_size,
                   "Size of a page of PDF and HTML: WxH, with units mm, cm, in, pt or px, as in 297mmx210mm;\n"
                   "or " +
                       page_preset_words())
      ->capture_default_str();
  lesson->add_option("--scale", to.scale, "Factor for line widths and point sizes of drawings")
      ->capture_default_str();
  lesson->add_option("--background", to.background, "RRGGBB, or transparent (none)")->capture_default_str();
  add_explanations(*lesson, to);
  lesson->add_flag("!--no-source", to.with_source,
                   "Leave the session out of the PDF, and of manifest.json of the frames: with it\n"
                   "the PDF can be given as LESSON");
  add_force(*lesson, to.force);
  lesson->footer("Without an output: one line a step, with its number, how long it is to be shown, and its name.");
}

}  // namespace mes::cli
