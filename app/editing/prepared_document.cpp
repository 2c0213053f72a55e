// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/prepared_document.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace mes {
namespace {

std::shared_ptr<DocumentDelta> change_to(const Document& document) {
  auto out = std::make_shared<DocumentDelta>();
  out->to_revision = document.revision();
  out->before = out->after = document.snapshot();
  out->balls_before = out->balls_after = document.ball_snapshot();
  out->curve_after = document.curve_order();
  out->annotations_after = document.annotations();
  out->source_after = document.source();
  return out;
}

// When ids run short, takes half of the remaining ones: an element that finds none is refused, as in any insertion.
std::uint32_t ids_left(std::uint32_t next, std::uint32_t wanted) {
  return std::min(wanted, (std::numeric_limits<std::uint32_t>::max() - next) / 2);
}

}  // namespace

// An empty document that replaces an empty one, with later ids.
Document successor_of(const Document& before, const NumbersLeft& left) {
  Document out = before.successor();
  auto samples = std::make_shared<SampleSnapshot>();
  samples->first = SampleId{before.next_id().value + ids_left(before.next_id().value, left.ids)};
  auto balls = std::make_shared<BallSnapshot>();
  balls->first = BallId{before.next_ball_id().value + ids_left(before.next_ball_id().value, left.ids)};
  DocumentDelta later;
  later.from_revision = out.revision();
  later.to_revision = out.revision() + left.revisions;
  later.before = out.snapshot();
  later.after = std::move(samples);
  later.balls_before = out.ball_snapshot();
  later.balls_after = std::move(balls);
  later.curve_before = later.curve_after = out.curve_order();
  later.annotations_before = later.annotations_after = out.annotations();
  out.apply(later);
  return out;
}

PreparedDocument::PreparedDocument(DocumentReplay replay, std::shared_ptr<const SampleData> data, TimelineLog entries,
                                   Lesson lesson, JobControl* job)
    : document_((replay.finish(), std::move(replay).take_document())),
      history_(std::move(replay).take_history()),
      data_(std::move(data)),
      entries_(std::move(entries)),
      lesson_(std::move(lesson)),
      change_(change_to(document_)),
      index_(document_, {.job = job, .total = document_.slot_count() + document_.ball_slot_count()}),
      centers_(document_, {.job = job,
                           .before = document_.slot_count(),
                           .total = document_.slot_count() + document_.ball_slot_count()}) {}

}  // namespace mes
