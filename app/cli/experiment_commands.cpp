// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "app/cli/command_options.h"
#include "app/cli/commands/commands.h"

namespace mes::cli {

void describe_experiment_commands(CLI::App& app, NewRequest& to_begin, CheckRequest& to_check) {
  CLI::App* const begin = app.add_subcommand("new", "The source of an experiment to begin with");
  std::string things;
  for (const std::string& thing : things_to_begin()) things += (things.empty() ? "" : "|") + thing;
  begin->add_option("WHAT", to_begin.what, things)->required();
  begin->add_option("NAME", to_begin.name, "Its id: small letters, digits and hyphens")->required();
  begin->add_option("-o,--output", to_begin.output,
                    "Write to this file instead of NAME.cpp, or - for standard output");
  begin->add_flag("--force", to_begin.force, "Overwrite the file if there is one");

  CLI::App* const check = app.add_subcommand(
      "check", "What an experiment has to hold: updates, degenerate input, numbers, threads, time");
  check->add_option("FILE", to_check.files, "Experiments, or folders of them, each after those that it reads")
      ->required();
}

}  // namespace mes::cli
