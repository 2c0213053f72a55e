// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs as files in folders.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace mes::fuzz {

struct Input {
  std::string bytes;
  std::string name;  ///< where it comes from
};

/// The files named, and those in the folders named, each kind by name; folders that are not there are empty. Ends the
/// process when a file cannot be read.
std::vector<Input> read_inputs(std::span<const std::filesystem::path> places);

/// Writes the bytes under a name that follows from them; returns the file. Ends the process when that fails.
std::filesystem::path keep_input(const std::filesystem::path& folder, const std::string& prefix,
                                 const std::string& bytes);

}  // namespace mes::fuzz
