// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_options.h"

namespace mes::cli {

void add_trace(CLI::App& command, TraceOptions& trace) {
  command.add_option("--threshold", trace.threshold,
                     "Of a picture (PNG, JPEG, BMP, PGM): what is traced parts from the rest between the\n"
                     "grey values N and N + 1, from 0 to 254; default: found by Otsu's method");
  command.add_option("--specks", trace.specks,
                     "Of a picture: outlines and holes around less than so many square pixels are left out;\n"
                     "default: 16, or a ten-thousandth of the picture if that is more");
  command.add_option("--figure-side", trace.figure,
                     "Of a picture: trace what is dark or what is light; default: what there is less of along\n"
                     "its edge");
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "Overwrite the output even if it was read and has changed since");
}

}  // namespace mes::cli
