// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the sessions in pictures and figures that `core/base/carried_session.h` describes.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// File extensions, with the dot, of the formats that may carry a session.
inline constexpr std::array<std::string_view, 4> kCarrierExtensions{".png", ".svg", ".pdf", ".ipe"};

/// Beginning of the manifest of recorded frames.
inline constexpr std::string_view kManifestBeginning = "{\n \"mesecina\": \"take\",";
bool looks_like_manifest(std::string_view bytes);

/// Whether the first bytes are of a format that may carry a session: PNG, SVG, Ipe, PDF, a manifest of frames.
bool may_carry_session(std::string_view bytes);

/// Whether a PNG picture has a session where this program writes it, before the pixels. Reads only the beginning of the
/// file. False for a file that cannot be read.
bool is_picture_with_session(const std::filesystem::path& file);

/// The text of the first session in a file; nothing if it carries none. The rest of the file is not checked. Cost: one
/// pass over the bytes. Error: `bad_input` for a session that is cut off, broken or too long. Throws std::bad_alloc.
Expected<std::optional<std::string>> carried_session(std::string_view bytes, const std::string& file);

}  // namespace mes
