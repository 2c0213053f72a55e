// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions of the commands that make samples: `repair`, `decimate`, `evolve`, `shape`, `sample`, `text`.
#include "app/cli/command_options.h"
#include "core/curves/sampling.h"
#include "core/io/format.h"

namespace mes::cli {
namespace {

void add_resampling(const Registry& registry, CLI::App& command, ResampleRequest& request, const char* epsilon) {
  add_input(registry, command, request);
  command.add_option("--epsilon", request.epsilon, epsilon)->capture_default_str();
  add_output(command, request.output, request.force);
}
}  // namespace

void describe_repair(const Registry& registry, CLI::App& app, ResampleRequest& to) {
  CLI::App* const repair = app.add_subcommand("repair", "Samples inserted where the curve has too few of them");
  add_resampling(registry, *repair, to,
                 "Curve edges are halved while half their length is more than this part of the\n"
                 "distance of their ends to the axis; above 0, at most 1");
  repair->footer(
      "New samples lie on the curves of a drawing, a map or a picture; where there are none, on a spline through "
      "the\n"
      "others, interrupted at corners. What was done is said on standard error, and what could not be: no number of\n"
      "samples is dense enough at a corner.");
}

void describe_decimate(const Registry& registry, CLI::App& app, ResampleRequest& to) {
  CLI::App* const decimate =
      app.add_subcommand("decimate", "Samples taken away that the curve and the topology of the axis do not need");
  add_resampling(registry, *decimate, to,
                 "The rest is to have, along the curve, half the distance of neighbours at most this\n"
                 "part of their distance to the axis; above 0, at most 1");
  decimate->footer(
      "The curve goes through the rest in the same order, and the axis has as many components and cycles as before.");
}

void describe_evolve(const Registry& registry, CLI::App& app, EvolveRequest& to) {
  CLI::App* const evolve = app.add_subcommand("evolve", "Samples after some steps of an evolution, as POFF");
  add_input(registry, *evolve, to);
  evolve->add_option("--evolution", to.evolution,
                     "Evolution id (mesecina list evolutions); required, unless FILE is a session\n"
                     "with an evolution");
  evolve->add_option("--steps", to.steps, "How many steps")->required();
  evolve->add_option("--seed", to.seed,
                     "Of the random numbers, where an evolution draws any;\n"
                     "default: that of the session, if FILE is one or carries one, and else 1");
  evolve
      ->add_option("--set", to.settings,
                   "Set a parameter of evolutions, NAME=VALUE (mesecina list\nparameters); may be repeated")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_output(*evolve, to.output, to.force);
}

void describe_shape(CLI::App& app, ShapeCommand& to) {
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
  add_output(*shape, to.output, to.force);
}

void describe_sample(const Registry& registry, CLI::App& app, SampleRequest& to) {
  CLI::App* const sample = app.add_subcommand(
      "sample",
      "Other samples of the curves of a drawing, a map or a picture, or of a curve through samples, as POFF");
  add_input(registry, *sample, to, "File to read, or - for standard input");
  sample->add_option("--rule", to.rule,
                     "Where samples lie: " + ids_of(sampling_rules()) +
                         ";\n"
                         "default: what the other options ask for, or nearness");
  sample->add_option("--samples", to.samples,
                     "How many, or as many as there would be if they were even; default: 400");
  sample->add_option("--spacing", to.spacing, "Between samples along curves, at most");
  sample->add_option("--epsilon", to.epsilon,
                     "Of the rule feature-size: half the length between neighbours over the local feature size\n"
                     "of the curves there, at most; from 0.01 to 1, default: 0.25. Smaller ones are tried until\n"
                     "the theorem is proved, or it is said where and why it is not");
  sample->add_option("--turn", to.turn,
                     "Of the rule curvature: how much the direction turns between samples, at most, in degrees;\n"
                     "default: 11.5");
  sample->add_option("--corner-angle", to.corner_angle,
                     "Where the direction turns by more is a corner, and a sample; in degrees, default: 28.6");
  sample->add_option("--corner-radius", to.corner_radius, "Round corners with arcs of this radius");
  sample->add_option("--jitter", to.jitter, "Move each sample by up to so many mean spacings");
  sample->add_option("--seed", to.seed, "Of the jitter")->capture_default_str();
  add_output(*sample, to.output, to.force);
}

void describe_text(CLI::App& app, TextCommand& to) {
  CLI::App* const text = app.add_subcommand("text", "Samples of the outlines of a text, as POFF");
  text->add_option("TEXT", to.text, "The text; lines end at line feeds")->required();
  text->add_option("--font", to.font,
                   "Name of an installed font, such as \"DejaVu Serif:bold\" (mesecina list fonts),\n"
                   "or a file with a slash in its name; default: the font of the program's window");
  text->add_option("--size", to.size, "Height of an em, in units of the samples")->capture_default_str();
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
  add_output(*text, to.output, to.force);
  text->footer("Contours that overlap become one. Characters that the font has no glyph for are left out and named.");
}

}  // namespace mes::cli
