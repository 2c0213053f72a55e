// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/compiler.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/system/child_process.h"
#include "app/system/data_folder.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/file_fingerprint.h"
#include "core/io/files/read_file.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFlagsMark = "// mesecina-flags:";

std::vector<std::string> arguments_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Finds the installed headers, or those of the sources that the program was built from.
std::optional<fs::path> find_headers() {
  std::vector<fs::path> candidates;
  if (const std::string given = environment("MESECINA_INCLUDE"); !given.empty()) candidates.emplace_back(given);
  std::error_code error;
  if (const fs::path self = fs::read_symlink("/proc/self/exe", error); !error) {
    candidates.push_back(self.parent_path() / "../include");
    candidates.push_back(self.parent_path() / "../../core/library");
  }
  candidates.emplace_back("/usr/include");
  for (const fs::path& folder : candidates)
    if (fs::exists(folder / "mesecina/experiment.h", error)) return fs::weakly_canonical(folder, error);
  return {};
}

/// Cuts a number and the colon after it off the beginning of the text.
std::optional<std::uint64_t> take_number(std::string_view& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end == text.data() + text.size() || *end != ':') return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
  return value;
}

std::optional<CompilerMessage> message_in(std::string_view line) {
  // The format is FILE:LINE:COLUMN: error: TEXT. The name of the file may contain colons, too.
  for (std::size_t colon = line.find(':'); colon != std::string_view::npos; colon = line.find(':', colon + 1)) {
    std::string_view rest = line.substr(colon + 1);
    const auto number = take_number(rest);
    if (!number) continue;
    CompilerMessage out{.file = std::string(line.substr(0, colon)), .line = *number};
    if (const auto column = take_number(rest)) out.column = *column;
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    for (const std::string_view word : {"fatal error: ", "error: ", "warning: "}) {
      if (!rest.starts_with(word)) continue;
      out.is_error = word != "warning: ";
      out.text = rest.substr(word.size());
      return out;
    }
  }
  return {};
}

std::string hexadecimal(const FileFingerprint& print) {
  return fmt::format("{:x}-{:016x}", print.size, print.hash);
}

/// Reads the files that a source includes from the `make` format: "target: a b \".
std::vector<fs::path> dependencies_in(const fs::path& file) {
  const auto text = read_regular_file(file);
  std::vector<fs::path> out;
  if (!text) return out;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty() && !word.ends_with(':')) out.emplace_back(word);
    word.clear();
  };
  for (std::size_t i = 0; i < text->size(); ++i) {
    const char c = (*text)[i];
    if (c == '\\' && i + 1 < text->size()) {
      const char next = (*text)[++i];
      if (next == '\n')
        end_word();
      else
        word += next;  // an escaped blank in a name
    } else if (c == ' ' || c == '\n') {
      end_word();
    } else {
      word += c;
    }
  }
  end_word();
  return out;
}

/// Fingerprints of these files, one per line; nothing if a file cannot be read.
std::optional<std::string> fingerprints_of(const std::vector<fs::path>& files) {
  std::string out;
  for (const fs::path& file : files) {
    const auto print = fingerprint_of_file(file);
    if (!print) return {};
    out += hexadecimal(*print) + ' ' + file.string() + '\n';
  }
  return out;
}

/// Identifies the compiler by its file, because another of the same name may replace it.
std::string identity_of(const std::string& program) {
  std::error_code error;
  fs::path file = program;
  if (file.is_relative() && program.find('/') == std::string::npos) {
    std::istringstream path(environment("PATH"));
    for (std::string folder; std::getline(path, folder, ':');)
      if (fs::exists(fs::path(folder) / program, error)) {
        file = fs::path(folder) / program;
        break;
      }
  }
  const auto size = fs::file_size(file, error);
  if (error) return program;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return fmt::format("{} {} {}", file.string(), size, time);
}

/// The words of a command before and after the files.
struct CommandWords {
  std::vector<std::string> before;
  std::vector<std::string> after;
};

CommandWords words_for(const Compiler& compiler, std::string_view text) {
  CommandWords out{.before = compiler.command, .after = {}};
  for (const char* word : {"-std=c++20", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-Wall", "-I"})
    out.before.emplace_back(word);
  out.before.push_back(compiler.headers.string());
  // Keeps static variables of two versions apart. Clang does so by default.
  if (compiler.command.front().find("clang") == std::string::npos) out.before.emplace_back("-fno-gnu-unique");
  for (std::size_t at = text.find(kFlagsMark); at != std::string_view::npos; at = text.find(kFlagsMark, at + 1)) {
    const std::size_t begin = at + kFlagsMark.size();
    for (std::string& word : arguments_of(text.substr(begin, text.find('\n', begin) - begin)))
      out.after.push_back(std::move(word));
  }
  return out;
}

/// A name that differs for another text, path, option list, compiler or version of the program.
std::string cache_name(const Compiler& compiler, const CommandWords& words, const fs::path& source,
                       std::string_view text) {
  std::string identity =
      identity_of(compiler.command.front()) + '\n' + source.string() + '\n' + MESECINA_VERSION "\n";
  for (const auto* several : {&words.before, &words.after})
    for (const std::string& word : *several) identity += word + '\n';
  return source.stem().string() + '-' + hexadecimal(fingerprint_of(identity)) + '-' +
         hexadecimal(fingerprint_of(text));
}

/// True if the library exists and the included files have not changed since its compilation.
bool is_as_compiled(const fs::path& library, const fs::path& inputs) {
  std::error_code error;
  const auto known = read_regular_file(inputs);
  if (!known || !fs::exists(library, error)) return false;
  std::vector<fs::path> files;
  std::istringstream lines(*known);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t blank = line.find(' '); blank != std::string::npos)
      files.emplace_back(line.substr(blank + 1));
  return fingerprints_of(files) == *known;
}

std::optional<Error> first_error(const std::vector<CompilerMessage>& messages) {
  const auto first = std::ranges::find(messages, true, &CompilerMessage::is_error);
  if (first == messages.end()) return {};
  const auto count = std::ranges::count(messages, true, &CompilerMessage::is_error);
  return Error{.code = ErrorCode::bad_input,
               .text = first->text + (count > 1 ? fmt::format(" (and {} more)", count - 1) : ""),
               .file = first->file,
               .line = first->line,
               .column = first->column};
}

}  // namespace

std::vector<CompilerMessage> compiler_messages(std::string_view output) {
  std::vector<CompilerMessage> out;
  while (!output.empty()) {
    const std::string_view line = output.substr(0, output.find('\n'));
    output.remove_prefix(std::min(output.size(), line.size() + 1));
    if (auto message = message_in(line)) out.push_back(*std::move(message));
  }
  return out;
}

Expected<Compiler> Compiler::find(std::string_view wanted) {
  Compiler out;
  const auto failure = [](std::string text) { return std::unexpected(Error{ErrorCode::bad_input, std::move(text)}); };
  out.command = arguments_of(wanted);
  if (out.command.empty()) out.command = arguments_of(environment("CXX"));
  for (const char* name : {"g++", "clang++", "c++"})
    if (out.command.empty() && is_program_on_path(name)) out.command = {name};
  if (out.command.empty()) return failure("there is no C++ compiler; install g++ or name one by CXX");
  if (out.command.front().find('/') == std::string::npos && !is_program_on_path(out.command.front()))
    return failure("there is no compiler " + out.command.front());
  const auto headers = find_headers();
  if (!headers) return failure("there is no <mesecina/experiment.h>; install the package libmesecina-dev");
  out.headers = *headers;
  out.cache = cache_folder();
  if (out.cache.empty()) return failure("there is no home folder to keep compiled experiments in");
  out.cache /= "experiments";
  return out;
}

Expected<CompiledExperiment> compile_experiment(const Compiler& compiler, const fs::path& source,
                                                const std::stop_token& stop, std::vector<CompilerMessage>& messages) {
  messages.clear();
  const auto failure = [&source](ErrorCode code, std::string text) {
    return std::unexpected(Error{.code = code, .text = std::move(text), .file = source.string()});
  };
  const auto text = read_regular_file(source);
  if (!text) return std::unexpected(text.error());
  std::error_code error;
  const fs::path full = fs::absolute(source, error);
  fs::create_directories(compiler.cache, error);
  if (error) return failure(ErrorCode::cannot_write, compiler.cache.string() + ": " + error.message());

  const CommandWords words = words_for(compiler, *text);
  const std::string name = cache_name(compiler, words, full, *text);
  const fs::path library = compiler.cache / (name + ".so");
  const fs::path inputs = compiler.cache / (name + ".inputs");
  if (is_as_compiled(library, inputs)) return CompiledExperiment{.library = library, .was_there = true};

  // The messages are parsed here, so they must be in English.
  std::vector<std::string> command{"env", "LC_ALL=C"};
  command.insert(command.end(), words.before.begin(), words.before.end());
  const fs::path part = compiler.cache / fmt::format("{}.{}.part", name, ::getpid());
  const fs::path listed = part.string() + ".d";
  for (const std::string& word :
       {std::string("-MMD"), std::string("-MF"), listed.string(), std::string("-o"), part.string(), full.string()})
    command.push_back(word);
  command.insert(command.end(), words.after.begin(), words.after.end());
  ChildProcess process;
  if (const int reason = process.start(command, full.parent_path()); reason != 0)
    return failure(ErrorCode::bad_input, fmt::format("{} cannot be started: {}", compiler.command.front(),
                                                     std::generic_category().message(reason)));
  const bool is_compiled = process.wait(stop);
  messages = compiler_messages(process.complaints());
  const auto prints = fingerprints_of(dependencies_in(listed));
  fs::remove(listed, error);
  if (stop.stop_requested() || !is_compiled) fs::remove(part, error);
  if (stop.stop_requested()) return failure(ErrorCode::cancelled, "stopped");
  if (!is_compiled) {
    if (auto first = first_error(messages)) return std::unexpected(*std::move(first));
    const std::string last_line = process.complaint();
    return failure(ErrorCode::bad_input,
                   "it does not compile: " + (last_line.empty() ? "the compiler says nothing" : last_line));
  }
  fs::rename(part, library, error);
  if (error) return failure(ErrorCode::cannot_write, library.string() + ": " + error.message());
  // If this write fails, the source is compiled again next time.
  if (prints) static_cast<void>(write_file_atomically(inputs, *prints));
  return CompiledExperiment{.library = library};
}

}  // namespace mes
