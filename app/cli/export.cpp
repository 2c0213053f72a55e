// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina export`: the geometry of one layer as text.
#include <fmt/core.h>
#include <array>

#include "app/cli/computation.h"
#include "app/cli/geometry_text.h"
#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/requests.h"
#include "core/io/format.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

// Samples and balls themselves are exported through the layers that show each of them.
constexpr std::string_view kSamples = "points";
constexpr std::string_view kBallCenters = "b-inner-centers";

constexpr std::array<std::string_view, 3> kNow{"csv", "poff", "wpoff"};

Expected<void> check_export_format(const std::string& format) {
  constexpr std::array<std::string_view, 2> kLater{"npoff", "geojson"};
  if (std::ranges::find(kNow, format) != kNow.end()) return {};
  if (std::ranges::find(kLater, format) != kLater.end())
    return usage_error(
        fmt::format("export format \"{}\" is not available in this build; it is one of {}", format, one_of(kNow)));
  return usage_error(fmt::format("unknown export format {}; it is one of {}", in_quotes(format), one_of(kNow)));
}

/// Formats that hold points or disks only cannot take every layer.
Expected<void> check_layer(const std::string& format, LayerIndex layer) {
  const LayerDescriptor& descriptor = layer_descriptors()[layer];
  if (format == "wpoff" && descriptor.id == kBallCenters) return {};
  const auto possible = format == "poff"    ? poff_of({}, layer, descriptor)
                        : format == "wpoff" ? wpoff_of({}, layer, descriptor)
                                            : Expected<std::string>();
  if (!possible) return std::unexpected(possible.error());
  return {};
}

Expected<std::string> text_of(const LayerMirror& mirror, LayerIndex layer, const std::string& format,
                              const Document& document) {
  const LayerDescriptor& descriptor = layer_descriptors()[layer];
  if (format == "csv") return csv_of(mirror, layer, descriptor);
  if (format == "wpoff") {
    if (descriptor.id == kBallCenters) return write_wpoff(document);
    return wpoff_of(mirror, layer, descriptor);
  }
  // In input order and with the curve order that came with them.
  if (descriptor.id == kSamples) return write_poff(document);
  return poff_of(mirror, layer, descriptor);
}

}  // namespace

std::span<const std::string_view> export_formats() {
  return kNow;
}

Expected<void> run_export(const ExportRequest& request, Interruption& interruption) {
  const auto settings = settings_of(request.source);
  if (!settings) return std::unexpected(settings.error());
  if (auto good = check_export_format(request.format); !good) return good;
  const auto layer = select_layer(request.layer);
  if (!layer) return std::unexpected(layer.error());
  if (auto good = check_layer(request.format, *layer); !good) return good;
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(request.source.file, request.source.from);
  if (!input) return std::unexpected(input.error());

  LayerMirror mirror;
  const auto result = run_computation(
      input->data,
      {.layers = {*layer}, .settings = *settings, .on_patch = [&](const FramePatch& patch) { mirror.apply(patch); }});
  if (!result) return std::unexpected(result.error());
  const auto text = text_of(mirror, *layer, request.format, result->document);
  if (!text) return std::unexpected(text.error());
  return write_output(request.output, *text, interruption, {input->sources, request.force});
}

}  // namespace mes::cli
