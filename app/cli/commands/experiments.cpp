// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina new` and `mesecina check`: a skeleton for an experiment, and the checks for it.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/requests.h"
#include "app/experiments/check.h"
#include "app/experiments/experiment.h"
#include "app/store/sample_shapes.h"
#include "core/document/commands.h"
#include "core/graph/registry.h"
#include "core/io/files/read_file.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

namespace fs = std::filesystem;

/// Turns "beta-skeleton" into "BetaSkeleton".
std::string class_name(std::string_view id) {
  std::string out;
  bool begins = true;
  for (const char c : id) {
    if (c != '-') out += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '-';
  }
  return out;
}

/// Turns "my-idea" into "My idea".
std::string title(std::string id) {
  std::ranges::replace(id, '-', ' ');
  if (!id.empty()) id[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(id[0])));
  return id;
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

}  // namespace

std::vector<std::string> things_to_begin() {
  return {"structure", "layer", "evolution", "shape"};
}

Expected<void> run_new(const Registry& registry, const NewRequest& request, Interruption& interruption) {
  const std::vector<std::string> things = things_to_begin();
  if (std::ranges::find(things, request.what) == things.end()) {
    const std::vector<std::string_view> names(things.begin(), things.end());
    return usage_error(fmt::format("there is no beginning of a {}; there are those of {}", in_quotes(request.what),
                                   fmt::format("{}, {}, {} and {}", names[0], names[1], names[2], names[3])));
  }
  if (!is_kebab_case(request.name))
    return usage_error(in_quotes(request.name) + " is no id: small letters and digits, with a hyphen between words");
  if (registry.find_structure(request.name) != nullptr || registry.find_layer(request.name) != kNoLayer ||
      registry.evolutions().find(request.name) != nullptr || registry.shapes().find(request.name) != nullptr)
    return usage_error("the program has " + in_quotes(request.name) + " already; choose another name");
  const fs::path assets = find_assets({});
  auto text = read_regular_file(assets / "experiments" / (request.what + ".cpp"));
  if (!text) return std::unexpected(text.error());
  replace_all(*text, "my-" + request.what, request.name);
  replace_all(*text, class_name("my-" + request.what), class_name(request.name));
  replace_all(*text, title("my-" + request.what), title(request.name));
  const std::string file = request.output.empty() ? request.name + ".cpp" : request.output;
  std::error_code error;
  if (!is_standard_output(file) && !request.force && fs::exists(file, error))
    return cannot_write("the file is there already; --force overwrites it", file);
  if (auto written = write_output(file, *text, interruption); !written) return written;
  if (!is_standard_output(file)) say(fmt::format("{} is written; its first lines say how to show it", file));
  return {};
}

Expected<void> run_check(const Registry& registry, const CheckRequest& request, Interruption& interruption) {
  Registry all = registry;
  std::size_t bad = 0;
  std::string out;
  const auto check = [&](const fs::path& /*file*/, const ExperimentContents& added,
                         const std::vector<CompilerMessage>& messages) {
    for (const CompilerMessage& message : messages) {
      Error warning{.code = ErrorCode::bad_input, .text = "warning: " + message.text, .file = message.file};
      warning.line = message.line;
      warning.column = message.column;
      say(warning.message());
    }
    for (const CheckResult& result : check_experiment(all, added)) {
      out += fmt::format("{:<28} {:<24} {}\n", result.subject, result.property, result.result);
      bad += result.is_good ? 0 : 1;
    }
  };
  if (auto good = add_experiments(all, request.files, check); !good) return good;
  if (auto written = write_output("-", out, interruption); !written) return written;
  if (bad == 0) return {};
  return std::unexpected(Error{ErrorCode::cannot_compute,
                               bad == 1 ? std::string("one check failed") : fmt::format("{} checks failed", bad)});
}

}  // namespace mes::cli
