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
#include "core/document/bundle.h"

namespace mes {

/// The largest number of bundles in a file.
inline constexpr std::size_t kMostBundles = 1000;

/// A layer that there is, with the style it has by itself.
struct KnownLayer {
  std::string_view id{};
  LayerStyle style{};
};

struct LoadedBundles {
  std::vector<Bundle> bundles{};
  std::vector<std::string> warnings{};  ///< one line each, with the file
};

/// JSON; everything reads back as it was. Names that are not UTF-8 are made so.
std::string write_bundles(std::span<const Bundle> bundles);

/// Of the first few kilobytes: whether they begin a file of bundles of either kind.
bool looks_like_bundles(std::string_view bytes);
/// The same for a file, and true by the name alone for .bnd; one that cannot be read is none.
bool is_bundle_file(const std::filesystem::path& path);

/// JSON is recognised by its first key and BND by its token; unknown keys and unknown layers of JSON are let through,
/// layers of BND that are not among `known` are left out with a warning. What a style does not say is the layer's own
/// (BND says neither dashed nor flat). Error: `bad_input`, for JSON with line
/// and column, for BND with the byte.
Expected<LoadedBundles> read_bundles(std::string_view bytes, const std::string& file,
                                     std::span<const KnownLayer> known);
/// Files of more than 16 MiB are refused unread.
Expected<LoadedBundles> read_bundle_file(const std::filesystem::path& path, std::span<const KnownLayer> known);

/// Whether the JSON is of a later version of the program than this one: not broken, but not ours to overwrite.
bool are_bundles_of_the_future(std::string_view bytes);

}  // namespace mes
