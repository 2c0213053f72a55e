// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that make samples of curves, as users see them: `shape`, `sample`, `text`.
#include "app/cli/command_options.h"
#include "core/curves/sampling.h"
#include "core/io/format.h"

namespace mes::cli {

CLI::App* describe_shape(CLI::App& app, ShapeCommand& to) {
  CLI::App* const shape =
      app.add_subcommand("shape", "Samples of a shape with parameters, as POFF; of balls, as WPOFF");
  shape->add_option("NAME", to.name, "Shape id (mesecina list shapes)")->required();
  shape
      ->add_option("--set", to.settings,
                   "Set a parameter of the shape, KEY=VALUE (mesecina list shapes);\n"
                   "may be repeated. Formulas know t, pi and the usual functions, as in\n"
                   "--set \"r=1 + 0.3*cos(5*t)\"")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* const samples =
      shape->add_option("--samples", to.samples,
                        "How many samples, evenly along curves; default: some 400 of curves, more where parts\n"
                        "are near to each other");
  shape->add_option("--spacing", to.spacing, "Between samples along curves, at most")->excludes(samples);
  shape->add_option("--jitter", to.jitter, "Move each sample by up to so many mean spacings")->capture_default_str();
  shape->add_option("--seed", to.seed, "Of random points and of the jitter")->capture_default_str();
  shape->add_option("-o,--output", to.output, "Write to this file instead of standard output");
  add_force(*shape, to.force);
  return shape;
}

CLI::App* describe_sample(CLI::App& app, SampleRequest& to) {
  CLI::App* const sample = app.add_subcommand(
      "sample",
      "Other samples of the curves of a drawing, a map or a picture, or of a curve through samples, as POFF");
  sample->add_option("FILE", to.file, "File to read, or - for standard input")->required();
  sample->add_option("--from", to.from,
                     "Format of the input, when it is not to be found out (" + ids_of(format_descriptors()) + ")");
  add_reading(*sample, to.reading);
  sample->add_option("--rule", to.rule,
                     "Where samples lie: " + ids_of(sampling_rules()) +
                         ";\n"
                         "default: what the other options ask for, or nearness");
  sample->add_option("--samples", to.samples,
                     "How many, or as many as there would be if they were even; default: 400");
  sample->add_option("--spacing", to.spacing, "Between samples along curves, at most");
  sample->add_option("--epsilon", to.epsilon,
                     "Of the rule feature-size: half the distance of neighbours over their local feature size,\n"
                     "at most; from 0.01 to 1, default: 0.25. Smaller ones are tried until the theorem is\n"
                     "proved, or it is said where and why it is not");
  sample->add_option("--turn", to.turn,
                     "Of the rule curvature: how much the direction turns between samples, at most, in degrees;\n"
                     "default: 11.5");
  sample->add_option("--corner-angle", to.corner_angle,
                     "Where the direction turns by more is a corner, and a sample; in degrees, default: 28.6");
  sample->add_option("--corner-radius", to.corner_radius, "Round corners with arcs of this radius");
  sample->add_option("--jitter", to.jitter, "Move each sample by up to so many mean spacings");
  sample->add_option("--seed", to.seed, "Of the jitter")->capture_default_str();
  sample->add_option("-o,--output", to.output, "Write to this file instead of standard output");
  add_force(*sample, to.force);
  return sample;
}

CLI::App* describe_text(CLI::App& app, TextCommand& to) {
  CLI::App* const text = app.add_subcommand("text", "Samples of the outlines of a text, as POFF");
  text->add_option("TEXT", to.text, "The text; lines end at line feeds")->required();
  text->add_option("--font", to.font,
                   "Name of an installed font, such as \"DejaVu Serif:bold\" (mesecina list fonts),\n"
                   "or a file with a slash in its name; default: the font of the program's window");
  text->add_option("--size", to.size, "Height of an em, in units of the plane")->capture_default_str();
  text->add_option("--line-spacing", to.line_spacing, "From line to line, as a multiple of what the font says")
      ->capture_default_str();
  text->add_flag("--no-kerning", to.no_kerning, "Leave letters as far apart as without their neighbours");
  CLI::Option* const samples =
      text->add_option("--samples", to.samples,
                       "How many samples, evenly along curves; default: some 400, more where parts are\n"
                       "near to each other");
  text->add_option("--spacing", to.spacing, "Between samples along curves, at most")->excludes(samples);
  text->add_option("--jitter", to.jitter, "Move each sample by up to so many mean spacings")->capture_default_str();
  text->add_option("--seed", to.seed, "Of the jitter")->capture_default_str();
  text->add_option("-o,--output", to.output, "Write to this file instead of standard output");
  add_force(*text, to.force);
  text->footer("Contours that overlap become one. Characters that the font has no glyph for are left out and named.");
  return text;
}

}  // namespace mes::cli
