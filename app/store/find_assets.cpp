// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/auxv.h>

#include <cstdlib>
#include <vector>

#include "app/store/sample_shapes.h"

namespace mes {

namespace fs = std::filesystem;

fs::path find_assets(const fs::path& executable) {
  std::vector<fs::path> candidates;
  if (const char* given = std::getenv("MESECINA_ASSETS"); given != nullptr && given[0] != '\0')
    candidates.emplace_back(given);
  std::error_code error;
  // The link of the running program is right by whatever name it was started.
  fs::path self = fs::read_symlink("/proc/self/exe", error);
  // A chroot may lack /proc. A name without a folder was found on the PATH, and the kernel passes the path on.
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the kernel hands over the address as a number.
  if (error) self = executable.has_parent_path() ? executable : reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  self = fs::absolute(self, error);
  const fs::path folder = self.parent_path();
  candidates.push_back(folder / "assets");
  candidates.push_back(folder / ".." / "share" / "mesecina");
  for (const fs::path& candidate : candidates)
    if (fs::is_directory(candidate / "shapes", error)) return fs::canonical(candidate, error);
  return {};
}

}  // namespace mes
