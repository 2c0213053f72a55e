// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/lessons/lesson_pages.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/export/computation.h"
#include "app/picture/paper/rich_text.h"
#include "app/store/background_loader.h"
#include "app/store/looks/color_maps.h"
#include "app/store/sample_shapes.h"
#include "render/figure/raster.h"

namespace mes {
namespace {

// Paper drawings use logical pixels; here a logical pixel is a point.
constexpr double kPointsAsPixels = 1.0 / figure::kPointsPerPixel;

Box2 box(double left, double top, double right, double bottom) {
  Box2 out;
  out.add(Vec2{left, top});
  out.add(Vec2{right, bottom});
  return out;
}

/// Lays out the caption; complaints about it are added to the remarks.
PaperDrawing fitted_caption(const CaptionText& text, const Box2& room, double letters, Rgb ink,
                            const MeasureText& measure, std::vector<std::string>& remarks) {
  FittedCaption fitted =
      fit_caption(text, {.width = room.width(), .letters = letters, .ink = ink}, room.height(), measure);
  if (!fitted.complaint.empty()) remarks.push_back("caption: " + fitted.complaint);
  if (!fitted.is_whole) remarks.push_back("the caption is longer than its page; the end is left out");
  return std::move(fitted.drawing);
}

}  // namespace

LessonLayout lesson_layout(double width, double height) {
  constexpr double kWide = 1.15;
  const double letters = std::min(0.037 * height, 0.021 * std::max(width, height));
  const double margin = 1.9 * letters;
  const double line = 0.62 * letters;
  LessonLayout out;
  out.letters = letters;
  if (width > kWide * height) {
    constexpr double kColumn = 0.34;
    const double right = kColumn * width;
    out.caption = box(margin, margin, right - 0.5 * margin, height - margin - 2.0 * line);
    out.drawing = box(right, 0.0, width, height);
  } else {
    constexpr double kDrawing = 0.62;
    out.drawing = box(0.0, 0.0, width, kDrawing * height);
    out.caption = box(margin, kDrawing * height + 0.5 * margin, width - margin, height - 0.6 * margin - 2.0 * line);
  }
  out.number = {margin, height - 0.6 * margin - line};
  return out;
}

figure::Sheet sheet_of(const LessonPage& page) {
  return {.width = page.paper.width,
          .height = page.paper.height,
          .background = {},
          .figures = {{&page.paper, {}}, {&page.drawing, page.corner}},
          .bookmark = page.name};
}

Expected<render::Image> picture_of(const LessonPage& page, double pixels_per_point) {
  auto out = figure::picture_of(page.paper, pixels_per_point);
  if (!out) return out;
  const auto drawing = figure::picture_of(page.drawing, pixels_per_point);
  if (!drawing) return drawing;
  const auto whole = [&](double points) { return static_cast<int>(std::lround(points * pixels_per_point)); };
  const int left = whole(page.corner.x);
  const int top = whole(page.corner.y);
  const int width = std::min(drawing->width, out->width - left);
  const int height = std::min(drawing->height, out->height - top);
  for (int y = 0; y < height; ++y)
    std::copy_n(&drawing->rgba[drawing->offset(0, y)], 4 * std::max(width, 0),
                &out->rgba[out->offset(left, top + y)]);
  return out;
}

LessonPrinter::LessonPrinter(const Registry& registry, const Session& session, const LessonLook& look,
                             std::shared_ptr<const PaperFonts> fonts)
    : registry_(&registry),
      session_(&session),
      look_(look),
      fonts_(std::move(fonts)),
      maps_(load_color_maps(find_assets({}), user_color_map_folder()).maps),
      walk_(std::make_unique<LessonWalk>(registry, session)) {}

Expected<LessonPrinter> LessonPrinter::make(const Registry& registry, const Session& session,
                                            const LessonLook& look) {
  auto fonts = PaperFonts::read(find_assets({}));
  if (!fonts) return std::unexpected(fonts.error());
  return LessonPrinter(registry, session, look, std::make_shared<const PaperFonts>(std::move(*fonts)));
}

const std::string& LessonPrinter::title() const {
  return session_->lesson.title.empty() ? session_->title : session_->lesson.title;
}

figure::BookInfo LessonPrinter::info() const {
  return {.title = title(), .fonts = fonts_, .session = {}};
}

const render::Image* LessonPrinter::traced(const BackgroundImage& image, std::vector<std::string>& remarks) {
  if (image.file.empty()) return nullptr;
  const auto [found, is_new] = traced_.try_emplace(std::pair(image.file, image.is_upright));
  if (is_new) {
    if (auto read = read_background(image))
      found->second = std::move(*read);
    else
      remarks.push_back("the picture underneath is left out: " + read.error().message());
  }
  return found->second ? &*found->second : nullptr;
}

Expected<void> LessonPrinter::draw(const LessonScene& scene, const Box2& place, LessonPage& page,
                                   const std::stop_token& stop) {
  FigureRequest request{.shown = {.descriptors = scene.layers.descriptors(),
                                  .layers = main_layers(scene.layers.visible_layers()),
                                  .styles = {},
                                  .background = look_.background,
                                  .scale = look_.scale},
                        .part = Everything{},
                        .page = PageSize{place.width(), place.height()},
                        .legend = look_.legend,
                        .marks = look_.marks,
                        .with_annotations = look_.with_annotations,
                        .image = scene.layers.image()};
  for (LayerIndex layer = 0; layer < scene.layers.size(); ++layer)
    request.shown.styles.push_back(scene.layers.style(layer));
  if (!scene.view.is_empty()) request.part = scene.view;
  LayerMirror mirror;
  const auto result = run_computation(*registry_, scene.data,
                                      {.layers = request.shown.layers,
                                       .settings = scene.settings,
                                       .on_patch = [&mirror](const FramePatch& patch) { mirror.apply(patch); },
                                       .stop = stop});
  if (!result) return std::unexpected(result.error());
  const Box2 bounds = result->document.bounding_box();
  auto drawn = draw_figure(
      request, {.mirror = mirror,
                .bounds = bounds,
                .maps = maps_,
                .traced = traced(scene.layers.image(), page.remarks),
                .annotations = look_.with_annotations ? mes::place(result->document) : PlacedAnnotations{},
                .document = result->document});
  if (!drawn) return std::unexpected(drawn.error());
  page.remarks.insert(page.remarks.end(), drawn->remarks.begin(), drawn->remarks.end());
  page.document = result->document.digest();
  page.drawing = std::move(drawn->figure);
  page.corner = place.low;
  return {};
}

figure::Figure LessonPrinter::paper(const CaptionText& caption, std::size_t step,
                                    std::vector<std::string>& remarks) const {
  figure::Figure out{.width = look_.width, .height = look_.height, .background = look_.background};
  const LessonLayout layout = lesson_layout(look_.width, look_.height);
  const PaperColors colors = paper_colors(look_.background);
  const MeasureText measure = measure_with(*fonts_, kPointsAsPixels);
  add_to(out, *fonts_, fitted_caption(caption, layout.caption, layout.letters, colors.ink, measure, remarks),
         layout.caption.low, kPointsAsPixels);
  const double size = 0.62 * layout.letters;
  PaperDrawing foot;
  const std::string number = fmt::format("{} / {}", step + 1, session_->lesson.steps.size());
  foot.lines.push_back({.x = 0.0, .top = 0.0, .size = size, .color = colors.quiet, .text = number});
  const double room = layout.caption.width() - measure(number, size, Face::plain) - 1.5 * size;
  if (const std::string name = readable_text(title()); measure(name, size, Face::plain) < room)
    foot.lines.push_back(
        {.x = layout.caption.width() - room, .top = 0.0, .size = size, .color = colors.quiet, .text = name});
  add_to(out, *fonts_, foot, layout.number, kPointsAsPixels);
  return out;
}

Expected<LessonPage> LessonPrinter::page(std::size_t step, const std::stop_token& stop) {
  const auto failed = [step](Error error) {
    error.text = fmt::format("step {} of the lesson: {}", step + 1, error.text);
    return std::unexpected(std::move(error));
  };
  const auto scene = walk_->scene(step);
  if (!scene) return failed(scene.error());
  LessonPage out;
  const Box2 place = lesson_layout(look_.width, look_.height).drawing;
  if (auto drawn = draw(*scene, place, out, stop); !drawn) return failed(drawn.error());
  out.caption = caption_text(session_->lesson.steps[step].caption);
  out.name = name_of(out.caption);
  if (out.name.empty()) out.name = fmt::format("Step {}", step + 1);
  out.paper = paper(out.caption, step, out.remarks);
  for (std::string& remark : out.remarks) remark = fmt::format("step {}: {}", step + 1, remark);
  return out;
}

}  // namespace mes
