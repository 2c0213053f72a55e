// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/tools/annotation_editor.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/editing/tools/vertex_near.h"

namespace mes {
namespace {

constexpr const char* kNew = "Annotate";
constexpr const char* kChange = "Change annotation";

bool is_blank(const Annotation& annotation) {
  return !shows_without_words(annotation.kind) && annotation.text.find_first_not_of(" \t\r\n") == std::string::npos;
}

}  // namespace

Anchor AnnotationEditor::anchor_at(Vec2 p, double reach, bool with_vertices) const {
  const Document& document = editor_.document();
  if (const SampleSlot sample = editor_.index().nearest(p, reach); sample != kNoSlot)
    return {document.position(sample), {document.id(sample).value - document.first_id().value}};
  if (BallSlot ball = editor_.centers().nearest(p, reach); ball != kNoSlot) {
    const Vec2 center = document.disk(ball).center;
    // Several balls may share a centre: take the newest, which lies on top.
    for (const BallSlot other : editor_.centers().in_box({center, center}))
      if (document.ball_id(ball) < document.ball_id(other)) ball = other;
    return {.at = center, .balls = {document.ball_id(ball).value - document.first_ball_id().value}};
  }
  if (with_vertices)
    if (auto vertex = vertex_at(p, reach)) return std::move(*vertex);
  return {.at = p};
}

// All samples around a vertex are at one distance from it, and none is nearer. Circles far larger than the reach are
// not searched; where samples are very dense, the reach is smaller.
std::optional<Anchor> AnnotationEditor::vertex_at(Vec2 p, double reach) const {
  constexpr double kFarthest = 128.0;
  constexpr std::size_t kMostAround = 400;
  constexpr int kMostHalvings = 4;
  const Document& document = editor_.document();
  if (document.sample_count() > kMostSamplesForVertices) return std::nullopt;
  SampleSlot nearest;
  for (double radius = 2.0 * reach; nearest == kNoSlot && radius <= kFarthest * reach; radius *= 2.0)
    nearest = editor_.index().nearest(p, radius);
  if (nearest == kNoSlot) return std::nullopt;
  for (int halvings = 0; halvings <= kMostHalvings; ++halvings, reach *= 0.5) {
    const double ring = distance(p, document.position(nearest)) + 2.0 * reach;
    std::vector<SampleSlot> around = editor_.index().in_box({p - Vec2{ring, ring}, p + Vec2{ring, ring}});
    std::erase_if(around, [&](SampleSlot slot) { return distance(p, document.position(slot)) > ring; });
    if (around.size() > kMostAround) continue;
    std::ranges::sort(around);
    std::vector<Vec2> sites;
    for (const SampleSlot slot : around) sites.push_back(document.position(slot));
    const auto vertex = vertex_near(sites, p, reach);
    if (!vertex) return std::nullopt;
    Anchor out{.at = vertex->at};
    for (const std::size_t corner : vertex->corners)
      out.samples.push_back(document.id(around[corner]).value - document.first_id().value);
    return out;
  }
  return std::nullopt;
}

Expected<void> AnnotationEditor::put(Annotations annotations, const std::string& name, bool continues) {
  const auto done = editor_.annotate(std::move(annotations), name, continues);
  if (!done) return done;
  seen_ = editor_.document().annotations();
  revision_ = editor_.document().revision();
  return done;
}

Expected<void> AnnotationEditor::begin(Annotation draft) {
  close();
  ++choice_number_;
  is_new_ = true;
  draft_ = std::move(draft);
  if (!shows_without_words(draft_->kind)) return {};
  const auto done = change(*draft_);
  if (!done) draft_.reset();
  return done;
}

void AnnotationEditor::select(std::size_t i) {
  close();
  if (i >= editor_.document().annotations()->size()) return;
  ++choice_number_;
  selected_ = i;
  seen_ = editor_.document().annotations();
}

const Annotation* AnnotationEditor::current() const {
  if (draft_) return &*draft_;
  if (!selected_ || editor_.document().annotations() != seen_) return nullptr;
  return &(*seen_)[*selected_];
}

Expected<void> AnnotationEditor::change(Annotation changed) {
  follow();
  if (draft_) {
    draft_ = std::move(changed);
    if (is_blank(*draft_)) return {};
    Annotations all = *editor_.document().annotations();
    all.push_back(*draft_);
    const std::size_t place = all.size() - 1;
    auto done = put(std::move(all), kNew, false);
    if (!done) return done;
    draft_.reset();
    selected_ = place;
    return {};
  }
  if (!selected_) return {};
  Annotations all = *seen_;
  if (all[*selected_] == changed) return {};
  all[*selected_] = std::move(changed);
  return put(std::move(all), is_new_ ? kNew : kChange, is_new_ || std::exchange(is_changed_, true));
}

Expected<void> AnnotationEditor::move(std::size_t i, Annotation moved) {
  Annotations all = *editor_.document().annotations();
  if (i >= all.size()) return {};
  const bool is_chosen = current() != nullptr && selected_;
  all[i] = std::move(moved);
  const auto done = editor_.annotate(std::move(all), "Move annotation");
  if (is_chosen) seen_ = editor_.document().annotations();
  // Later changes are a step of their own.
  is_new_ = is_changed_ = false;
  return done;
}

Expected<void> AnnotationEditor::erase() {
  follow();
  draft_.reset();
  if (!selected_) return {};
  Annotations all = *seen_;
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(*selected_));
  auto done = put(std::move(all), "Delete annotation", false);
  if (done) selected_.reset();
  return done;
}

bool AnnotationEditor::close() {
  follow();
  const bool had = current() != nullptr;
  if (selected_ && is_blank((*seen_)[*selected_])) {
    // Leaves no trace if all of it is the last step.
    if (is_new_ && editor_.document().revision() == revision_)
      editor_.undo_edit();
    else
      (void)erase();
  }
  forget();
  return had;
}

void AnnotationEditor::forget() {
  draft_.reset();
  selected_.reset();
  is_new_ = is_changed_ = false;
}

void AnnotationEditor::follow() {
  if (!selected_ || editor_.document().annotations() == seen_) return;
  // An annotation on a deleted sample is still the same annotation.
  const Annotations& now = *editor_.document().annotations();
  if (now.size() == seen_->size() && same_but_for_places(now, *seen_)) {
    seen_ = editor_.document().annotations();
    return;
  }
  selected_.reset();
  is_new_ = is_changed_ = false;
}

}  // namespace mes
