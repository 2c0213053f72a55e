// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bundle_request.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/bundles.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/sample_shapes.h"
#include "core/graph/layer_descriptor.h"
#include "core/io/bundle_file.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

Expected<Bundle> bundle_of_file(const std::string& file) {
  auto loaded = read_bundle_file(file, known_layers());
  if (!loaded) return std::unexpected(loaded.error());
  for (const std::string& warning : loaded->warnings) say(warning);
  if (loaded->bundles.size() > 1)
    say(file + ": the first of its " + std::to_string(loaded->bundles.size()) + " bundles is taken, " +
        in_quotes(loaded->bundles.front().name));
  return std::move(loaded->bundles.front());
}

}  // namespace

std::vector<AvailableBundle> available_bundles() {
  std::vector<AvailableBundle> out;
  const fs::path own = default_bundles_path();
  std::error_code error;
  if (!own.empty() && fs::exists(own, error)) {
    auto loaded = read_bundle_file(own, known_layers());
    if (!loaded) say(loaded.error().message());
    if (loaded)
      for (Bundle& bundle : loaded->bundles) out.push_back({std::move(bundle), false});
  }
  for (Bundle& bundle : read_starting_bundles(find_assets({})))
    if (std::ranges::none_of(out, [&](const AvailableBundle& has) { return has.bundle.name == bundle.name; }))
      out.push_back({std::move(bundle), true});
  return out;
}

Expected<Bundle> find_bundle(const std::string& name_or_file) {
  const std::vector<AvailableBundle> available = available_bundles();
  const Bundle* found = nullptr;
  std::size_t similar = 0;
  std::vector<std::string_view> names;
  for (const AvailableBundle& each : available) {
    names.push_back(each.bundle.name);
    if (each.bundle.name == name_or_file) return each.bundle;
    if (lower(each.bundle.name) != lower(name_or_file)) continue;
    found = &each.bundle;
    ++similar;
  }
  if (similar == 1) return *found;
  std::error_code error;
  const std::string extension = lower(fs::path(name_or_file).extension().string());
  if (fs::exists(name_or_file, error) || extension == ".json" || extension == ".bnd" ||
      name_or_file.find('/') != std::string::npos)
    return bundle_of_file(name_or_file);
  return usage_error(
      "unknown bundle " + in_quotes(name_or_file) +
      (names.empty() ? std::string() : "; did you mean " + one_of(nearest_names(name_or_file, names)) + '?') +
      " (mesecina list bundles)");
}

}  // namespace mes::cli
