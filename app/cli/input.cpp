// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input.h"

#include <unistd.h>

#include "app/cli/messages.h"

namespace mes::cli {

Expected<LoadedFile> read_input(const std::string& file, const std::string& format) {
  auto loaded = file == "-" ? read_sample_stream(STDIN_FILENO, file, format) : read_sample_file(file, format);
  if (!loaded) return loaded;
  for (const std::string& warning : loaded->warnings) say(warning);
  return loaded;
}

}  // namespace mes::cli
