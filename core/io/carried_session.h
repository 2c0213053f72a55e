// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions in pictures and figures: what `core/base/carried_session.h` describes, written and read.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/session.h"

namespace mes {

/// The text of the session, compressed; nothing where it is longer than a picture may carry. Throws std::bad_alloc.
std::optional<std::string> packed_session(const Session& session);

/// What names of files end in that may carry a session, with the dot.
inline constexpr std::array<std::string_view, 4> kCarrierExtensions{".png", ".svg", ".pdf", ".ipe"};

/// How the manifest of recorded frames begins.
inline constexpr std::string_view kManifestBeginning = "{\n \"mesecina\": \"take\",";
bool looks_like_manifest(std::string_view bytes);

/// Whether a file that begins so is of a kind that may carry a session: PNG, SVG, Ipe, PDF, a manifest of frames.
bool may_carry_session(std::string_view bytes);

/// Whether a PNG picture has a session where this program writes it, before the pixels: a look at the beginning of the
/// file. False for a file that cannot be read.
bool is_picture_with_session(const std::filesystem::path& file);

/// The text of the session that a file carries; nothing where it carries none. The first one counts. Nothing else of
/// the file is checked. Cost: one pass over the bytes. Error: `bad_input` for one that is cut, broken or too long.
/// Throws std::bad_alloc.
Expected<std::optional<std::string>> carried_session(std::string_view bytes, const std::string& file);

}  // namespace mes
