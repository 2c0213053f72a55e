// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/bundle_request.h"

#include <fmt/core.h>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/cli/console/messages.h"
#include "app/cli/requests/names.h"
#include "app/store/looks/bundles.h"
#include "app/store/sample_shapes.h"
#include "core/base/lower_case.h"
#include "core/draw/layer_descriptor.h"
#include "core/graph/registry.h"
#include "core/io/bundle_file.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

namespace fs = std::filesystem;

/// The bundle of this name. Ignores case if only one bundle matches then; null if none matches.
const Bundle* bundle_named(const std::vector<Bundle>& bundles, const std::string& name) {
  const Bundle* similar = nullptr;
  for (const Bundle& bundle : bundles) {
    if (bundle.name == name) return &bundle;
    if (lower_case(bundle.name) != lower_case(name)) continue;
    if (similar != nullptr) return nullptr;
    similar = &bundle;
  }
  return similar;
}

Error unknown_bundle(const std::string& name, const std::vector<Bundle>& bundles, const std::string& where) {
  std::vector<std::string_view> names;
  for (const Bundle& bundle : bundles) names.push_back(bundle.name);
  return {ErrorCode::usage,
          "unknown bundle " + in_quotes(name) + where +
              (names.empty() ? std::string() : "; did you mean " + one_of(nearest_names(name, names)) + '?')};
}

/// The bundle of this name in the file; an empty name means the first bundle.
Expected<Bundle> bundle_of_file(const Registry& registry, const std::string& file,
                                const std::optional<std::string>& name, std::vector<SourceFile>& sources) {
  if (const auto fingerprint = fingerprint_of_file(file)) sources.push_back({file, *fingerprint});
  auto loaded = read_bundle_file(file, known_layers(registry.layers()));
  if (!loaded) return std::unexpected(loaded.error());
  for (const std::string& warning : loaded->warnings) say(warning);
  if (name) {
    if (const Bundle* bundle = bundle_named(loaded->bundles, *name)) return *bundle;
    return std::unexpected(unknown_bundle(*name, loaded->bundles, " in " + file));
  }
  if (loaded->bundles.size() > 1)
    say(fmt::format("{}: the first of its {} bundles is taken, {}; FILE:NAME takes another", file,
                    loaded->bundles.size(), in_quotes(loaded->bundles.front().name)));
  return std::move(loaded->bundles.front());
}

}  // namespace

std::vector<AvailableBundle> available_bundles(const Registry& registry) {
  std::vector<AvailableBundle> out;
  const fs::path own = default_bundles_path();
  std::error_code error;
  if (!own.empty() && fs::exists(own, error)) {
    auto loaded = read_bundle_file(own, known_layers(registry.layers()));
    if (!loaded) say(loaded.error().message());
    if (loaded)
      for (Bundle& bundle : loaded->bundles) out.push_back({std::move(bundle), false});
  }
  StartingBundles starting = read_starting_bundles(registry.layers(), find_assets({}));
  if (!starting.message.empty()) say(starting.message);
  for (Bundle& bundle : starting.bundles)
    if (std::ranges::none_of(out, [&](const AvailableBundle& has) { return has.bundle.name == bundle.name; }))
      out.push_back({std::move(bundle), true});
  return out;
}

Expected<Bundle> find_bundle(const Registry& registry, const std::string& name_or_file,
                             std::vector<SourceFile>& sources) {
  std::vector<Bundle> bundles;
  for (AvailableBundle& each : available_bundles(registry)) bundles.push_back(std::move(each.bundle));
  if (const Bundle* bundle = bundle_named(bundles, name_or_file)) return *bundle;
  std::error_code error;
  const std::string extension = lower_case_extension(name_or_file);
  if (fs::exists(name_or_file, error)) return bundle_of_file(registry, name_or_file, {}, sources);
  // File names and bundle names may contain colons, too.
  for (std::size_t colon = name_or_file.find(':'); colon != std::string::npos;
       colon = name_or_file.find(':', colon + 1))
    if (const std::string file = name_or_file.substr(0, colon); fs::is_regular_file(file, error))
      return bundle_of_file(registry, file, name_or_file.substr(colon + 1), sources);
  if (extension == ".json" || extension == ".bnd" || name_or_file.find('/') != std::string::npos)
    return bundle_of_file(registry, name_or_file, {}, sources);
  Error out = unknown_bundle(name_or_file, bundles, {});
  out.text += " (mesecina list bundles)";
  return std::unexpected(std::move(out));
}

}  // namespace mes::cli
