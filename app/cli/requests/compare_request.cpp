// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/compare_request.h"

#include <fmt/core.h>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "app/cli/console/messages.h"
#include "app/cli/requests/evolution_runner.h"
#include "app/cli/requests/names.h"
#include "app/playing/session_evolution.h"
#include "core/base/lower_case.h"
#include "core/document/settings/layer_configuration.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

constexpr std::string_view kPrecision = "precision";
constexpr std::string_view kFamily = "family";
constexpr std::string_view kBundle = "bundle";
constexpr std::string_view kStep = "step";

bool has_family(const ShownLayers& shown) {
  return std::ranges::any_of(
      shown.layers, [&](VariantLayer layer) { return family_of(shown.descriptors[layer.layer]).has_value(); });
}

ShownLayers with_family(const ShownLayers& shown, FamilyKind family) {
  const LayerConfiguration layers = configuration_of(shown);
  ShownLayers out = shown;
  out.layers.clear();
  for (const LayerConfiguration::Entry& entry : in_family(shown.descriptors, layers, family).layers) {
    if (!entry.visible) continue;
    const LayerIndex layer = find_layer(shown.descriptors, entry.layer);
    if (layer == kNoLayer) continue;
    out.layers.emplace_back(layer);
    out.styles[layer] = entry.style;
  }
  return out;
}

/// The family with this letter in the ids of layers: a, p or b.
std::optional<FamilyKind> family_named(const std::string& letter) {
  for (const FamilyKind family : kBallFamilies)
    if (lower_case(letter) == letter_of(family)) return family;
  return std::nullopt;
}

/// Reads NAME, or NAME:KEY=VALUE[,KEY=VALUE...]; all evolutions have the key `seed`. Missing values are those of
/// `base`.
Expected<EvolutionChoice> evolution_of(const Registry& registry, const std::string& text,
                                       const EvolutionChoice& base) {
  constexpr std::string_view kSeed = "seed=";
  const std::size_t colon = text.find(':');
  const auto evolution = select_evolution(registry, text.substr(0, colon));
  if (!evolution) return std::unexpected(evolution.error());
  EvolutionChoice out = base;
  out.evolution = *evolution;
  if (colon == std::string::npos) return out;
  const auto parameters = parameters_of(**evolution);
  for (const std::string_view setting : split_list(std::string_view(text).substr(colon + 1))) {
    if (setting.starts_with(kSeed)) {
      const auto seed = whole_number("--evolution: seed", std::string(setting.substr(kSeed.size())));
      if (!seed) return std::unexpected(seed.error());
      out.seed = *seed;
      continue;
    }
    const auto parsed = parse_setting(std::string(setting), parameters, "--evolution");
    if (!parsed) return std::unexpected(parsed.error());
    out.values[parameters[parsed->first]] = parsed->second;
  }
  return out;
}

class Reader {
 public:
  Reader(const Registry& registry, const RenderRequest& request, std::span<const render::ColorMap> maps)
      : registry_(registry), request_(request), maps_(maps) {}

  Expected<CompareRequest> read() {
    const std::size_t equals = request_.compared.find('=');
    const std::string subject = request_.compared.substr(0, equals);
    if (equals == std::string::npos)
      return usage_error("--compare expects WHAT=VALUE,VALUE[,VALUE...], not " + in_quotes(request_.compared));
    const std::vector<std::string_view> values = split_list(std::string_view(request_.compared).substr(equals + 1));
    if (values.size() < 2 || values.size() > kMostPanes)
      return usage_error(
          fmt::format("--compare {}: give 2 to {} values, not {}", subject, kMostPanes, values.size()));
    if (std::ranges::any_of(values, &std::string_view::empty))
      return usage_error("--compare " + subject + ": a value is empty");
    for (const std::string_view each : values) {
      const std::string value(each);
      if (auto good = take(subject, value); !good) return std::unexpected(good.error());
      out_.words.push_back(words_of(subject, value));
    }
    if (out_.subject == CompareRequest::Subject::step) {
      if (request_.evolution.empty()) return std::move(out_);
      const auto evolution = evolution_of(registry_, request_.evolution, {});
      if (!evolution) return std::unexpected(evolution.error());
      out_.evolution = *evolution;
    }
    return std::move(out_);
  }

 private:
  using Subject = CompareRequest::Subject;

  static std::string words_of(const std::string& subject, const std::string& value) {
    if (subject == kBundle) return value;
    if (subject == kFamily) return std::string(title_of(group_of(*family_named(value))));
    return subject + ' ' + value;
  }

  Expected<void> take(const std::string& subject, const std::string& value) {
    if (subject == kPrecision) {
      out_.subject = Subject::precision;
      const auto precision = select_precision(value);
      if (!precision) return std::unexpected(precision.error());
      out_.precisions.push_back(*precision);
      return {};
    }
    if (subject == kFamily) {
      out_.subject = Subject::family;
      const auto family = family_named(value);
      if (!family) return usage_error("--compare family: " + in_quotes(value) + " is not one of a, p or b");
      out_.families.push_back(*family);
      return {};
    }
    if (subject == kBundle) {
      out_.subject = Subject::bundle;
      if (!request_.bundle.empty()) return usage_error("--compare bundle excludes --bundle");
      RenderRequest one = request_;
      one.bundle = value;
      one.layers.clear();
      auto picture = understand(registry_, one, maps_, nullptr);
      if (!picture) return std::unexpected(picture.error());
      out_.bundles.push_back(std::move(*picture));
      return {};
    }
    if (subject == kStep) {
      out_.subject = Subject::step;
      const auto step = whole_number("--compare step", value);
      if (!step) return std::unexpected(step.error());
      out_.steps.push_back(*step);
      return {};
    }
    const std::vector<std::string_view> known = compared_subjects(registry_);
    if (std::ranges::find(known, subject) == known.end())
      return usage_error("--compare: unknown subject " + in_quotes(subject) + "; it is one of " + one_of(known));
    out_.subject = Subject::parameter;
    const auto parsed = parse_setting(subject + '=' + value, registry_.parameters(), "--compare");
    if (!parsed) return std::unexpected(parsed.error());
    out_.parameter = registry_.parameters()[parsed->first];
    out_.values.push_back(parsed->second);
    return {};
  }

  const Registry& registry_;
  const RenderRequest& request_;
  std::span<const render::ColorMap> maps_;
  CompareRequest out_;
};

/// The samples in some states of an evolution, by step.
Expected<std::map<std::uint64_t, std::shared_ptr<const SampleData>>> states_of(
    const CompareRequest& compared, const std::shared_ptr<const SampleData>& data) {
  std::vector<std::uint64_t> steps = compared.steps;
  std::ranges::sort(steps);
  Document document;
  const auto read = replace_all(document, *data);
  if (!read) return std::unexpected(read.error());
  document.apply(*read);
  std::map<std::uint64_t, std::shared_ptr<const SampleData>> out;
  EvolutionRunner runner(state_of(document), compared.evolution);
  for (const std::uint64_t step : steps) {
    if (step == 0) {
      out[0] = data;
      continue;
    }
    const auto state = runner.at(step, steps.back());
    if (!state) return std::unexpected(state.error());
    auto moved = std::make_shared<SampleData>(*data);
    moved->positions = state->positions;
    moved->contours = contours_of(*state);
    out[step] = std::move(moved);
  }
  return out;
}

/// For an evolution that moves a parameter: the settings with its value at a step.
Expected<ComputationSettings> moved_settings(const CompareRequest& compared, const ParameterMove& move,
                                             std::uint64_t step, ComputationSettings settings) {
  const auto value = moved_value(move, settings[move.parameter], step, compared.evolution.values);
  if (!value) return std::unexpected(value.error());
  settings[move.parameter] = *value;
  return settings;
}

}  // namespace

std::vector<std::string_view> compared_subjects(const Registry& registry) {
  std::vector<std::string_view> out{kPrecision, kFamily, kBundle, kStep};
  for (const Parameter& parameter : registry.parameters()) out.push_back(parameter.id);
  return out;
}

Expected<CompareRequest> understand_comparison(const Registry& registry, const RenderRequest& request,
                                               std::span<const render::ColorMap> maps) {
  if (request.compared.empty()) {
    if (request.with_differences) return usage_error("--differences needs --compare");
    if (request.has_free_cameras) return usage_error("--free-cameras needs --compare");
    if (!request.evolution.empty()) return usage_error("--evolution needs --compare step=...");
    return CompareRequest{};
  }
  if (request.has_free_cameras && !request.view.empty())
    return usage_error("--free-cameras excludes --view: each pane shows all that is in it");
  auto out = Reader(registry, request, maps).read();
  if (out && out->subject != CompareRequest::Subject::step && !request.evolution.empty())
    return usage_error("--evolution needs --compare step=...");
  if (out && request.bounds != kBoundsOfView) return usage_error("--bounds excludes --compare");
  return out;
}

Expected<void> take_evolution(const Registry& registry, CompareRequest& compared, const RenderRequest& request,
                              const std::optional<EvolutionChoice>& of_session) {
  if (compared.subject != CompareRequest::Subject::step) return {};
  const bool is_named = !request.evolution.empty();
  if (!is_named && !of_session) return usage_error("--compare step: name the evolution with --evolution");
  if (!of_session) return {};
  const auto evolution =
      is_named ? evolution_of(registry, request.evolution, *of_session) : Expected<EvolutionChoice>(*of_session);
  if (!evolution) return std::unexpected(evolution.error());
  compared.evolution = *evolution;
  return {};
}

Expected<std::vector<PaneRequest>> panes_of(const CompareRequest& compared, const PictureRequest& picture,
                                            const ComputationSettings& settings,
                                            const std::shared_ptr<const SampleData>& data) {
  using Subject = CompareRequest::Subject;
  if (compared.subject == Subject::family && !has_family(picture.shown))
    return usage_error("--compare family: name layers of a family, as in --layers a-union-boundary");
  const ParameterMove* const move = compared.evolution.moved_parameter();
  std::map<std::uint64_t, std::shared_ptr<const SampleData>> states;
  if (compared.subject == Subject::step && move == nullptr) {
    auto computed = states_of(compared, data);
    if (!computed) return std::unexpected(computed.error());
    states = std::move(*computed);
  }
  std::vector<PaneRequest> out;
  for (std::size_t i = 0; i < compared.words.size(); ++i) {
    PaneRequest pane{.words = compared.words[i], .shown = picture.shown, .settings = settings, .data = data};
    switch (compared.subject) {
      case Subject::nothing: break;
      case Subject::precision: pane.settings.precision = compared.precisions[i]; break;
      case Subject::parameter: pane.settings[compared.parameter] = compared.values[i]; break;
      case Subject::family: pane.shown = with_family(picture.shown, compared.families[i]); break;
      case Subject::bundle:
        pane.shown = compared.bundles[i].shown;
        pane.shown.background = picture.shown.background;
        break;
      case Subject::step: {
        if (move == nullptr) {
          pane.data = states.at(compared.steps[i]);
          break;
        }
        const auto moved = moved_settings(compared, *move, compared.steps[i], settings);
        if (!moved) return std::unexpected(moved.error());
        pane.settings = *moved;
        break;
      }
    }
    out.push_back(std::move(pane));
  }
  return out;
}

std::vector<PaneChoice> panes_beside(const CompareRequest& compared) {
  using Subject = CompareRequest::Subject;
  std::vector<PaneChoice> out;
  const bool begins_with_main = compared.subject != Subject::step || compared.steps.front() == 0;
  for (std::size_t i = begins_with_main ? 1 : 0; i < compared.words.size() && out.size() < kMostPanesBeside; ++i) {
    switch (compared.subject) {
      case Subject::nothing: break;
      case Subject::precision: out.emplace_back(compared.precisions[i]); break;
      case Subject::parameter: out.emplace_back(ParameterChoice{compared.parameter, compared.values[i]}); break;
      case Subject::family: out.emplace_back(compared.families[i]); break;
      case Subject::bundle:
        out.emplace_back(Bundle{compared.words[i], configuration_of(compared.bundles[i].shown), {}});
        break;
      case Subject::step:
        if (compared.steps[i] <= kMostPaneStep) out.emplace_back(EvolvedChoice{compared.steps[i]});
        break;
    }
  }
  return out;
}

SessionEvolution evolution_beside(const Registry& registry, const CompareRequest& compared) {
  if (compared.subject != CompareRequest::Subject::step) return {};
  return session_evolution(registry, compared.evolution, 0);
}

}  // namespace mes::cli
