// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina compute`: counters of structures and layers as JSON.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/session_settings.h"
#include "app/layers/layer_summary.h"
#include "app/layers/words/statistics_text.h"
#include "core/draw/layer_digest.h"
#include "core/engine/sampling_verdict.h"
#include "core/graph/registry.h"
#include "core/io/session/json_text.h"
#include "core/io/systems/map_conversion.h"

namespace mes::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Number of distinct samples: the vertices of their triangulation, which the checks of the theorem always need.
std::int64_t distinct_of(std::span<const NodeReport> nodes) {
  for (const NodeReport& node : nodes)
    for (const Stat& stat : node.stats)
      if (node.structure == "delaunay" && stat.key == "vertices") return std::get<std::int64_t>(stat.value);
  return 0;
}

/// The measurements of a layer.
struct Measured {
  LayerTally tally;
  LayerDigest digest;
};

Json json_of(const LayerSummary& summary, const LayerDescriptor& layer, std::uint64_t lost) {
  Json out = Json::object();
  const auto emits = [&layer](PrimitiveKind kind) {
    return std::ranges::find(layer.kinds, kind) != layer.kinds.end();
  };
  for (const PrimitiveKind kind : kAllPrimitiveKinds)
    if (emits(kind)) out[std::string(plural_of(kind))] = summary.count[static_cast<std::size_t>(kind)];
  if (emits(PrimitiveKind::segment)) out["zero_length"] = summary.zero_length;
  if (emits(PrimitiveKind::segment) || emits(PrimitiveKind::arc) || emits(PrimitiveKind::parabola))
    out["length"] = summary.length;
  if (emits(PrimitiveKind::circle) || emits(PrimitiveKind::disk)) out["radius_sum"] = summary.radius_sum;
  if (emits(PrimitiveKind::triangle)) out["area"] = summary.area;
  if (lost + summary.not_finite != 0) out["not_finite"] = lost + summary.not_finite;
  return out;
}

/// The least colour that the light has with this finding.
std::string_view level_name(FindingLevel level) {
  return level == FindingLevel::note ? "note" : name_of(light_of(level));
}

/// The structure that measures the epsilon, if it is wanted.
std::vector<std::string_view> measures_of(const Registry& registry, std::size_t samples) {
  constexpr std::string_view kMeasure = "feature-size";
  if (samples > kMostSamplesMeasuredUnasked ||
      std::ranges::find(registry.structures(), kMeasure) == registry.structures().end())
    return {};
  return {kMeasure};
}

/// The verdict on the samples and its reasons.
Json diagnostics_of(std::span<const NodeReport> nodes) {
  Json reasons = Json::array();
  for (const NodeReport& node : nodes) {
    for (const Finding& finding : node.findings) {
      Json places = Json::array();
      for (const Vec2 place : finding.places) places.push_back({place.x, place.y});
      reasons.push_back({{"structure", node.structure},
                         {"level", level_name(finding.level)},
                         {"count", finding.count},
                         {"text", finding.text},
                         {"places", places}});
    }
  }
  const SamplingVerdict verdict = sampling_verdict(nodes);
  Json out;
  out["theorem"] = verdict.light == TheoremLight::none ? Json(nullptr) : Json(name_of(verdict.light));
  out["epsilon"] = nullptr;
  if (verdict.epsilon)
    out["epsilon"] = {{"value", verdict.epsilon->value},
                      {"estimate", verdict.epsilon->is_estimate},
                      {"exempt_corners", verdict.epsilon->corners},
                      {"exempt_ends", verdict.epsilon->ends},
                      {"exempt_junctions", verdict.epsilon->junctions}};
  out["text"] = verdict.text();
  out["reasons"] = reasons;
  return out;
}

}  // namespace

Expected<void> run_compute(const Registry& registry, const ComputeRequest& request, Interruption& interruption) {
  if (const auto good = select_layers(registry, request.layers); !good) return std::unexpected(good.error());
  if (auto good = check_output(request.output); !good) return good;
  auto input = read_source(registry, request.source);
  if (!input) return std::unexpected(input.error());
  const auto layers = shown_layers(registry, request.layers, input->session());
  if (!layers) return std::unexpected(layers.error());
  LoadedFile& file = input->file;
  const std::size_t samples = file.data.positions.size();
  const std::size_t contours = file.data.contours.size();
  const std::size_t balls = file.data.balls.size();
  const std::optional<MapPlane> map = file.data.map;

  std::vector<Measured> measured(registry.layers().size());
  const auto take = [&](const InstancePiece& piece) {
    Measured& layer = measured[piece.layer.layer];
    layer.tally.add(piece.kind, piece.values);
    if (request.with_digests) layer.digest += digest_of(piece.kind, piece.values, !piece.scalars_are_names);
  };
  const auto result = measure_with_progress(registry, std::move(file.data),
                                            {.layers = main_layers(*layers),
                                             .structures = measures_of(registry, samples),
                                             .settings = input->settings,
                                             .want_statistics = true,
                                             .want_findings = true,
                                             .needs_scalars = request.with_digests,
                                             .on_patch = {}},
                                            take);
  if (!result) return std::unexpected(result.error());

  Json out;
  out["schema"] = 1;
  out["version"] = MESECINA_VERSION;
  out["input"] = {{"file", request.source.file}, {"format", file.format},
                  {"samples", samples},          {"distinct", distinct_of(result->nodes)},
                  {"contours", contours},        {"balls", balls}};
  if (map) {
    if (is_on_earth(*map)) out["input"]["system"] = map->system.empty() ? "OGC:CRS84" : map->system;
    out["input"]["unit"] = map->plane_unit();
  }
  out["precision"] = id_of(input->settings.precision);
  out["structures"] = Json::object();
  for (const NodeReport& node : result->nodes) out["structures"][node.structure] = json_of(node, request.with_timing);
  out["layers"] = Json::object();
  for (const LayerIndex layer : *layers) {
    const LayerDescriptor& descriptor = registry.layers()[layer];
    Json& entry = out["layers"][std::string(descriptor.id)];
    entry = json_of(measured[layer].tally.summary(), descriptor, result->reports[layer].lost);
    if (request.with_digests) entry["digest"] = measured[layer].digest.text();
  }
  out["diagnostics"] = diagnostics_of(result->nodes);
  // A file name need not be valid UTF-8, but JSON must be.
  const std::string text = json_text(out, 2) + '\n';
  return write_output(request.output, text, interruption, {file.sources, request.force});
}

}  // namespace mes::cli
