// SPDX-License-Identifier: GPL-3.0-or-later
// Writes results to a file, which appears complete or not at all, or to standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/console/interruption.h"
#include "core/base/error.h"
#include "core/io/files/file_fingerprint.h"

namespace mes::cli {

/// True for an empty name and for "-".
bool is_standard_output(const std::string& file);

/// Checks that the output can be written, before the work for it begins.
Expected<void> check_output(const std::string& file);

/// The files that writing a result must not destroy.
struct Overwriting {
  std::vector<SourceFile> sources{};  ///< files the result was made from; a changed one is not overwritten
  bool force = false;                 ///< overwrites it nevertheless
  bool is_of_its_kind = false;        ///< the result is samples as the file is, so it may replace them
};

Expected<void> write_output(const std::string& file, std::string_view bytes, Interruption& interruption,
                            const Overwriting& overwriting = {});

}  // namespace mes::cli
