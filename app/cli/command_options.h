// SPDX-License-Identifier: GPL-3.0-or-later
// Options that several commands have, and commands that are described in files of their own.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/requests.h"

namespace mes::cli {

/// "circle, ellipse, ...".
std::string ids_of(const auto& descriptors) {
  std::string out;
  for (const auto& descriptor : descriptors) {
    if (!out.empty()) out += ", ";
    out += descriptor.id;
  }
  return out;
}

/// How a picture or a map becomes samples.
void add_reading(CLI::App& command, ReadingOptions& reading);
void add_force(CLI::App& command, bool& force);

// Each adds a command and returns it.
CLI::App* describe_shape(CLI::App& app, ShapeCommand& to);
CLI::App* describe_sample(CLI::App& app, SampleRequest& to);
CLI::App* describe_text(CLI::App& app, TextCommand& to);

}  // namespace mes::cli
