// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>

#include "app/cli/command_options.h"
#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/manual/command_help.h"
#include "app/cli/manual/completions.h"
#include "app/cli/manual/manual.h"
#include "app/cli/requests/names.h"
#include "app/experiments/experiment.h"
#include "app/experiments/trial.h"
#include "core/base/geometry/coordinate_range.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

constexpr const char* kExamples = R"(Examples:
  mesecina shape.poff
  mesecina compute shape.poff --layers medial-axis,curve
  mesecina render shape.poff --layers interior-voronoi-disks,curve,medial-axis,points -o shape.png
  mesecina export shape.poff --layer medial-axis --format csv -o axis.csv
  mesecina evolve shape.poff --evolution smooth --steps 12 -o smooth.poff
  mesecina list layers

Exit codes: 0 done, 1 could not be completed, 2 usage, 3 bad input, 4 output impossible (or no display), 130 interrupted.)";

/// Everything that the parser fills in.
struct Arguments {
  WindowRequest window;
  ComputeRequest compute;
  SweepRequest sweep;
  BranchesRequest branches;
  CenterlineRequest centerline;
  PersistenceRequest persistence;
  ResampleRequest repair;
  ResampleRequest decimate;
  ExportRequest exported;
  RenderRequest render;
  PlayRequest play;
  DemoRequest demo;
  LessonRequest lesson;
  EvolveRequest evolve;
  ShapeCommand shape;
  SampleRequest sample;
  TextCommand text;
  ListRequest list;
  NewRequest begin;
  CheckRequest check;
  ManualRequest manual;
  CompletionsRequest completions;
};

/// Breaks the text into lines of some hundred characters, all but the first indented.
std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t kWidth = 100;
  std::string out;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column + end > kWidth) {
      out.back() = '\n';
      out.append(indent, ' ');
      column = indent;
    }
    out.append(text.substr(0, end)) += ' ';
    column += end + 1;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  out.pop_back();
  return out;
}

void add_experiments(CLI::App& command, std::vector<std::string>& experiments) {
  command
      .add_option(
          "--with", experiments,
          "An experiment, or a folder of them: C++ sources, which are compiled, shared libraries, or files of Python")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void describe_commands(const Registry& registry, CLI::App& app, Arguments& to) {
  app.name("mesecina");
  app.description(
      "Sample-based geometry in the plane, live: Delaunay, Voronoi, one-step crust, inner balls, medial axis.\n"
      "With FILEs or nothing it opens the window; every result can also be had without one.");
  app.set_version_flag("--version", "mesecina " MESECINA_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.add_option("FILE", to.window.files, "Samples to open in the window");
  app.add_flag("--present", to.window.presents, "Present the lesson that FILE holds");
  app.option_defaults()->always_capture_default(false);
  app.require_subcommand(0, 1);

  describe_compute(registry, app, to.compute);
  describe_sweep(registry, app, to.sweep);
  describe_branches(registry, app, to.branches);
  describe_centerline(registry, app, to.centerline);
  describe_persistence(registry, app, to.persistence);
  describe_repair(registry, app, to.repair);
  describe_decimate(registry, app, to.decimate);
  describe_export(registry, app, to.exported);
  describe_render(registry, app, to.render);
  describe_play(app, to.play);
  describe_demo(app, to.demo);
  describe_lesson(app, to.lesson);
  describe_evolve(registry, app, to.evolve);
  describe_shape(app, to.shape);
  describe_sample(registry, app, to.sample);
  describe_text(app, to.text);
  describe_experiment_commands(app, to.begin, to.check);

  CLI::App* const list = app.add_subcommand("list", "What there is to name");
  std::string things;
  for (const std::string& thing : listed_things()) things += (things.empty() ? "" : "|") + thing;
  list->add_option("WHAT", to.list.what, things)->required();
  list->add_flag("--json", to.list.as_json, "As JSON");

  CLI::App* const manual =
      app.add_subcommand("manual", "All keys, layers, parameters, formats, commands: as Markdown");
  manual->add_flag("--man", to.manual.as_man_page, "The commands and keys as a man page instead");
  add_output(*manual, to.manual.output);

  CLI::App* const completions =
      app.add_subcommand("completions", "A script that completes commands and options in a shell");
  completions->add_option("SHELL", to.completions.shell, "bash, zsh or fish")->required();
  add_output(*completions, to.completions.output);

  add_experiments(app, to.window.experiments);
  for (CLI::App* const command : app.get_subcommands({})) {
    command->set_help_flag("-h,--help", "Print this help and exit");
    add_experiments(*command, to.window.experiments);
  }
  // An empty value is most likely an unset variable of a script, and never means the same as a missing option.
  const auto is_not_empty = [](const std::string& value) { return std::string(value.empty() ? "is empty" : ""); };
  for (CLI::App* const command : app.get_subcommands({}))
    for (CLI::Option* const option : command->get_options())
      if (option->get_expected_max() > 0) option->check(is_not_empty);
  name_values(app);
  // Set last, because otherwise each command would inherit it.
  app.footer(std::string(kExamples) + "\n\nInput: " + wrapped(coordinate_range_in_words(), 7));
}

/// Help of the program itself, followed by its commands.
std::vector<CommandHelp> all_commands(const Registry& registry) {
  // Uses a parser that has parsed nothing, because parsing changes the displayed defaults.
  CLI::App app;
  Arguments arguments;
  describe_commands(registry, app, arguments);
  return help_of(app);
}

Expected<void> run_command(const Registry& registry, const CLI::App& command, const Arguments& arguments) {
  Interruption interruption;
  const auto run = [&](const auto& request, auto function) -> Expected<void> {
    if (const auto good = settings_of(registry, request.source, {}, true); !good)
      return std::unexpected(good.error());
    return function(registry, request, interruption);
  };
  if (command.get_name() == "compute") return run(arguments.compute, run_compute);
  if (command.get_name() == "sweep") return run(arguments.sweep, run_sweep);
  if (command.get_name() == "branches") return run(arguments.branches, run_branches);
  if (command.get_name() == "centerline") return run_centerline(registry, arguments.centerline, interruption);
  if (command.get_name() == "persistence") return run(arguments.persistence, run_persistence);
  if (command.get_name() == "repair") return run_repair(registry, arguments.repair, interruption);
  if (command.get_name() == "decimate") return run_decimate(registry, arguments.decimate, interruption);
  if (command.get_name() == "export") return run(arguments.exported, run_export);
  if (command.get_name() == "render") return run(arguments.render, run_render);
  if (command.get_name() == "demo") return run_demo(registry, arguments.demo, interruption);
  if (command.get_name() == "lesson") return run_lesson(registry, arguments.lesson, interruption);
  if (command.get_name() == "play") return run_play(registry, arguments.play, interruption);
  if (command.get_name() == "evolve") return run_evolve(registry, arguments.evolve, interruption);
  if (command.get_name() == "shape") return run_shape(registry, arguments.shape, interruption);
  if (command.get_name() == "sample") return run_sample(registry, arguments.sample, interruption);
  if (command.get_name() == "text") return run_text(arguments.text, interruption);
  if (command.get_name() == "new") return run_new(registry, arguments.begin, interruption);
  if (command.get_name() == "check") return run_check(registry, arguments.check, interruption);
  if (command.get_name() == "manual")
    return run_manual(registry, arguments.manual, all_commands(registry), interruption);
  if (command.get_name() == "completions")
    return run_completions(registry, arguments.completions, all_commands(registry), interruption);
  return run_list(registry, arguments.list, interruption);
}

/// Message for unknown options and surplus arguments.
std::string words_of_extra(const CLI::App& command, std::string_view word) {
  if (!word.starts_with('-') || word == "-") return "unexpected " + in_quotes(word);
  word = word.substr(0, word.find('='));
  std::vector<std::string> options;
  for (const CLI::Option* const option : command.get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  const std::vector<std::string_view> names(options.begin(), options.end());
  const std::vector<std::string_view> nearest = nearest_names(word, names);
  const bool is_near = !nearest.empty() && 3 * edit_distance(word, nearest.front()) <= word.size();
  return "there is no option " + in_quotes(word) +
         (is_near ? "; did you mean " + std::string(nearest.front()) + '?' : "");
}

/// Rewrites messages of CLI11, which are meant for programmers.
std::string words_of(const CLI::App& app, const CLI::ParseError& error) {
  const std::string text = error.what();
  const auto chosen = app.get_subcommands();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    if (const auto extra = app.remaining(true); !extra.empty())
      return words_of_extra(chosen.empty() ? app : *chosen.front(), extra.front());
  constexpr std::string_view kMissing = " missing";
  constexpr std::string_view kRequired = ": 1 required ";
  constexpr std::string_view kNoFlag = "Could not convert: ";
  if (const std::size_t at = text.find(kRequired); at != std::string::npos && text.ends_with(kMissing)) {
    const std::size_t type = at + kRequired.size();
    return text.substr(0, at) + " expects " + text.substr(type, text.size() - kMissing.size() - type);
  }
  if (const std::size_t at = text.find(": At Most 1 required but"); at != std::string::npos)
    return text.substr(0, at) + " is given more than once";
  if (const std::size_t at = text.find(" = "); at != std::string::npos && text.starts_with(kNoFlag))
    return text.substr(kNoFlag.size(), at - kNoFlag.size()) + " expects no value, or true or false, not " +
           in_quotes(text.substr(at + 3));
  return text;
}

/// Reports a fault in the command's words, in one line with a pointer to the help.
int refuse(const CLI::App& app, const std::string& text) {
  std::string line = text;
  std::ranges::replace(line, '\n', ' ');
  while (line.ends_with(' ') || line.ends_with('.')) line.pop_back();
  std::string command = "mesecina";
  for (const CLI::App* chosen : app.get_subcommands()) command += ' ' + chosen->get_name();
  return report({ErrorCode::usage, line + "; see " + command + " --help", {}, 0, 0});
}

/// An error if the first word is not a file and does not look like a file name; it suggests a command that resembles it.
std::optional<Error> mistaken_command(const CLI::App& app, const std::vector<std::string>& files) {
  if (files.empty() || files.front().find_first_of("./") != std::string::npos) return std::nullopt;
  const std::string& word = files.front();
  if (word.empty() || std::filesystem::exists(word)) return std::nullopt;
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  const std::vector<std::string_view> names(commands.begin(), commands.end());
  constexpr std::size_t kMostMistakes = 2;
  const std::string_view nearest = nearest_names(word, names).front();
  if (nearest == word) return std::nullopt;
  if (edit_distance(word, nearest) > kMostMistakes)
    return Error{ErrorCode::usage, in_quotes(word) + " is neither a command nor a file; see mesecina --help"};
  return Error{ErrorCode::usage,
               "unknown command " + in_quotes(word) + "; did you mean " + std::string(nearest) + '?',
               {},
               0,
               0};
}

int run(const Registry& registry, int argc, const char* const* argv, const OpenWindow& open_window, int link = -1) {
  CLI::App app;
  Arguments arguments;
  describe_commands(registry, app, arguments);
  // `mesecina help` and `mesecina help COMMAND` are what other programs have.
  std::vector<const char*> words(argv, argv + argc);
  if (argc >= 2 && std::string_view(argv[1]) == "help") {
    words.erase(words.begin() + 1);
    words.resize(std::min<std::size_t>(words.size(), 2));
    if (words.size() == 2)
      if (const auto mistake = mistaken_command(app, {words[1]})) return report(*mistake);
    words.push_back("--help");
  }
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::Success& done) {
    // Help and version are results, so they are written to stdout.
    const int code = app.exit(done);
    return std::fflush(stdout) == 0 ? code
                                    : report({ErrorCode::cannot_write, "cannot be written", "standard output", 0, 0});
  } catch (const CLI::ParseError& error) {
    if (app.get_subcommands().empty())
      if (const auto mistake = mistaken_command(app, app["FILE"]->as<std::vector<std::string>>()))
        return report(*mistake);
    return refuse(app, words_of(app, error));
  }
  if (const auto chosen = app.get_subcommands(); !chosen.empty()) {
    if (!arguments.window.files.empty())
      return refuse(app, "unexpected " + in_quotes(arguments.window.files.front()));
    if (arguments.window.presents) return refuse(app, "unexpected --present");
    const auto extended = with_experiments(registry, arguments.window.experiments);
    if (!extended) return report(extended.error());
    const auto done = run_command(**extended, *chosen.front(), arguments);
    return done ? kExitDone : report(done.error());
  }
  if (const auto mistake = mistaken_command(app, arguments.window.files)) return report(*mistake);
  if (arguments.window.presents && arguments.window.files.empty()) return refuse(app, "--present needs a FILE");
  arguments.window.link = link;
  return open_window(std::move(arguments.window));
}

}  // namespace

std::string complete_manual(const Registry& registry, const std::filesystem::path& assets) {
  return manual_text(registry, all_commands(registry), assets);
}

int run_command_line(const Registry& registry, int argc, const char* const* argv, const OpenWindow& open_window) {
  try {
    if (argc == 3 && std::string_view(argv[1]) == kTrialCommand) return run_trial(registry, argv[2]);
    // Another program can start the window and pass it a socket (LinkRun). The help does not list this option.
    if (argc >= 3 && std::string_view(argv[1]) == "--link") {
      std::vector<const char*> words(argv + 2, argv + argc);
      words.front() = argv[0];
      return run(registry, static_cast<int>(words.size()), words.data(), open_window, std::atoi(argv[2]));
    }
    return run(registry, argc, argv, open_window);
  } catch (const std::bad_alloc&) {
    return report({ErrorCode::out_of_memory, "there is not enough memory", {}, 0, 0});
  } catch (const std::system_error& error) {
    return report({ErrorCode::out_of_memory, "the system refuses: " + std::string(error.what()), {}, 0, 0});
  } catch (const std::exception& error) {
    return report({ErrorCode::cannot_compute, error.what(), {}, 0, 0});
  }
}

}  // namespace mes::cli
