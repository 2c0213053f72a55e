// SPDX-License-Identifier: GPL-3.0-or-later
// BND, the bundles of the Mesecina of 2007 and 2009: a QDataStream of Qt 4, big endian. Read only. Private to
// core/io.
#pragma once

#include "core/io/bundle_file.h"

namespace mes {

bool looks_like_bnd(std::string_view bytes);

/// Maps the layer names of 2007 and 2009 to ids; layers without a counterpart among `known` are left out and counted in
/// one warning. Memory stays below a small multiple of the file size, whatever lengths the file announces.
Expected<LoadedBundles> read_bnd(std::string_view bytes, const std::string& file, std::span<const KnownLayer> known);

}  // namespace mes
