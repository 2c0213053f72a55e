// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina render`: a picture of layers without a display.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/cli/commands/commands.h"
#include "app/cli/commands/render_panes.h"
#include "app/cli/commands/rendering.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/compare_request.h"
#include "app/cli/requests/picture_request.h"
#include "app/cli/requests/session_settings.h"
#include "app/export/figure.h"
#include "app/export/lessons/carried.h"
#include "app/store/background_loader.h"
#include "app/store/looks/color_maps.h"
#include "app/store/sample_shapes.h"
#include "core/graph/registry.h"
#include "core/io/session/session.h"
#include "render/device/egl_context.h"

namespace mes::cli {
namespace {

/// Reads the picture to trace, and places it if it has no position; nothing without a picture, or without a layer for
/// it.
Expected<std::optional<render::Image>> read_traced(const Registry& registry, PictureRequest& picture,
                                                   const Box2& samples) {
  if (picture.image.file.empty()) return std::nullopt;
  if (registry.find_layer("image") == kNoLayer) {
    say("the picture underneath is left out: there is no layer for pictures");
    return std::nullopt;
  }
  if (const auto fingerprint = fingerprint_of_file(picture.image.file))
    picture.sources.push_back({picture.image.file, *fingerprint});
  auto image = read_background(picture.image);
  if (!image) return std::unexpected(image.error());
  if (!(picture.image.width > 0.0))
    picture.image = placed_in(samples, picture.image, static_cast<double>(image->height) / image->width);
  return std::move(*image);
}

/// The session that the picture carries; empty if it carries none.
std::string session_of(const Registry& registry, const RenderRequest& request, const PictureRequest& picture,
                       const LoadedFile& input, const ComputationSettings& settings, const CompareRequest& compared,
                       const Comparison& comparison) {
  const bool can_carry = picture.format == nullptr || picture.format->carries_session;
  if (!request.with_source || !can_carry) return {};
  const bool is_of_first = compared.subject != CompareRequest::Subject::step;
  LayerConfiguration layers = configuration_of(is_of_first ? comparison.panes.front().shown : picture.shown);
  layers.image = picture.image;
  // A picture made from a picture keeps the title.
  std::string title =
      input.session ? input.session->title : std::filesystem::path(request.source.file).filename().string();
  Session session = session_for_picture(std::move(title), input.data, std::move(layers),
                                        is_of_first ? comparison.settings : settings, picture.view.value_or(Box2{}));
  session.panes = panes_beside(compared);
  if (request.has_free_cameras) session.pane_views.resize(session.panes.size());
  session.evolution = evolution_beside(registry, compared);
  if (session.evolution.id.empty() && input.session)
    session.evolution = evolution_without_history(registry, *input.session);
  auto packed = packed_session(session);
  if (!packed) say("the picture carries no source: it would be too long");
  return std::move(packed).value_or("");
}

}  // namespace

Expected<void> run_render(const Registry& registry, const RenderRequest& request, Interruption& interruption) {
  LoadedColorMaps maps = load_color_maps(find_assets({}), user_color_map_folder());
  auto picture = understand(registry, request, maps.maps, nullptr);
  if (!picture) return std::unexpected(picture.error());
  auto compared = understand_comparison(registry, request, maps.maps);
  if (!compared) return std::unexpected(compared.error());
  if (auto good = check_output(request.output); !good) return good;
  if (std::ranges::any_of(picture->shown.styles, [](const LayerStyle& style) { return !style.color_map.empty(); }))
    for (const Error& problem : maps.problems) say("a colour map is left out: " + problem.message());
  const auto source = read_source(registry, request.source);
  if (!source) return std::unexpected(source.error());
  const LoadedFile& input = source->file;
  const ComputationSettings& settings = source->settings;
  if (source->session() != nullptr) {
    picture = understand(registry, request, maps.maps, source->session());
    if (!picture) return std::unexpected(picture.error());
  }
  if (auto good = take_evolution(registry, *compared, request, evolution_in(registry, source->session())); !good)
    return good;

  std::optional<Canvas> canvas;
  if (picture->format == nullptr) {
    auto context = render::EglContext::create();
    if (!context) return std::unexpected(context.error());
    canvas.emplace(std::move(*context));
    canvas->scene.set_color_maps(maps.maps);
  }
  Box2 samples;
  for (const Vec2 position : input.data.positions) samples.add(position);
  const auto traced = read_traced(registry, *picture, samples);
  if (!traced) return std::unexpected(traced.error());
  if (canvas && *traced) {
    canvas->scene.set_picture(registry.find_layer("image"), **traced);
    canvas->scene.place_picture({picture->image.center, picture->image.width});
  }
  const auto data = std::make_shared<const SampleData>(input.data);
  auto panes = panes_of(*compared, *picture, settings, data);
  if (!panes) return std::unexpected(panes.error());
  if (panes->empty()) panes->push_back({.words = {}, .shown = picture->shown, .settings = settings, .data = data});
  Comparison comparison = compare(registry, std::move(*panes));
  LayerMirror mirror;
  const auto result = compute_with_progress(registry, *comparison.data,
                                            {.layers = comparison.demand,
                                             .settings = comparison.settings,
                                             .on_patch =
                                                 [&](const FramePatch& patch) {
                                                   if (canvas) canvas->scene.apply(patch);
                                                   mirror.apply(patch);
                                                 },
                                             .variants = comparison.variants});
  if (!result) return std::unexpected(result.error());

  const Box2 bounds = result->document.bounding_box();
  std::string session = session_of(registry, request, *picture, input, settings, *compared, comparison);
  const FigureSource drawn_from{
      .mirror = mirror,
      .bounds = bounds,
      .maps = maps.maps,
      .traced = *traced ? &**traced : nullptr,
      .annotations = request.with_annotations ? place(result->document) : PlacedAnnotations{},
      .document = result->document};
  const auto draw = [&]() -> Expected<std::string> {
    if (compared->subject != CompareRequest::Subject::nothing)
      return draw_panes(*picture, request, comparison, *result, canvas ? &*canvas : nullptr, mirror, drawn_from,
                        std::move(session));
    if (canvas) {
      const FigureRequest wanted = figure_request(*picture, request);
      const PictureLayout layout =
          layout_of(picture->size, seen_by(*picture, bounds, mirror),
                    title_of(request, picture->size, picture->shown), *canvas, drawn_from, wanted);
      const auto image = draw_pixels(*canvas, layout, drawn_from, wanted);
      if (!image) return std::unexpected(image.error());
      return encoded(*image, session);
    }
    auto drawn = draw_figure(figure_request(*picture, request), drawn_from);
    if (!drawn) return std::unexpected(drawn.error());
    return written(*picture, std::move(*drawn), drawn_from.traced != nullptr, std::move(session));
  };
  const auto bytes = draw();
  if (!bytes) return std::unexpected(bytes.error());
  std::vector<SourceFile> sources = std::move(picture->sources);
  sources.insert(sources.end(), input.sources.begin(), input.sources.end());
  return write_output(request.output, *bytes, interruption, {std::move(sources), request.force});
}

}  // namespace mes::cli
