// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina export`: the geometry of layers as text.
#include <fmt/core.h>
#include <algorithm>
#include <vector>

#include "app/cli/input.h"
#include "app/cli/messages.h"
#include "app/cli/names.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/requests.h"
#include "app/store/layer_text.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

Expected<const LayerTextFormat*> select_format(const std::string& name) {
  if (const LayerTextFormat* const format = find_layer_text_format(name)) return format;
  return usage_error(
      fmt::format("unknown export format {}; it is one of {}", in_quotes(name), one_of(export_formats())));
}

/// What is computed: the layers, and what else the format needs.
std::vector<LayerIndex> layers_for(const LayerTextFormat& format, std::vector<LayerIndex> layers) {
  if (format.needs_curve)
    for (const std::string_view id : {"curve", "curve-normals"})
      if (std::ranges::find(layers, find_layer(id)) == layers.end()) layers.push_back(find_layer(id));
  return layers;
}

}  // namespace

std::span<const std::string_view> export_formats() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    for (const LayerTextFormat& format : layer_text_formats()) out.push_back(format.name);
    return out;
  }();
  return names;
}

Expected<void> run_export(const ExportRequest& request, Interruption& interruption) {
  const auto settings = settings_of(request.source);
  if (!settings) return std::unexpected(settings.error());
  const auto format = select_format(request.format);
  if (!format) return std::unexpected(format.error());
  const auto layers = select_layers(request.layer);
  if (!layers) return std::unexpected(layers.error());
  if (auto good = check_layers(**format, *layers); !good) return good;
  if (auto good = check_output(request.output); !good) return good;
  const auto input = read_input(request.source.file, request.source.from);
  if (!input) return std::unexpected(input.error());

  LayerMirror mirror;
  const auto result =
      compute_with_progress(input->data, {.layers = layers_for(**format, *layers),
                                          .settings = *settings,
                                          .on_patch = [&](const FramePatch& patch) { mirror.apply(patch); }});
  if (!result) return std::unexpected(result.error());
  const LayerText out = (*format)->write({.layers = *layers, .mirror = mirror, .document = result->document});
  if (out.left_out != 0)
    say(fmt::format("{} rays and lines are left out: {} holds finite shapes only", out.left_out, request.format));
  return write_output(request.output, out.text, interruption, {input->sources, request.force});
}

}  // namespace mes::cli
