// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "app/actions/actions.h"
#include "app/actions/palette.h"
#include "app/layers/words/parameter_words.h"
#include "app/layers/words/synonyms.h"
#include "core/base/lower_case.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

/// Actions, layers, parameters and evolutions, as the window lists them.
std::vector<PaletteEntry> entries() {
  std::vector<PaletteEntry> out;
  const auto add = [&out](const char* kind, std::string_view id, std::string_view name,
                          std::string_view explanation) {
    out.push_back({.kind = kind,
                   .name = std::string(name),
                   .explanation = std::string(explanation),
                   .more = std::string(id),
                   .words = synonyms_of(id)});
  };
  for (const ActionDescriptor& action : action_descriptors())
    add("Action", action.public_id, action.name, action.tooltip);
  for (const LayerDescriptor& layer : layer_descriptors()) add("Layer", layer.id, layer.name, layer.tooltip);
  for (const Parameter& parameter : builtins().parameters())
    add("Parameter", parameter.id, title_of(parameter), parameter.explanation);
  for (const auto& evolution : builtins().evolutions().all())
    add("Evolution", evolution->descriptor.id, evolution->descriptor.name, evolution->descriptor.tooltip);
  return out;
}

std::vector<std::string> ids_found(std::string_view query, std::size_t most) {
  const auto all = entries();
  std::vector<std::string> out;
  for (const PaletteHit& hit : find_entries(all, query, {}))
    if (out.size() < most) out.push_back(all[hit.entry].more);
  return out;
}

}  // namespace

TEST_CASE("synonyms belong to something that exists, once, and are in lower case") {
  const auto all = entries();
  std::set<std::string_view> seen;
  for (const Synonyms& synonyms : all_synonyms()) {
    INFO(synonyms.id);
    CHECK(seen.insert(synonyms.id).second);
    CHECK(std::ranges::any_of(all, [&](const PaletteEntry& entry) { return entry.more == synonyms.id; }));
    CHECK(lower_case(synonyms.words) == synonyms.words);
    CHECK_FALSE(synonyms.words.empty());
  }
}

TEST_CASE("what people call a thing finds it among the first") {
  const auto finds = [](std::string_view query, const std::string& id) {
    INFO(query);
    const auto found = ids_found(query, 8);
    std::string list;
    for (const std::string& one : found) list += one + ' ';
    INFO(list);
    CHECK(std::ranges::find(found, id) != found.end());
  };
  finds("prune", "lambda-medial-axis");
  finds("hair", "lambda-medial-axis");
  finds("skeleton", "medial-axis");
  finds("screenshot", "snapshot");
  finds("slides", "presenter-mode");
  finds("html", "export-lesson");
  finds("documentation", "manual");
  finds("font size", "projector-mode");
  finds("font", "write-text");
  finds("print", "export-figure");
  finds("Vectorize", "trace-into-samples");
  finds("ruler", "tool-measure");
  finds("centerline", "center-lines");
  // In either spelling, and not a layer that they would rather see than switch off.
  for (const std::string_view line : {"center line", "centre lines"}) {
    INFO(line);
    CHECK(ids_found(line, 1) == std::vector<std::string>{"center-lines"});
  }
  finds("dark", "toggle-theme");
  finds("movie", "record");
  finds("lfs", "feature-size");
  finds("jitter", "noise");
  // Words of the explanation count last, but they count.
  finds("magnify", "zoom-in");
}

TEST_CASE("letters of a name come before synonyms and explanations that fit no better") {
  CHECK(ids_found("snapshot", 1) == std::vector<std::string>{"snapshot"});
  CHECK(ids_found("delete", 1) == std::vector<std::string>{"delete"});
  CHECK(ids_found("record", 1) == std::vector<std::string>{"record"});
  CHECK(ids_found("screenshot", 9).size() < 9);
  CHECK(ids_found("xyzzy", 1).empty());
}
