// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes bundles on disk.
#include <fmt/core.h>
#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/store/looks/bundles.h"
#include "app/system/data_folder.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/file_lock.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr int kMostAttempts = 50;

std::string bytes_of(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(out).str();
}

/// The first free name with this ending, so that no file set aside before is lost.
fs::path free_name(const fs::path& path, const std::string& ending) {
  fs::path out = path.string() + ending;
  std::error_code error;
  for (int number = 2; fs::exists(out, error); ++number) out = fmt::format("{}{}-{}", path.string(), ending, number);
  return out;
}

}  // namespace

fs::path default_bundles_path() {
  const fs::path folder = data_folder();
  return folder.empty() ? folder : folder / "bundles.json";
}

std::vector<KnownLayer> known_layers(std::span<const LayerDescriptor> descriptors) {
  std::vector<KnownLayer> out;
  for (const LayerDescriptor& layer : descriptors)
    if (!layer.is_removed) out.push_back({layer.id, layer.style});
  return out;
}

StartingBundles read_starting_bundles(std::span<const LayerDescriptor> descriptors, const fs::path& assets) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(assets / "bundles", error))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  StartingBundles out;
  if (files.empty()) out.message = "the bundles that come with the program are missing";
  for (const fs::path& file : files) {
    auto loaded = read_bundle_file(file, known_layers(descriptors));
    if (loaded)
      std::ranges::move(loaded->bundles, std::back_inserter(out.bundles));
    else if (out.message.empty())
      out.message = "bundles that come with the program are left out: " + loaded.error().message();
  }
  return out;
}

std::optional<std::vector<Bundle>> BundleStore::read(std::string& message) {
  std::error_code error;
  if (path_.empty() || !fs::exists(path_, error)) return std::nullopt;
  auto loaded = read_bundle_file(path_, known_layers(descriptors_));
  if (loaded) return std::move(loaded->bundles);
  // Reading a pipe would block until it is written to.
  const std::string bytes = fs::is_regular_file(path_, error) ? bytes_of(path_) : std::string();
  // An empty list may be intended and is not an error.
  if (bytes == write_bundles({})) return std::vector<Bundle>{};
  const bool is_later = are_bundles_of_the_future(bytes);
  const fs::path aside = free_name(path_, is_later ? ".later" : ".broken");
  fs::rename(path_, aside, error);
  message = "the bundles could not be read (" + loaded.error().text + "); ";
  if (error) {
    message += "they stay in " + path_.string() + ", and new ones will not be kept";
    path_.clear();
  } else {
    message += "they were set aside as " + aside.string();
  }
  return std::nullopt;
}

BundleStore::Loaded BundleStore::load(std::vector<Bundle> starting) {
  Loaded out;
  // Locked, so that the file that is set aside is not one that was repaired meanwhile.
  std::optional<UpdateLock> lock;
  std::error_code error;
  if (!path_.empty() && fs::exists(path_, error)) lock.emplace(path_, patience_);
  auto found = read(out.message);
  out.bundles = found ? std::move(*found) : std::move(starting);
  seen_ = out.bundles;
  return out;
}

Expected<Replaced> BundleStore::replace(const std::string& text,
                                        const std::optional<FileFingerprint>& expected) const {
  if (expected) return replace_file(path_, text, *expected);
  if (auto written = write_file_atomically(path_, text); !written) return std::unexpected(written.error());
  return Replaced::done;
}

Expected<BundleStore::Loaded> BundleStore::write(std::span<const Bundle> mine) {
  Loaded out{{mine.begin(), mine.end()}, {}};
  if (path_.empty()) return out;
  std::error_code error;
  fs::create_directories(path_.parent_path(), error);
  if (error)
    return std::unexpected(
        Error{ErrorCode::cannot_write, "cannot make the folder: " + error.message(), path_.parent_path().string()});
  // A suspended process cannot hold up others for long; if it writes late, the file is read again.
  const UpdateLock lock(path_, patience_);
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const auto read_from = fingerprint_of_file(path_);
    const auto theirs = read(out.message);
    if (path_.empty()) return out;
    if (theirs) out.bundles = merge_bundles(seen_, mine, *theirs);
    const auto written = replace(write_bundles(out.bundles), read_from);
    if (!written) return std::unexpected(written.error());
    if (*written == Replaced::changed) continue;
    seen_ = out.bundles;
    return out;
  }
  return std::unexpected(
      Error{ErrorCode::cannot_write, "other programs change it all the time; save once more", path_.string()});
}

}  // namespace mes
