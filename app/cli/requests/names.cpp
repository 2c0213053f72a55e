// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/names.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "app/cli/console/messages.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

std::vector<std::string_view> layer_ids(const Registry& registry) {
  std::vector<std::string_view> ids;
  for (const LayerDescriptor& layer : registry.layers())
    if (!layer.is_removed) ids.push_back(layer.id);
  return ids;
}

}  // namespace

std::string unknown_word(std::string_view what, std::string_view word, std::span<const std::string_view> names) {
  return fmt::format("unknown {} {}; did you mean {}?", what, in_quotes(word), one_of(nearest_names(word, names)));
}

std::vector<std::string_view> split_list(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::vector<std::string_view> nearest_names(std::string_view word, std::span<const std::string_view> names) {
  constexpr std::size_t kLongestWord = 64;
  constexpr std::size_t kMost = 3;
  word = word.substr(0, kLongestWord);
  // The shortest names that contain the word are best.
  const auto score = [word](std::string_view name) -> std::pair<std::size_t, std::size_t> {
    const bool one_in_other = word.size() >= 3 && (name.contains(word) || word.contains(name));
    return one_in_other ? std::pair(std::size_t{1}, name.size())
                        : std::pair(edit_distance(word, name), std::size_t{0});
  };
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::string_view>> ranked;
  for (const std::string_view name : names) ranked.emplace_back(score(name), name);
  std::ranges::stable_sort(ranked, {}, [](const auto& one) { return one.first; });
  std::vector<std::string_view> out;
  for (const auto& [order, name] : ranked) {
    // Poor guesses after a good one would only be noise.
    if (out.size() == kMost || (!out.empty() && order.first > ranked.front().first.first + 2)) break;
    out.push_back(name);
  }
  return out;
}

std::string one_of(std::span<const std::string_view> names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i != 0) out += i + 1 == names.size() ? " or " : ", ";
    out += names[i];
  }
  return out;
}

Expected<LayerIndex> select_layer(const Registry& registry, const std::string& id) {
  const LayerIndex layer = registry.find_layer(id);
  if (layer != kNoLayer) return layer;
  return usage_error(unknown_word("layer", id, layer_ids(registry)) + " (mesecina list layers)");
}

Expected<std::vector<LayerIndex>> select_layers(const Registry& registry, const std::string& ids) {
  const auto descriptors = registry.layers();
  std::vector<LayerIndex> layers;
  if (ids.empty() || ids == "all") {
    for (LayerIndex layer = 0; layer < descriptors.size(); ++layer)
      if (!descriptors[layer].is_removed && (ids == "all" || descriptors[layer].visible_at_start))
        layers.push_back(layer);
    return layers;
  }
  for (const std::string_view word : split_list(ids)) {
    if (word == "all") return usage_error("the word \"all\" stands alone, not among other layers");
    const auto layer = select_layer(registry, std::string(word));
    if (!layer) return std::unexpected(layer.error());
    if (std::ranges::find(layers, *layer) == layers.end()) layers.push_back(*layer);
  }
  return layers;
}

Expected<Precision> select_precision(const std::string& id) {
  std::vector<std::string_view> ids;
  for (const PrecisionDescriptor& descriptor : kPrecisionDescriptors) {
    if (descriptor.id == id) return descriptor.precision;
    ids.push_back(descriptor.id);
  }
  return usage_error(fmt::format("unknown number type {}; it is one of {}", in_quotes(id), one_of(ids)));
}

Expected<std::pair<std::size_t, double>> parse_setting(const std::string& setting,
                                                       std::span<const Parameter> parameters, std::string_view option,
                                                       bool is_quiet) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || equals == 0)
    return usage_error(std::string(option) + " expects NAME=VALUE, not " + in_quotes(setting));
  const std::string_view name = std::string_view(setting).substr(0, equals);
  const std::string_view text = std::string_view(setting).substr(equals + 1);
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.id);
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    return usage_error(unknown_word("parameter", name, names) + " (mesecina list parameters)");
  const auto index = static_cast<std::size_t>(found - names.begin());
  const Parameter& parameter = parameters[index];
  const auto value = parse_number(text);
  const auto expected = [&] {
    std::string out = fmt::format("{} {} expects a {} from ", option, printable(name),
                                  parameter.is_whole ? "whole number" : "number");
    append_number(out, parameter.low);
    out += " to ";
    append_number(out, parameter.high);
    return usage_error(out + ", not " + in_quotes(text));
  };
  if (parameter.is_whole && (!value || *value != std::floor(*value))) return expected();
  if (!value) return usage_error(fmt::format("{} {}: {}", option, printable(name), describe(value.error(), text)));
  const bool is_outside = *value < parameter.low || *value > parameter.high;
  if (is_outside && parameter.is_limit) {
    const double end = *value < parameter.low ? parameter.low : parameter.high;
    std::string text_of_end;
    append_number(text_of_end, end);
    if (!is_quiet)
      say(fmt::format("{} {}: {} is {} {}, which is taken instead", option, printable(name), in_quotes(text),
                      *value < parameter.low ? "below" : "above", text_of_end));
    return std::pair{index, end};
  }
  if (is_outside) return expected();
  return std::pair{index, *value};
}

Expected<std::shared_ptr<const Evolution>> select_evolution(const Registry& registry, const std::string& id) {
  if (auto found = registry.evolutions().find(id)) return found;
  const auto all = registry.evolutions().ids();
  const std::vector<std::string_view> ids(all.begin(), all.end());
  return usage_error(fmt::format("unknown evolution {}; it is one of {}", in_quotes(id), one_of(ids)));
}

Expected<std::uint64_t> whole_number(std::string_view what, const std::string& text, std::uint64_t least,
                                     std::uint64_t most) {
  const auto value = parse_count(text);
  if (value && *value >= least && *value <= most) return *value;
  const bool is_any = most == std::numeric_limits<std::uint64_t>::max();
  return usage_error(fmt::format("{} expects a whole number from {} to {}, not {}", what, least,
                                 is_any ? "2^64 - 1" : std::to_string(most), in_quotes(text)));
}

Expected<ComputationSettings> settings_of(const Registry& registry, const Source& source,
                                          const ComputationSettings& base, bool is_quiet) {
  ComputationSettings settings = base;
  if (!source.precision.empty()) {
    const auto precision = select_precision(source.precision);
    if (!precision) return std::unexpected(precision.error());
    settings.precision = *precision;
  }
  for (const std::string& setting : source.settings) {
    const auto parsed = parse_setting(setting, registry.parameters(), "--set", is_quiet);
    if (!parsed) return std::unexpected(parsed.error());
    settings[registry.parameters()[parsed->first]] = parsed->second;
  }
  return settings;
}

}  // namespace mes::cli
