// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/film.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "app/cli/console/messages.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/picture.h"
#include "app/editing/curves/sample_spacing.h"
#include "app/export/lessons/carried.h"
#include "app/export/pane_figure.h"
#include "app/export/session_panes.h"
#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/picture/paper/title_drawing.h"
#include "app/picture/picture_overlay.h"
#include "app/picture/sample_texts.h"
#include "app/playing/player.h"
#include "app/recording/frame_writer.h"
#include "app/recording/video.h"
#include "app/store/background_loader.h"
#include "app/store/looks/color_maps.h"
#include "app/store/sample_shapes.h"
#include "core/graph/registry.h"
#include "core/io/files/temporary.h"
#include "core/io/session/session.h"
#include "core/io/text/text_numbers.h"
#include "render/device/egl_context.h"
#include "render/device/gl_device.h"
#include "render/offscreen.h"
#include "render/scene.h"

namespace mes::cli {
namespace {

namespace fs = std::filesystem;

struct Shard {
  std::uint64_t index = 1;  // from 1
  std::uint64_t count = 1;
  bool has(std::uint64_t frame) const { return frame % count == index % count; }
};

/// The interpreted request.
struct Film {
  PictureSize size;
  double fps = 12.0;
  Shard shard;
  LegendScope legend = LegendScope::color_maps;
  ScaleMarks marks{};
  bool with_annotations = true;
  std::string title;
};

Expected<Shard> parse_shard(const std::string& text) {
  if (text.empty()) return Shard{};
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = parse_count(std::string_view(text).substr(0, slash));
    const auto count = parse_count(std::string_view(text).substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count) return Shard{*index, *count};
  }
  return usage_error("--shard expects I/N with I from 1 to N, not " + in_quotes(text));
}

Expected<Film> understood_film(const FilmRequest& request) {
  Film film;
  const auto size = parse_size(request.size);
  if (!size) return std::unexpected(size.error());
  film.size = *size;
  const auto fps = parse_number(request.fps);
  if (!fps || *fps < 1.0 || *fps > 120.0)
    return usage_error("--fps expects a number from 1 to 120, not " + in_quotes(request.fps));
  film.fps = *fps;
  film.legend = legend_scope(request.with_legend, request.with_key);
  film.marks = request.marks;
  film.with_annotations = request.with_annotations;
  film.title = request.title;
  const auto shard = parse_shard(request.shard);
  if (!shard) return std::unexpected(shard.error());
  film.shard = *shard;
  if (!request.video.empty()) {
    if (!is_video_name(request.video)) return usage_error("the name of the video must end in .mp4 or .webm");
    if (film.shard.count > 1) return usage_error("a shard is not a video; make it of the frames of all shards");
  }
  return film;
}

Expected<void> prepare(const fs::path& folder, const Shard& shard) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannot_write("cannot be made: " + error.message(), folder);
  if (fs::exists(folder / frame_name(shard.index), error))
    return cannot_write("there are frames already; name another folder", folder);
  return {};
}

std::uint64_t frames_of(const PlayStep& step, double fps) {
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(step.seconds * fps)));
}

/// Draws the state of a player.
class Studio {
 public:
  /// `panes`: those of the session; panes beside the main one are computed from scratch for each picture.
  Studio(const Registry& registry, render::GlDevice& device, const Film& film, const SessionPanes& panes)
      : registry_(registry),
        device_(device),
        scene_(device),
        film_(film),
        panes_(panes),
        scale_(std::max(1.0, film.size.height / kReference)) {
    scene_.set_color_maps(load_color_maps(find_assets({}), user_color_map_folder()).maps);
    if (auto fonts = PaperFonts::read(find_assets({})))
      fonts_ = std::make_shared<const PaperFonts>(std::move(*fonts));
    else
      say("captions, title, annotations, numbers, legend, scale bar and axes are left out: " +
          fonts.error().message());
    if (fonts_)
      title_ = layout_title(film.title, film.size.width / scale_, film.size.height / scale_,
                            measure_with(*fonts_, scale_), kWhiteCanvas);
    if (!title_.complaint.empty()) say("the title: " + title_.complaint);
  }

  void apply(const FramePatch& patch) {
    if (panes_.is_empty() || !fonts_) scene_.apply(patch);
  }

  Expected<CapturedPicture> draw(const Player& player) {
    if (!panes_.is_empty() && fonts_) return draw_panes(player);
    const auto& [width, height] = film_.size;
    const int band = title_band();
    EdgeRoom edges;
    if (film_.marks.axes && player.view().is_empty()) edges = room_of_axes(scale_);
    edges.above = band;
    const render::Camera camera = player.view().is_empty()
                                      ? camera_within(edges, width, height, player.document().bounding_box(), kMargin)
                                      : camera_within(edges, width, height, player.view(), 0.0);
    const LayerStack& layers = player.layers();
    follow_picture(layers.image());
    std::vector<render::LayerView> views;
    for (const LayerIndex layer : layers.visible_layers()) views.push_back({layer, layers.style(layer)});
    auto shot = shoot(views, camera, player.document(),
                      {legend_of(registry_.layers(), scene_, views, film_.legend),
                       player.caption(),
                       film_.marks,
                       {},
                       title_.drawing});
    if (!shot) return std::unexpected(shot.error());
    return CapturedPicture(std::move(shot->image), std::move(shot->overlay));
  }

 private:
  int title_band() const { return static_cast<int>(std::ceil(scale_ * title_.drawing.height)); }

  static SeenByAll seen_in(const Box2& view, const Document& document) {
    return view.is_empty() ? SeenByAll{document.bounding_box(), kMargin} : SeenByAll{view, 0.0};
  }

  // Uses the layout of `mesecina render --compare`, with the caption in the first pane.
  Expected<CapturedPicture> draw_panes(const Player& player) {
    Comparison comparison = compare(
        registry_, panes_.requests({player.document(), player.history(), player.layers(), player.settings()}));
    for (const VariantLayer layer : held_) scene_.forget(layer);
    held_ = comparison.demand;
    LayerMirror mirror;
    const auto result = run_computation(registry_, *comparison.data,
                                        {.layers = comparison.demand,
                                         .settings = comparison.settings,
                                         .on_patch =
                                             [&](const FramePatch& patch) {
                                               mirror.apply(patch);
                                               scene_.apply(patch);
                                             },
                                         .variants = comparison.variants});
    if (!result) return std::unexpected(result.error());
    share_color_ranges(comparison, mirror);
    follow_picture(player.layers().image());
    SeenByAll seen = seen_in(player.view(), player.document());
    if (player.view().is_empty() && !panes_.has_free_cameras())
      for (const Pane& pane : comparison.panes)
        if (const Box2 box = comparison.document_of(pane, *result).bounding_box(); !box.is_empty()) seen.box.add(box);
    const auto& [width, height] = film_.size;
    PaneSheet sheet{
        .width = width,
        .height = height,
        .band = title_band(),
        .scale = scale_,
        .background = kWhiteCanvas,
        .grid = lay_out(comparison.panes.size(), width, height - title_band(), seen.proportions(), scale_),
        .title = title_.drawing};
    const int pane_width = sheet.pane_width();
    const int pane_height = sheet.pane_height();
    if (pane_width < 1 || pane_height < 1) return no_room_for(comparison.panes.size());
    for (const Pane& pane : comparison.panes) sheet.labels.push_back(pane.label);
    const FigureRequest all{.shown = {}, .part = Everything{}, .legend = film_.legend, .marks = film_.marks};
    CapturedPicture out(std::move(sheet), fonts_);
    for (std::size_t i = 0; i < comparison.panes.size(); ++i) {
      const Pane& pane = comparison.panes[i];
      const Document& document = comparison.document_of(pane, *result);
      const FigureRequest one = request_for(all, comparison, i, panes_.has_free_cameras());
      const SeenByAll here = i == 0 || !panes_.has_free_cameras() ? seen : seen_in(panes_.views()[i - 1], document);
      const render::Camera camera =
          camera_within(film_.marks.axes && here.margin > 0.0 ? room_of_axes(scale_) : EdgeRoom(), pane_width,
                        pane_height, here.box, here.margin);
      std::vector<render::LayerView> views;
      for (const VariantLayer layer : pane.shown.layers) views.push_back({layer, pane.shown.styles[layer.layer]});
      auto shot = shoot(views, camera, document,
                        {legend_of(registry_.layers(), scene_, views, one.legend),
                         i == 0 ? player.caption() : std::string(), one.marks});
      if (!shot) return std::unexpected(shot.error());
      out.add(std::move(shot->image), std::move(shot->overlay));
    }
    return out;
  }

  struct Shot {
    render::Image image;
    PictureOverlay overlay;
  };
  /// The views have the styles of the layers.
  Expected<Shot> shoot(std::vector<render::LayerView> views, const render::Camera& camera, const Document& document,
                       OverlayContent content) {
    const double units_per_px = camera.units_per_pixel() * scale_;
    const double spacing_px = typical_spacing(document) / units_per_px;
    for (render::LayerView& view : views)
      view.style = thinned(view.style, registry_.layers()[view.layer.layer], spacing_px);
    add_texts(registry_.layers(), views, {document}, {camera.visible(), units_per_px},
              fonts_ ? &fonts_->plain : nullptr);
    auto image =
        render::draw_image(device_, scene_, camera, views, {.background = kWhiteCanvas, .content_scale = scale_});
    if (!image) return std::unexpected(image.error());
    if (film_.with_annotations) content.annotations = place(document);
    content.unit = unit_of_lengths(document);
    return Shot{std::move(*image), picture_overlay_of(std::move(content), fonts_, {camera, scale_, kWhiteCanvas})};
  }

  // A picture that no longer exists, or that no layer shows, is reported once; the film continues without it.
  void follow_picture(const BackgroundImage& image) {
    const LayerIndex layer = registry_.find_layer("image");
    if (image.file != shown_.file || image.is_upright != shown_.is_upright) {
      shown_ = image;
      scene_.clear_picture();
      if (!image.file.empty()) {
        if (layer == kNoLayer)
          say("the picture underneath is left out: there is no layer for pictures");
        else if (const auto read = read_background(image))
          scene_.set_picture(layer, *read);
        else
          say("the picture underneath is left out: " + read.error().message());
      }
    }
    scene_.place_picture({image.center, image.width});
  }

  static constexpr double kMargin = 0.06;      // around the document, if no view is chosen
  static constexpr double kReference = 800.0;  // sizes in styles are meant for a view of about this height

  const Registry& registry_;
  render::GlDevice& device_;
  render::Scene scene_;
  Film film_;
  const SessionPanes& panes_;
  std::vector<VariantLayer> held_;  // layers of the panes that the scene holds
  double scale_;                    // pixels per logical pixel
  PictureTitle title_;              // the same in all pictures
  BackgroundImage shown_;           // in the scene, or unreadable
  std::shared_ptr<const PaperFonts> fonts_;
};

/// Puts the session into the manifest of the frames, without the author's folders; reports if it is too long for
/// that.
void carry(FrameWriter& writer, const Session& session) {
  if (auto packed = packed_session(session_for_lesson(session)))
    writer.carry(std::move(*packed));
  else
    say("the frames carry no session: it would be too long");
}

}  // namespace

Expected<void> check(const FilmRequest& request) {
  const auto film = understood_film(request);
  if (!film) return std::unexpected(film.error());
  return request.video.empty() ? Expected<void>() : check_video(request.video);
}

Expected<void> make_film(const Registry& registry, const Session& session, const std::string& name,
                         const FilmRequest& request) {
  const auto film = understood_film(request);
  if (!film) return std::unexpected(film.error());
  std::optional<ScratchFolder> temporary;
  if (request.frames.empty()) {
    auto made = ScratchFolder::make();
    if (!made) return std::unexpected(made.error());
    temporary.emplace(std::move(*made));
  }
  const fs::path folder = temporary ? temporary->path() : fs::path(request.frames);
  if (auto ready = prepare(folder, film->shard); !ready) return ready;

  const auto context = render::EglContext::create();
  if (!context) return std::unexpected(context.error());
  render::GlDevice device;
  const SessionPanes panes(registry, session);
  Studio studio(registry, device, *film, panes);
  Player player(registry, session, [&studio](const FramePatch& patch) { studio.apply(patch); });

  FrameWriterOptions options{.first = film->shard.index, .stride = film->shard.count};
  if (film->shard.count > 1)
    options.manifest = fmt::format("manifest-{}-of-{}.json", film->shard.index, film->shard.count);
  FrameWriter writer({folder, {film->size.width, film->size.height, film->fps}}, options);
  if (request.with_source && !request.frames.empty()) carry(writer, session);
  Progress progress;
  std::uint64_t frame = 0;
  std::uint64_t total = 0;
  for (const PlayStep& step : player.steps()) total += frames_of(step, film->fps);
  for (const PlayStep& step : player.steps()) {
    progress.show(fmt::format("frame {} of {}", frame + 1, total),
                  static_cast<double>(frame) / static_cast<double>(total));
    if (auto done = player.apply(step); !done) {
      done.error().file = name;
      return done;
    }
    // Needed even if another shard draws the frame, because the drawing order depends on all earlier steps.
    if (const std::string failure = player.complete(); !failure.empty())
      say(fmt::format("frame {}: {}", frame + 1, failure));
    std::optional<CapturedPicture> shot;
    for (std::uint64_t end = frame + frames_of(step, film->fps); frame < end;) {
      ++frame;
      if (!film->shard.has(frame)) continue;
      if (!shot) {
        auto drawn = studio.draw(player);
        if (!drawn) return std::unexpected(drawn.error());
        shot = std::move(*drawn);
      }
      if (!writer.push({*shot, {std::string(step.what), player.document().digest()}})) return writer.finish();
    }
  }
  if (auto done = writer.finish(); !done || request.video.empty()) return done;
  progress.show("making the video", 1.0);
  return make_video(folder, film->fps, request.video);
}

}  // namespace mes::cli
