// SPDX-License-Identifier: GPL-3.0-or-later
// Options shared by several commands, and commands that are described in files of their own.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/requests/requests.h"

namespace mes {
class Registry;
}

namespace mes::cli {

/// The ids in one text: "circle, ellipse, ...".
std::string ids_of(const auto& descriptors) {
  std::string out;
  for (const auto& descriptor : descriptors) {
    if (!out.empty()) out += ", ";
    out += descriptor.id;
  }
  return out;
}

/// Adds the options for turning a picture or a map into samples.
void add_reading(const Registry& registry, CLI::App& command, ReadingOptions& reading);
void add_force(CLI::App& command, bool& force);

void add_format(const Registry& registry, CLI::App& command, std::string& from);
/// Adds the option for the file of the results.
void add_output(CLI::App& command, std::string& output);
void add_output(CLI::App& command, std::string& output, bool& force);
void add_source(const Registry& registry, CLI::App& command, Source& source);

/// Adds the arguments for the input; they fill `file`, `from` and `reading` of the request.
template <class Request>
void add_input(const Registry& registry, CLI::App& command, Request& request,
               const char* what = "Samples to read, or - for standard input") {
  command.add_option("FILE", request.file, what)->required();
  add_format(registry, command, request.from);
  add_reading(registry, command, request.reading);
}

// Each of these adds a command.
void describe_compute(const Registry& registry, CLI::App& app, ComputeRequest& to);
void describe_sweep(const Registry& registry, CLI::App& app, SweepRequest& to);
void describe_branches(const Registry& registry, CLI::App& app, BranchesRequest& to);
void describe_centerline(const Registry& registry, CLI::App& app, CenterlineRequest& to);
void describe_persistence(const Registry& registry, CLI::App& app, PersistenceRequest& to);
void describe_repair(const Registry& registry, CLI::App& app, ResampleRequest& to);
void describe_decimate(const Registry& registry, CLI::App& app, ResampleRequest& to);
void describe_export(const Registry& registry, CLI::App& app, ExportRequest& to);
void describe_render(const Registry& registry, CLI::App& app, RenderRequest& to);
void describe_play(CLI::App& app, PlayRequest& to);
void describe_demo(CLI::App& app, DemoRequest& to);
void describe_lesson(CLI::App& app, LessonRequest& to);
void describe_evolve(const Registry& registry, CLI::App& app, EvolveRequest& to);
void describe_shape(CLI::App& app, ShapeCommand& to);
void describe_sample(const Registry& registry, CLI::App& app, SampleRequest& to);
void describe_text(CLI::App& app, TextCommand& to);
void describe_experiment_commands(CLI::App& app, NewRequest& to_begin, CheckRequest& to_check);

}  // namespace mes::cli
