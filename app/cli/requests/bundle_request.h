// SPDX-License-Identifier: GPL-3.0-or-later
// Finds bundles by their names on the command line.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/settings/bundle.h"
#include "core/io/files/file_fingerprint.h"

namespace mes {
class Registry;
}

namespace mes::cli {

struct AvailableBundle {
  Bundle bundle;
  bool is_built_in = false;
};

/// The user's bundles, followed by the built-in ones with other names. A file of the user that cannot be read is
/// reported and left alone.
std::vector<AvailableBundle> available_bundles(const Registry& registry);

/// Finds the bundle of this name (ignoring case if only one matches then), or the first bundle of the file of this
/// name, or for FILE:NAME the bundle of that name in the file. Adds the file to the sources. Error: `usage` with the
/// nearest names, or `bad_input` for a file without bundles.
Expected<Bundle> find_bundle(const Registry& registry, const std::string& name_or_file,
                             std::vector<SourceFile>& sources);

}  // namespace mes::cli
