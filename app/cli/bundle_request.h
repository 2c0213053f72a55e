// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/bundle.h"
#include "core/io/file_fingerprint.h"

namespace mes {
class Registry;
}

namespace mes::cli {

struct AvailableBundle {
  Bundle bundle;
  bool is_built_in = false;
};

/// Those of the user first, then the built-in ones under other names. A file of the user's that cannot be read is
/// reported and left alone.
std::vector<AvailableBundle> available_bundles(const Registry& registry);

/// The bundle of this name, ignoring case where that leaves a single one; or the first bundle of the file of this name;
/// or, for FILE:NAME, the bundle of that name in the file. Error: `usage` with the nearest names, or `bad_input` for a
/// file without bundles. The file that is read is added to the sources.
Expected<Bundle> find_bundle(const Registry& registry, const std::string& name_or_file,
                             std::vector<SourceFile>& sources);

}  // namespace mes::cli
