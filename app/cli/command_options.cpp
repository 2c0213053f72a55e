// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_options.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/io/format.h"

namespace mes::cli {

namespace {

std::vector<FormatDescriptor> map_formats() {
  std::vector<FormatDescriptor> out;
  std::ranges::copy_if(format_descriptors(), std::back_inserter(out), &FormatDescriptor::is_map);
  return out;
}

}  // namespace

void add_reading(CLI::App& command, ReadingOptions& reading) {
  command.add_option("--threshold", reading.threshold,
                     "Of a picture (PNG, JPEG, BMP, PGM): what is traced parts from the rest between the\n"
                     "grey values N and N + 1, from 0 to 254; default: found by Otsu's method");
  command.add_option("--specks", reading.specks,
                     "Of a picture: outlines and holes around less than so many square pixels are left out;\n"
                     "default: 16, or a ten-thousandth of the picture if that is more");
  command.add_option("--figure-side", reading.figure,
                     "Of a picture: trace what is dark or what is light; default: what there is less of along\n"
                     "its edge");
  command.add_flag("--degrees", reading.keeps_degrees,
                   "Of a map (" + ids_of(map_formats()) +
                       "): longitude and latitude stay as they are, in\n"
                       "degrees; default: they are projected to kilometres about the middle of the map");
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "Overwrite the output even if it was read and has changed since");
}

}  // namespace mes::cli
