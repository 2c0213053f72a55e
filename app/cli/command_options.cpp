// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_options.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/graph/registry.h"
#include "core/io/format_spec.h"
#include "core/kernel/precision.h"

namespace mes::cli {

namespace {

std::string ids_of_formats(const Registry& registry, bool only_maps) {
  std::vector<FormatDescriptor> out;
  for (const auto& format : registry.formats().all())
    if (format->descriptor.is_map || !only_maps) out.push_back(format->descriptor);
  return ids_of(out);
}

}  // namespace

void add_reading(const Registry& registry, CLI::App& command, ReadingOptions& reading) {
  command.add_option("--threshold", reading.threshold,
                     "Of a picture (PNG, JPEG, BMP, PGM): what is traced and the rest are separated between the\n"
                     "grey values N and N + 1, from 0 to 254; default: found by Otsu's method");
  command.add_option("--specks", reading.specks,
                     "Of a picture: outlines and holes around less than so many square pixels are left out;\n"
                     "default: 16, or a ten-thousandth of the picture if that is more");
  command.add_option("--figure-side", reading.figure,
                     "Of a picture: trace what is dark or what is light; default: what there is less of along\n"
                     "its edge");
  command.add_flag("--degrees", reading.keeps_degrees,
                   "Of a map (" + ids_of_formats(registry, true) +
                       "): longitude and latitude stay as they are, in\n"
                       "degrees, and so do positions of web maps; default: they are projected to metres about\n"
                       "the middle of the map");
  command.add_option("--crs", reading.system,
                     "Coordinate system of the positions in a map, a table or a drawing, as EPSG:25832, WKT or\n"
                     "a string of PROJ; default: that which the file names. Results are in it again");
  command.add_flag("--vertices", reading.keeps_vertices,
                   "Of drawings, maps and meshes: samples are the vertices alone; default: long sides have samples\n"
                   "between them");
}

void add_format(const Registry& registry, CLI::App& command, std::string& from) {
  command.add_option("--from", from,
                     "Format of the input: " + ids_of_formats(registry, false) +
                         ";\ndefault: found by what it holds, then by its name");
}

void add_output(CLI::App& command, std::string& output) {
  command.add_option("-o,--output", output, "Write to this file instead of standard output");
}

void add_output(CLI::App& command, std::string& output, bool& force) {
  add_output(command, output);
  add_force(command, force);
}

void add_source(const Registry& registry, CLI::App& command, Source& source) {
  add_input(registry, command, source);
  command.add_option("--precision", source.precision,
                     "Number type: " + ids_of(kPrecisionDescriptors) +
                         ";\n"
                         "default: that of the session, if FILE is one or carries one, and else fast");
  command
      .add_option("--set", source.settings,
                  "Set a parameter, NAME=VALUE (mesecina list parameters);\n"
                  "may be repeated. All others are those of the session, or else the defaults")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "Overwrite the output even if it was read");
}

}  // namespace mes::cli
