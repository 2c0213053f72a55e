// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions of the commands that write results as numbers: `compute`, `sweep`, `branches`, `centerline`,
// `persistence`, `export`.
#include <fmt/core.h>

#include "app/cli/command_options.h"
#include "app/store/texts/layer_text.h"
#include "app/store/texts/line_text.h"

namespace mes::cli {
namespace {

std::string help_of_formats(const auto& formats) {
  std::string out;
  for (const auto& format : formats) {
    if (!out.empty()) out += ";\n";
    out += fmt::format("{}: {}", format.name, format.help);
  }
  return out;
}

}  // namespace

void describe_compute(const Registry& registry, CLI::App& app, ComputeRequest& to) {
  CLI::App* const compute = app.add_subcommand("compute", "Counts and measures of structures and layers, as JSON");
  add_source(registry, *compute, to.source);
  compute->add_option("--layers", to.layers,
                      "Layer ids separated by commas (mesecina list layers), or all;\n"
                      "default: those of the session, if FILE is one or carries one, and\n"
                      "else those visible at start");
  compute->add_flag("!--no-timing", to.with_timing, "Leave out times: equal input gives equal bytes");
  compute->add_flag("--digest", to.with_digests,
                    "Add a digest to each layer: a function of what it draws, equal to that of `play`");
  add_output(*compute, to.output, to.force);
}

void describe_sweep(const Registry& registry, CLI::App& app, SweepRequest& to) {
  CLI::App* const sweep =
      app.add_subcommand("sweep", "Counts and measures while a parameter goes through its values, as CSV");
  add_source(registry, *sweep, to.source);
  sweep->add_option("--parameter", to.parameter, "NAME=FROM..TO, as in lambda-limit=0..20 (mesecina list parameters)")
      ->required();
  sweep->add_option("--steps", to.steps, "How many steps from the first value to the last, both of them shown")
      ->required();
  sweep->add_option("--layers", to.layers,
                    "Layer ids separated by commas (mesecina list layers), or all;\n"
                    "default: those of the session, if FILE is one or carries one, and\n"
                    "else those visible at start");
  add_output(*sweep, to.output, to.force);
  sweep->footer(
      "One line for each value; the columns are the numbers that `compute` gives for these layers and their "
      "structures.");
}

void describe_branches(const Registry& registry, CLI::App& app, BranchesRequest& to) {
  CLI::App* const branches = app.add_subcommand("branches", "The branches of an axis with their measures, as CSV");
  add_source(registry, *branches, to.source);
  branches
      ->add_option("--layer", to.layer,
                   "Which axis: medial-axis, lambda-medial-axis, angle-medial-axis or\n"
                   "cover-medial-axis, whose limits are parameters")
      ->capture_default_str();
  add_output(*branches, to.output, to.force);
  branches->footer(
      "One line for each branch, the longest first: its ends (leaf, junction, cut by the filter, or none of a loop "
      "or a point),\n"
      "length, radius of its balls, and the largest lambda and object angle in degrees. Branches shorter than a\n"
      "millionth of their radius, which come from the rounding of coordinates, are points. Positions are in the\n"
      "coordinate system of a map, lengths in its unit.");
}

void describe_centerline(const Registry& registry, CLI::App& app, CenterlineRequest& to) {
  CLI::App* const centerline =
      app.add_subcommand("centerline", "The centre line of each shape, or its widths, for maps, letters and carving");
  add_input(registry, *centerline, to, "Outlines to read, or - for standard input");
  centerline
      ->add_option("--prune", to.prune,
                   "Prune branches of the axis that reach beyond the ball at their junction by less than this part\n"
                   "of its radius; 0.5 prunes those into corners of 84 degrees and more, 1 of 60, 0 nothing")
      ->capture_default_str();
  centerline
      ->add_option("--smooth", to.smooth,
                   "How far the smoothed line may leave the axis: a length, or a percentage of half the width\n"
                   "there; it stays inside the shape; 0: the axis itself")
      ->capture_default_str();
  centerline->add_flag("--extend", to.is_extended, "Extend free ends straight on to the outline");
  centerline->add_flag("--exact", to.is_exact,
                       "Lines of the exact axis of the outlines, with the exact nearest points, instead of samples");
  centerline
      ->add_option("--branches", to.branches, "Lines of each shape at most, the longest first; from 1 to 100000")
      ->capture_default_str();
  centerline
      ->add_option("--between", to.between,
                   "Only the line between the free ends of the axis nearest to two points, in the coordinates of\n"
                   "the file")
      ->expected(2);
  centerline->add_option("--every", to.every,
                         "Write stations in steps of this length along each line instead: position, width, the\n"
                         "nearest points of both banks, and direction in degrees from the x axis");
  centerline->add_flag(
      "--each", to.are_features_apart,
      "Treat each feature of a map by itself (geojson, kml, wkt, shapefile, geopackage, flatgeobuf); lines keep\n"
      "its id and properties; the exit code is 1 if some have no line, and the others are written");
  centerline->add_option("--format", to.format,
                         help_of_formats(line_text_formats()) +
                             ";\ndefault: by the name of the output, else geojson; stations are a table in csv, and\n"
                             "lines across the shape in the others");
  add_output(*centerline, to.output, to.force);
  centerline->footer(
      "The line is the longest of the pruned medial axis: between its farthest free ends by the shortest way, or\n"
      "closed if there are no ends. Outlines of drawings, maps and pictures are sampled by local feature size\n"
      "first; points and sessions keep their samples.\n"
      "Lengths are metres for a map in degrees, else units of the file. Points are written, and --between is given,\n"
      "in the coordinate system of the map; GeoJSON is always in longitude and latitude on WGS 84.");
}

void describe_persistence(const Registry& registry, CLI::App& app, PersistenceRequest& to) {
  CLI::App* const persistence = app.add_subcommand(
      "persistence", "Births and deaths of components and holes of growing disks or balls, as CSV");
  add_source(registry, *persistence, to.source);
  persistence
      ->add_option("--of", to.of,
                   "What grows: samples, as disks of one radius; or the inner, polar or own balls, where\na ball of "
                   "radius r has the radius sqrt(r^2 + a^2) at a growth of a")
      ->capture_default_str();
  add_output(*persistence, to.output, to.force);
  persistence->footer(
      "One line for each persistence pair of the alpha complexes of the samples, the longest first: dimension (0:\n"
      "component, 1: hole), radii of birth and death, the sample of the component or the centre of the circle that\n"
      "fills the hole, and the edge that joins or closes. Components that never die have no death. For balls, "
      "births\n"
      "and deaths are growths, negative before the balls grow. Positions are in the coordinate system of a map,\n"
      "radii in its unit.");
}

void describe_export(const Registry& registry, CLI::App& app, ExportRequest& to) {
  CLI::App* const exported =
      app.add_subcommand("export", "The geometry of layers as text, or a table of a structure");
  add_source(registry, *exported, to.source);
  exported->add_option("--layer", to.layer,
                       "Layer id (mesecina list layers);\nfor geojson, wkt, gpkg, fgb, their areas, dxf and svg-path "
                       "also several separated "
                       "by commas, or all");
  exported->add_option("--structure", to.structure,
                       "Structure id (mesecina list structures): a table of it is written instead, as csv or npy");
  exported->add_option(
      "--cells", to.cells,
      "The Voronoi cells of the samples are written instead, as polygons in geojson, wkt, gpkg or fgb, as far as\n"
      "box: that of the samples, with a tenth of its longer side all around; hull: their convex hull;\n"
      "outline: what the curves of FILE enclose, where points beside the curves have the cells.\n"
      "Cells of points of a map have the attributes of their features");
  exported->add_option("--table", to.table, "Which table of the structure, if it has several");
  exported
      ->add_option(
          "--format", to.format,
          help_of_formats(layer_text_formats()) + ";\nnpy: the table of a structure as an array of records for NumPy")
      ->required();
  add_output(*exported, to.output, to.force);
}

}  // namespace mes::cli
