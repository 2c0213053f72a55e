// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/picture.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <new>
#include <span>

#include "app/picture/sample_texts.h"
#include "core/base/assert.h"
#include "core/draw/variant.h"

namespace mes {
namespace {

constexpr std::uint32_t kSelectionMark = 1;
constexpr std::uint32_t kSelectedCircleMark = 0;  // below the points
constexpr double kFailedOpacity = 0.35;
constexpr double kLongMs = 250.0;                        // painting longer than this is given up for another view
constexpr std::uint64_t kNoPatches = ~std::uint64_t{0};  // of no picture

// The last good picture of a failed layer stays, but greyed.
LayerStyle greyed(LayerStyle style) {
  const auto luma = static_cast<std::uint8_t>((2 * style.color.r + 3 * style.color.g + style.color.b) / 6);
  const auto pale = static_cast<std::uint8_t>((luma + 2 * 0x99) / 3);
  style.color = {pale, pale, pale};
  style.color_map.clear();
  style.opacity *= kFailedOpacity;
  return style;
}

}  // namespace

Picture::Picture(LiveRegistry registry)
    : registry_(std::move(registry)),
      scene_(device_),
      moved_(registry_.now().find_layer("points")),
      kept_(device_),
      ink_capture_(device_) {
  if (std::getenv("MESECINA_CHECK_PATCHES") != nullptr) mirror_ = std::make_unique<LayerMirror>();
}

void Picture::check(const FramePatch& patch) {
  mirror_->apply(patch);
  for (const LayerPatch& layer : std::span(patch.layers).first(patch.layer_count))
    for (const PrimitiveKind kind : kAllPrimitiveKinds)
      MES_ASSERT(scene_.instances(layer.layer, kind) == mirror_->count(layer.layer, kind));
}

bool Picture::keep_instances(bool wanted) {
  if (!wanted) {
    instances_.reset();
    has_instances_ = false;
  }
  if (!wanted || instances_) return true;
  instances_ = std::make_shared<LayerMirror>();
  return false;
}

void Picture::keep(const FramePatch& patch) {
  const bool has_none = std::ranges::none_of(
      patch.reports, [](const LayerReport& report) { return report.state == NodeState::up_to_date; });
  if (!has_instances_ && !has_none && !brings_all(patch)) return;
  try {
    if (instances_.use_count() > 1) instances_ = std::make_shared<LayerMirror>(*instances_);
    instances_->apply(patch);
    has_instances_ = true;
  } catch (const std::bad_alloc&) {
    instances_.reset();  // requested again
    has_instances_ = false;
  }
}

const LayerReport* Picture::first_failed() const {
  const auto failed = std::ranges::find_if(report_.reports, [](const LayerReport& report) {
    return report.state == NodeState::failed || report.state == NodeState::blocked;
  });
  return failed == report_.reports.end() ? nullptr : &*failed;
}

bool Picture::apply(const FramePatch& patch) {
  try {
    scene_.apply(patch);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

// True if the patch contains, completely, every demanded layer that is up to date; false if no layer is demanded.
bool Picture::brings_all(const FramePatch& patch) {
  const auto sent = std::span(patch.layers).first(patch.layer_count);
  return !sent.empty() && std::ranges::all_of(patch.reports, [sent](const LayerReport& report) {
    if (report.state != NodeState::up_to_date) return true;
    const auto found = std::ranges::find(sent, report.layer, &LayerPatch::layer);
    return found != sent.end() &&
           std::ranges::all_of(found->kinds, [](const KindPatch& kind) { return kind.reset || kind.is_empty(); });
  });
}

bool Picture::take_from(Engine& engine) {
  if (painting_) return false;
  bool took = false;
  while (auto patch = engine.poll()) {
    // Patches based on a lost one are useless until the layers are sent completely.
    if (is_lost_ && !brings_all(*patch)) {
      engine.recycle(std::move(patch));
      continue;
    }
    const bool was_lost = is_lost_;
    is_lost_ = !apply(*patch);
    for (const LayerPatch& layer : std::span(patch->layers).first(patch->layer_count))
      if (std::ranges::find(loaded_, layer.layer) == loaded_.end()) loaded_.push_back(layer.layer);
    if (patch->frame != last_frame_) leaving_.end();  // their instances are those of the frame before
    const bool brings_news = patch->layer_count != 0 || patch->frame != last_frame_ || is_lost_ != was_lost;
    last_frame_ = patch->frame;
    if (mirror_ && !is_lost_) check(*patch);
    if (instances_ && !is_lost_) keep(*patch);
    moved_.take(*patch);
    document_revision_ = patch->document_revision;
    const bool was_outdated = is_outdated_;
    is_outdated_ = is_outdated_ && document_revision_ < expected_;
    is_kept_foreign_ = is_kept_foreign_ || (was_outdated && !is_outdated_);
    std::swap(report_, static_cast<RunReport&>(*patch));
    if (is_lost_) {
      for (LayerReport& report : report_.reports) {
        if (report.state != NodeState::up_to_date) continue;
        report.state = NodeState::failed;
        report.reason = kOutOfMemory;
      }
    }
    engine.recycle(std::move(patch));
    leaving_.end_if_complete([this](VariantLayer layer) { return has_picture(layer); });
    forget_layers_without_need();
    took = true;
    if (brings_news) ++patches_;
  }
  return took;
}

bool Picture::set_background(LayerIndex layer, const render::Image& image) {
  stop_painting();
  ++background_revision_;
  try {
    scene_.set_picture(layer, image);
  } catch (const std::bad_alloc&) {
    return false;
  }
  background_aspect_ = static_cast<double>(image.height) / image.width;
  return true;
}

void Picture::place_background(const render::PicturePlace& place) {
  if (place == background_place_) return;
  stop_painting();
  background_place_ = place;
  scene_.place_picture(place);
  ++background_revision_;
}

void Picture::clear_background() {
  stop_painting();
  scene_.clear_picture();
  background_aspect_ = 0.0;
  ++background_revision_;
}

void Picture::set_marks(FramePatch patch, std::vector<std::vector<render::LayerView>> marks) {
  stop_painting();
  for (const std::vector<render::LayerView>& pane : marks_)
    for (const render::LayerView& view : pane) scene_.forget(view.layer);
  marks_ = std::move(marks);
  ++patches_;
  if (patch.layer_count == 0) return;
  patch.frame = scene_.frame();
  if (!apply(patch)) marks_.clear();
}

bool Picture::has_picture(VariantLayer layer) const {
  const NodeState is = state(layer);
  return is != NodeState::inactive && is != NodeState::computing;
}

void Picture::follow_demand(const ShownPanes& shown) {
  leaving_.follow(shown, [this](VariantLayer layer) { return has_picture(layer); });
}

void Picture::forget_layers_without_need() {
  std::erase_if(loaded_, [this](VariantLayer layer) {
    if (state(layer) != NodeState::inactive || leaving_.needs(layer)) return false;
    scene_.forget(layer);
    return true;
  });
}

const LayerReport* Picture::report(VariantLayer layer) const {
  const auto found = std::ranges::find(report_.reports, layer, &LayerReport::layer);
  return found == report_.reports.end() ? nullptr : &*found;
}

NodeState Picture::state(VariantLayer layer) const {
  const LayerReport* found = report(layer);
  return found == nullptr ? NodeState::inactive : found->state;
}

void Picture::mark_selection(const Editor& editor) {
  const MarkedState now{editor.document().revision(), editor.selection().revision(), scene_.frame(), canvas_};
  if (now == marked_) return;
  marked_ = now;
  LayerStyle style;
  style.color = mark_color(canvas_);
  style.point_size_px = 9.0;
  style.line_width_px = 2.5;
  const Document& document = editor.document();
  mark_data_.clear();
  for (const SampleSlot slot : editor.selection().slots()) {
    const Vec2 p = document.position(slot);
    mark_data_.insert(mark_data_.end(), {p.x, p.y, 0.0});
  }
  for (const BallSlot slot : editor.selection().ball_slots()) {
    const Vec2 p = document.disk(slot).center;
    mark_data_.insert(mark_data_.end(), {p.x, p.y, 0.0});
  }
  set_mark(kSelectionMark, PrimitiveKind::point, style);
  mark_data_.clear();
  for (const BallSlot slot : editor.selection().ball_slots()) {
    const Disk& disk = document.disk(slot);
    if (disk.radius > 0.0) mark_data_.insert(mark_data_.end(), {disk.center.x, disk.center.y, disk.radius, 0.0});
  }
  set_mark(kSelectedCircleMark, PrimitiveKind::circle, style);
}

// The engine is behind while its picture shows an earlier state. One of its patches may move the samples back.
void Picture::draw_moved(const Editor& editor) {
  const Document& document = editor.document();
  const MarkedState now{document.revision(), editor.selection().revision(), scene_.frame(), {}};
  if (document.revision() == document_revision_ || is_outdated() || is_lost_) return;
  if (now == moved_at_ && moved_at_patch_ == patches_) return;
  // The scene has no instances of a hidden layer.
  if (scene_.instances(moved_.layer(), PrimitiveKind::point) != moved_.count()) return;
  const FramePatch* const own = moved_.catch_up(document, editor.selection().slots(), scene_.frame());
  if (own != nullptr) {
    is_lost_ = !apply(*own);
    ++patches_;
  }
  moved_at_ = now;
  moved_at_patch_ = patches_;
}

void Picture::set_mark(std::uint32_t slot, PrimitiveKind kind, const LayerStyle& style) {
  if (mark_data_.empty())
    scene_.clear_overlay(slot);
  else
    scene_.set_overlay(slot, {kind, mark_data_, style, false});
}

double Picture::spacing_in(const Pane& pane, const Editor& editor) {
  const std::size_t number = pane.version != nullptr ? pane.number : 0;
  if (spacings_.size() <= number) spacings_.resize(number + 1);
  return spacings_[number].of(pane.version != nullptr ? *pane.version : editor.document(), expected_);
}

std::uint32_t Picture::largest_painted_layer(const render::Camera& camera, const LayerStack& layers) const {
  std::uint32_t out = 0;
  for (const LayerIndex layer : layers.visible_layers())
    out = std::max(out, scene_.painted_disks(camera, layer, layers.style(layer)));
  return out;
}

ShownPanes::Layers Picture::as_drawn(ShownPanes::Layers layers, const std::optional<Rgb>& background,
                                     double spacing_px) const {
  for (auto& [layer, style] : layers) {
    const NodeState is = state(layer);
    const bool failed = is == NodeState::failed || is == NodeState::blocked;
    style = thinned(style, registry_.now().layers()[layer.layer], spacing_px);
    style = drawn_on(failed ? greyed(style) : style, background);
  }
  return layers;
}

// All panes have the size of the main one. Their cameras are those of windows in which they have its position.
render::Camera Picture::camera_of(const ShownState& shown, std::size_t pane) {
  if (shown.places.is_empty()) return shown.camera;
  const PanePlace& main = shown.places.places().front();
  const render::Camera& window = pane == 0 ? shown.camera : shown.cameras[pane - 1];
  return window.part(main.left, main.top, main.width, main.height);
}

void Picture::add_marks(std::vector<render::LayerView>& views, std::size_t pane) const {
  if (pane < marks_.size()) views.insert(views.end(), marks_[pane].begin(), marks_[pane].end());
}

void Picture::choose_views(const ShownState& shown, const Editor& editor, std::span<const Pane> panes) {
  views_.clear();
  views_.push_back(views_of(shown.layers, 1));
  add_texts(views_.back(), editor, nullptr, camera_of(shown, 0), shown.content_scale);
  if (!shown.places.is_empty()) add_marks(views_.back(), 0);
  for (std::size_t i = 0; i < shown.panes.size(); ++i) {
    views_.push_back(views_of(shown.panes[i], 1));
    add_texts(views_.back(), editor, panes[i].version, camera_of(shown, i + 1), shown.content_scale);
    add_marks(views_.back(), i + 1);
  }
}

render::PixelRect Picture::area_of(const ShownState& shown, std::size_t pane) {
  if (shown.places.is_empty()) return {0, 0, shown.camera.width(), shown.camera.height()};
  const PanePlace& place = shown.places.places()[pane];
  return {place.left, shown.camera.height() - place.top - place.height, place.width, place.height};
}

// Paints the pane of the current drawing; returns true once it is complete.
bool Picture::paint_pane(double ms) {
  Painting& now = *painting_;
  if (!now.drawing) {
    for (render::LayerView& view : views_[now.pane]) view.every = now.every;
    const render::PixelRect area = area_of(now.state, now.pane);
    now.drawing = scene_.begin(camera_of(now.state, now.pane), views_[now.pane],
                               {.content_scale = now.state.content_scale,
                                .target = now.target,
                                .left = area.left,
                                .bottom = area.bottom,
                                .overlays = now.pane == 0 || !now.state.versions[now.pane - 1],
                                .preview = now.preview});
  }
  return now.drawing->go_on(ms);
}

bool Picture::go_on_painting(double ms) {
  Painting& now = *painting_;
  const std::size_t places = now.state.places.places().size();
  const std::size_t panes = places == 0 ? 1 : std::min(views_.size(), places);
  const auto start = std::chrono::steady_clock::now();
  const auto spent = [start] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  };
  while (now.pane < panes && spent() < ms) {
    if (!paint_pane(ms - spent())) continue;
    now.is_coarse = now.is_coarse || scene_.is_coarse();
    now.drawing.reset();
    ++now.pane;
  }
  // The cost is known only after this.
  device_.finish();
  now.ms += spent();
  return now.pane == panes;
}

std::vector<render::LayerView> Picture::views_of(const ShownPanes::Layers& layers, std::uint32_t every) {
  std::vector<render::LayerView> views;
  for (const auto& [layer, style] : layers) views.push_back({layer, style, every});
  return views;
}

// Texts come from the document, and so are ahead of results that the engine still has to compute.
void Picture::add_texts(std::vector<render::LayerView>& views, const Editor& editor, const Document* version,
                        const render::Camera& camera, double content_scale) const {
  mes::add_texts(registry_.now().layers(), views,
                 version != nullptr ? TextSource{*version} : TextSource{editor.document(), &editor.index()},
                 {camera.visible(), camera.units_per_pixel() * content_scale}, letters_ ? &*letters_ : nullptr);
}

Expected<void> Picture::capture(render::FrameCapture& capture, const render::Camera& camera, const Pane& pane,
                                const Editor& editor, render::CaptureOptions options, bool is_beside) {
  stop_painting();
  const double units = camera.units_per_pixel() * options.content_scale;
  std::vector<render::LayerView> views =
      views_of(as_drawn(pane.layers, options.background, spacing_in(pane, editor) / units), 1);
  add_texts(views, editor, pane.version, camera, options.content_scale);
  if (is_beside) add_marks(views, pane.number);
  options.overlays = options.overlays && pane.version == nullptr;
  return capture.draw(scene_, camera, views, options);
}

std::vector<LegendEntry> Picture::legend(const ShownPanes::Layers& layers, LegendScope scope) const {
  return legend_of(registry_.now().layers(), scene_, views_of(layers, 1), scope);
}

void Picture::clear(const render::Camera& camera) {
  device_.clear({}, {0, 0, camera.width(), camera.height()}, render::clear_color(canvas_));
}

Picture::ShownState Picture::state_now(const render::Camera& camera, const LayerStack& layers, const Editor& editor,
                                       double content_scale, bool is_kept, const PanePlaces& places,
                                       std::span<const Pane> panes) {
  const ShownPanes::Layers main_layers = leaving_.draw(0, visible_layers(layers));
  const auto spacing_px = [&](const Pane& pane, const render::Camera& its) {
    return spacing_in(pane, editor) / (its.units_per_pixel() * content_scale);
  };
  ShownState now{camera,   content_scale,
                 patches_, background_revision_,
                 marked_,  as_drawn(main_layers, canvas_, spacing_px({main_layers}, camera)),
                 is_kept,  places,
                 {},       {},
                 {}};
  if (places.is_empty()) return now;
  for (const Pane& pane : panes) {
    now.cameras.push_back(pane.camera != nullptr ? *pane.camera : camera);
    now.panes.push_back(
        as_drawn(leaving_.draw(pane.number, pane.layers), canvas_, spacing_px(pane, now.cameras.back())));
    now.versions.push_back(pane.version != nullptr ? std::optional(pane.version->revision()) : std::nullopt);
  }
  return now;
}

void Picture::draw(const render::Camera& camera, const LayerStack& layers, const Editor& editor, double content_scale,
                   bool is_kept, const PanePlaces& places, std::span<const Pane> panes) {
  // Milliseconds for painting in a frame. A longer frame while nothing moves delays only the next input, and completes
  // the picture earlier.
  constexpr double kMovingMs = 40.0;
  constexpr double kRestingMs = 100.0;
  if (painting_ &&
      (is_kept || !is_worth_completing(state_now(camera, layers, editor, content_scale, is_kept, places, panes))))
    stop_painting();
  if (!painting_) {
    draw_moved(editor);
    mark_selection(editor);
  }
  ShownState now = state_now(camera, layers, editor, content_scale, is_kept, places, panes);
  const bool rests = camera == last_camera_ && editor.document().revision() == last_document_;
  last_camera_ = camera;
  last_document_ = editor.document().revision();
  if (!painting_ && (now != shown_ || is_refining())) begin_painting(now, layers, editor, panes);
  if (painting_ && go_on_painting(is_kept ? std::numeric_limits<double>::infinity() : rests ? kRestingMs : kMovingMs))
    complete_painting();
  show(now);
  follow_ink(rests);
}

// The window shows the layers and nothing else yet.
void Picture::follow_ink(bool rests) {
  while (const auto raw = ink_capture_.poll())
    if (!raw->rgba.empty()) ink_ = InkMap(*raw, ink_camera_, ink_canvas_);
  if (!rests || is_refining() || !awaits_ink() || ink_capture_.pending() != 0) return;
  ink_of_ = pictures_;
  ink_camera_ = shown_.camera;
  ink_canvas_ = canvas_;
  // The last one stays if there is no memory for it.
  static_cast<void>(ink_capture_.take({}, {0, 0, ink_camera_.width(), ink_camera_.height()}));
}

// A picture that takes long would only delay the one that is wanted now; others show a moving view on its way.
bool Picture::is_worth_completing(const ShownState& now) const {
  const ShownState& then = painting_->state;
  return now == then ||
         (painting_->ms < kLongMs && now.places == then.places && now.panes.size() == then.panes.size() &&
          now.camera.width() == then.camera.width() && now.camera.height() == then.camera.height());
}

void Picture::begin_painting(ShownState now, const LayerStack& layers, const Editor& editor,
                             std::span<const Pane> panes) {
  const render::Camera& camera = now.camera;
  const bool is_same = now == shown_;
  const bool has_moved =
      camera != shown_.camera || now.cameras != shown_.cameras || now.content_scale != shown_.content_scale;
  const bool paints_more = is_same && detail_.is_refining();
  if (!is_same) choose_views(now, editor, panes);
  Painting painting{.state = {},
                    .target = kept_.begin(camera.width(), camera.height()),
                    .every = paints_more ? detail_.begin_refinement()
                             : is_same   ? every_
                                         : detail_.begin_changed(largest_painted_layer(camera, layers)),
                    .preview = now.is_kept ? render::Preview::none
                               : has_moved ? render::Preview::coarse
                                           : render::Preview::fine,
                    .counts = paints_more || !is_same,
                    .drawing = {}};
  device_.clear(painting.target, {0, 0, camera.width(), camera.height()}, render::clear_color(canvas_));
  painting.state = std::move(now);
  painting_ = std::move(painting);
}

void Picture::complete_painting() {
  if (painting_->counts) detail_.painted(painting_->ms);
  is_coarse_ = painting_->is_coarse;
  every_ = painting_->every;
  shown_ = std::move(painting_->state);
  painting_.reset();
  ++pictures_;
  kept_.keep();
  is_kept_foreign_ = false;
}

void Picture::stop_painting() {
  if (!painting_) return;
  // A long painting counts, so that the next picture is painted in less detail.
  if (painting_->counts && painting_->ms >= kLongMs) detail_.painted(painting_->ms);
  painting_.reset();
  shown_.patches = kNoPatches;  // the views are those of the dropped picture
}

void Picture::show(const ShownState& now) {
  const int width = now.camera.width();
  const int height = now.camera.height();
  const bool can_move = !is_kept_foreign_ && kept_.has(width, height) && now.places == shown_.places &&
                        now.cameras.size() == shown_.cameras.size();
  if (!can_move) return kept_.show_begun();
  if (now.camera == shown_.camera && now.cameras == shown_.cameras) return kept_.show();
  const std::size_t panes = now.places.is_empty() ? 1 : std::min(now.places.places().size(), now.cameras.size() + 1);
  device_.clear({}, {0, 0, width, height}, render::clear_color(canvas_));
  for (std::size_t i = 0; i < panes; ++i)
    kept_.show_moved(area_of(now, i), camera_of(shown_, i), camera_of(now, i), render::clear_color(canvas_));
}

}  // namespace mes
