// SPDX-License-Identifier: GPL-3.0-or-later
// Files of bundles: our own JSON, and the BND files of the Mesecina of 2007 and 2009.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/document/settings/bundle.h"

namespace mes {

/// The largest number of bundles in a file.
inline constexpr std::size_t kMostBundles = 1000;

/// A known layer with its default style.
struct KnownLayer {
  std::string_view id{};
  LayerStyle style{};
};

struct LoadedBundles {
  std::vector<Bundle> bundles{};
  std::vector<std::string> warnings{};  ///< one line each, with the file name
};

/// Writes JSON that reads back exactly. Invalid UTF-8 in names is replaced.
std::string write_bundles(std::span<const Bundle> bundles);

/// Whether the bytes, the first few kilobytes of a file, begin a bundle file of either kind.
bool looks_like_bundles(std::string_view bytes);
/// The same for a file; true by the name alone for .bnd, and false for a file that cannot be read.
bool is_bundle_file(const std::filesystem::path& path);

/// JSON is recognised by its first key and BND by its token. Unknown keys and unknown layers of JSON are accepted;
/// layers of BND outside `known` are left out with a warning. Properties that a style omits come from the layer's
/// default style (BND has neither dashed nor flat). Error: `bad_input`, for JSON with line and column, for BND with the
/// byte.
Expected<LoadedBundles> read_bundles(std::string_view bytes, const std::string& file,
                                     std::span<const KnownLayer> known);
/// Refuses files of more than 16 MiB without reading them.
Expected<LoadedBundles> read_bundle_file(const std::filesystem::path& path, std::span<const KnownLayer> known);

/// Whether a later version of the program wrote the JSON: the file is not broken, but must not be overwritten.
bool are_bundles_of_the_future(std::string_view bytes);

}  // namespace mes
