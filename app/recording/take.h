// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded sequence of pictures: a folder of its own with numbered PNG files and a manifest.
//
// What it guarantees:
//  1. `begin_take` and `claim_file` never take a name that is in use.
//  2. `read_take` understands a take whose recording was cut off: what the manifest does not know yet is found by
//     name.
//
// Smallest use:
//     auto take = begin_take(folder, {.width = 1920, .height = 1080, .fps = 30});
//     write(take->folder / frame_name(1), png);
//
// Cost: a few calls of the system. Threads: any.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace mes {

/// What a frame is of.
struct FrameInfo {
  std::string what{};          ///< the interaction, as the undo menu names it
  std::uint64_t document = 0;  ///< digest of the document that is shown
  double seconds = 0.0;        ///< when, since the recording began
};

struct TakeFormat {
  int width = 0;  ///< pixels of every frame
  int height = 0;
  double fps = 30.0;  ///< at which it is meant to be played
};

struct Take {
  std::filesystem::path folder;
  TakeFormat format;
};

/// "take-2026-11-21-101530" in `parent`, which is made if need be; "-2" and so on are appended until the name is new.
Expected<Take> begin_take(const std::filesystem::path& parent, const TakeFormat& format,
                          std::chrono::system_clock::time_point now = std::chrono::system_clock::now());

/// An empty new file `stem-2026-11-21-101530.extension` whose name was not in use; the folder is created if need be.
Expected<std::filesystem::path> claim_file(
    const std::filesystem::path& folder, const std::string& stem, const std::string& extension,
    std::chrono::system_clock::time_point now = std::chrono::system_clock::now());

/// "00001.png".
std::string frame_name(std::uint64_t number);

struct Manifest {
  TakeFormat format;
  bool complete = false;            ///< the recording ended in order
  std::string problem{};            ///< why it did not, if that is known
  std::vector<FrameInfo> frames{};  ///< frame 1 first
  std::string session{};            ///< `packed_session` of what made them; empty: none
};

inline constexpr const char* kManifestName = "manifest.json";

/// JSON; with a session it can be read as a document (core/io/carried_session.h).
std::string manifest_text(const Manifest& manifest);

/// Frames 1, 2, ... as far as their files are there. Without a manifest the format is all zero.
Expected<Manifest> read_take(const std::filesystem::path& folder);

}  // namespace mes
