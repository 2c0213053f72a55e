// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded sequence of pictures: a folder of its own with numbered PNG files and a manifest.
//
// Guarantees:
//  1. `begin_take` and `claim_file` never take a name that is in use.
//  2. `read_take` understands a take whose recording was cut off: it finds frames missing in the manifest by their
//     file names.
//
// Smallest use:
//     auto take = begin_take(folder, {.width = 1920, .height = 1080, .fps = 30});
//     write(take->folder / frame_name(1), png);
//
// Cost: a few system calls. Threads: any.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// A description of a frame.
struct FrameInfo {
  std::string what{};          ///< the interaction, by its name in the undo menu
  std::uint64_t document = 0;  ///< digest of the displayed document
  double seconds = 0.0;        ///< time since the recording began
};

struct TakeFormat {
  int width = 0;  ///< size of every frame in pixels
  int height = 0;
  double fps = 30.0;  ///< intended rate of playback
};

struct Take {
  std::filesystem::path folder;
  TakeFormat format;
};

/// Makes "take-2026-11-21-101530" in `parent`, which is created if necessary; "-2" and so on make the name unique.
Expected<Take> begin_take(const std::filesystem::path& parent, const TakeFormat& format,
                          std::chrono::system_clock::time_point now = std::chrono::system_clock::now());

/// An empty new file `stem-2026-11-21-101530.extension` with an unused name; the folder is created if necessary.
Expected<std::filesystem::path> claim_file(
    const std::filesystem::path& folder, const std::string& stem, const std::string& extension,
    std::chrono::system_clock::time_point now = std::chrono::system_clock::now());

/// "00001.png".
std::string frame_name(std::uint64_t number);

struct Manifest {
  TakeFormat format;
  bool complete = false;            ///< the recording ended normally
  std::string problem{};            ///< the reason otherwise, if known
  std::vector<FrameInfo> frames{};  ///< frame 1 first
  std::string session{};            ///< `packed_session` of their origin; empty: none
};

inline constexpr const char* kManifestName = "manifest.json";

/// The manifest as JSON; if it holds a session, it can be read as a document (core/io/carried_session.h).
std::string manifest_text(const Manifest& manifest);

/// Reads frames 1, 2, ... up to the first missing file. Without a manifest the format is all zero.
Expected<Manifest> read_take(const std::filesystem::path& folder);

}  // namespace mes
