// SPDX-License-Identifier: GPL-3.0-or-later
// Where results go: a file that appears whole, or standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/interruption.h"
#include "core/base/error.h"
#include "core/io/file_fingerprint.h"

namespace mes::cli {

/// True for no name and for "-".
bool is_standard_output(const std::string& file);

/// Checks that the output can be written, before the work for it begins.
Expected<void> check_output(const std::string& file);

/// Files that writing a result must not destroy.
struct Overwriting {
  std::vector<SourceFile>
      sources{};       ///< files the result was made of: none of them is overwritten once it has changed
  bool force = false;  ///< unless this is set
};

Expected<void> write_output(const std::string& file, std::string_view bytes, Interruption& interruption,
                            const Overwriting& overwriting = {});

}  // namespace mes::cli
