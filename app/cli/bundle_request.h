// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/bundle.h"
#include "core/io/file_fingerprint.h"

namespace mes::cli {

struct AvailableBundle {
  Bundle bundle;
  bool is_built_in = false;
};

/// Those of the user first, then the built-in ones under other names. A file of the user's that cannot be read is
/// reported and left alone.
std::vector<AvailableBundle> available_bundles();

/// The bundle of this name, whatever the case if that leaves one; or the first of the file of this name; or of
/// FILE:NAME the one of that name in the file. Error: `usage` with the nearest names, or `bad_input` for a file that
/// holds none. A file that it is read from is added to the sources.
Expected<Bundle> find_bundle(const std::string& name_or_file, std::vector<SourceFile>& sources);

}  // namespace mes::cli
