// SPDX-License-Identifier: GPL-3.0-or-later
// Files of bundles: what was read is written and reads back equal.
#include <array>

#include "core/io/bundle_file.h"
#include "tests/fuzz/reader_checks.h"

namespace mes::fuzz {
namespace {

void check_bundles(std::string_view bytes, const std::string& name) {
  // A few of the layers, of which BND files know some by other names.
  const std::array<KnownLayer, 8> known{{{"points", {}},
                                         {"delaunay", {}},
                                         {"voronoi", {}},
                                         {"curve", {}},
                                         {"medial-axis", {}},
                                         {"voronoi-crust", {}},
                                         {"interior-voronoi-disks", {}},
                                         {"image", {}}}};
  static_cast<void>(are_bundles_of_the_future(bytes));
  const auto loaded = read_bundles(bytes, name, known);
  require_little_memory(bytes.size());
  require_little_work(bytes.size(), kPlainWork);
  if (!loaded) return require_error(loaded.error(), bytes);
  for (const std::string& warning : loaded->warnings) require_message(warning);
  const std::string text = write_bundles(loaded->bundles);
  require(looks_like_bundles(text) && !are_bundles_of_the_future(text), "what is written looks like bundles");
  const LoadedBundles again = require_read(read_bundles(text, "again.json", known));
  require(again.warnings.empty(), "what is written is read without a warning");
  require(again.bundles == loaded->bundles, "what is written reads back equal");
}

}  // namespace

void run_bnd(std::string_view bytes) {
  check_bundles(bytes, "a.bnd");
}
void run_bundle(std::string_view bytes) {
  check_bundles(bytes, "a.json");
}

}  // namespace mes::fuzz
