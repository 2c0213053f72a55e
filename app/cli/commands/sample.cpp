// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina sample`: takes other samples from the curves of a file.
#include <fmt/core.h>
#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/names.h"
#include "core/document/commands.h"
#include "core/io/format.h"
#include "core/io/text/text_numbers.h"
#include "core/resampling/resampling.h"

namespace mes::cli {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// Sets `to` if the option was given.
Expected<void> read_number(std::string_view option, const std::string& text, double& to, double factor = 1.0) {
  if (text.empty()) return {};
  const auto value = parse_number(text);
  if (!value) return usage_error(fmt::format("{} expects a number, not {}", option, in_quotes(text)));
  to = factor * *value;
  return {};
}

Expected<SamplingRule> rule_of(const SampleRequest& request) {
  if (request.rule.empty()) {
    if (request.reading.keeps_vertices) return SamplingRule::vertices;
    if (!request.spacing.empty()) return SamplingRule::spacing;
    if (!request.epsilon.empty()) return SamplingRule::feature_size;
    if (!request.turn.empty()) return SamplingRule::curvature;
    return request.samples.empty() ? SamplingRule::adaptive : SamplingRule::count;
  }
  std::vector<std::string_view> names;
  for (const SamplingRuleDescriptor& rule : sampling_rules()) {
    if (rule.id == request.rule) return rule.rule;
    names.push_back(rule.id);
  }
  return usage_error(
      fmt::format("--rule: there is no rule {}; the rules are {}", in_quotes(request.rule), one_of(names)));
}

Expected<SamplingRequest> sampling_of(const SampleRequest& request) {
  const auto rule = rule_of(request);
  if (!rule) return std::unexpected(rule.error());
  struct Owned {
    std::string_view option;
    const std::string& text;
    SamplingRule rule;
  };
  for (const Owned& owned : {Owned{"--spacing", request.spacing, SamplingRule::spacing},
                             Owned{"--epsilon", request.epsilon, SamplingRule::feature_size},
                             Owned{"--turn", request.turn, SamplingRule::curvature}})
    if (!owned.text.empty() && *rule != owned.rule)
      return usage_error(fmt::format("{} is for the rule {}, and samples are taken by the rule {}", owned.option,
                                     sampling_rules()[static_cast<std::size_t>(owned.rule)].id,
                                     sampling_rules()[static_cast<std::size_t>(*rule)].id));
  if (request.reading.keeps_vertices && *rule != SamplingRule::vertices)
    return usage_error(fmt::format("--vertices takes the vertices alone, and samples are taken by the rule {}",
                                   sampling_rules()[static_cast<std::size_t>(*rule)].id));
  if (!request.samples.empty() && (*rule == SamplingRule::spacing || *rule == SamplingRule::vertices))
    return usage_error(fmt::format("--samples says how many, and samples are taken by the rule {}",
                                   sampling_rules()[static_cast<std::size_t>(*rule)].id));
  SamplingRequest out{.rule = *rule, .count = kUsualSamples};
  if (*rule == SamplingRule::adaptive) out.least_each = 8;
  if (!request.samples.empty()) {
    const auto samples = whole_number("--samples", request.samples, 1, out.most);
    if (!samples) return std::unexpected(samples.error());
    out.count = static_cast<std::size_t>(*samples);
  }
  const auto seed = whole_number("--seed", request.seed);
  if (!seed) return std::unexpected(seed.error());
  out.seed = *seed;
  for (const auto& done : {read_number("--spacing", request.spacing, out.spacing),
                           read_number("--epsilon", request.epsilon, out.epsilon),
                           read_number("--turn", request.turn, out.turn, kRadians),
                           read_number("--corner-angle", request.corner_angle, out.corner_angle, kRadians),
                           read_number("--corner-radius", request.corner_radius, out.corner_radius),
                           read_number("--jitter", request.jitter, out.jitter)})
    if (!done) return std::unexpected(done.error());
  if (*rule == SamplingRule::spacing && request.spacing.empty())
    return usage_error("the rule spacing needs --spacing");
  if (auto good = check(out); !good) return std::unexpected(good.error());
  return out;
}

}  // namespace

Expected<void> run_sample(const Registry& registry, const SampleRequest& request, Interruption& interruption) {
  const auto sampling = sampling_of(request);
  if (!sampling) return std::unexpected(sampling.error());
  if (auto good = check_output(request.output); !good) return good;
  ReadingOptions reading = request.reading;
  reading.wants_curves = true;
  const auto input = read_input(registry, request.file, request.from, reading);
  if (!input) return std::unexpected(input.error());
  if (input->data.positions.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "there are no samples and no curves", request.file});

  JobControl job;
  std::shared_ptr<const CurveSet> curves;
  if (input->data.source)
    curves = input->data.source->curves;
  else
    curves = std::make_shared<const CurveSet>(curves_through(input->data.positions, job));
  auto taken = take_samples(curves, *sampling, job);
  if (!taken) return std::unexpected(taken.error());
  taken->data.map = input->data.map;
  Document document;
  const auto delta = replace_all(document, taken->data);
  if (!delta) return std::unexpected(delta.error());
  document.apply(*delta);
  if (const std::string remark = remark_of(*taken, *sampling); !remark.empty()) say(request.file + ": " + remark);
  return write_output(request.output, write_poff(document), interruption, {input->sources, request.force, true});
}

}  // namespace mes::cli
