// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/prepared_document.h"

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

}  // namespace

PreparedDocument::PreparedDocument(DocumentReplay replay, std::shared_ptr<const SampleData> data, TimelineLog entries,
                                   Lesson lesson, JobControl* job)
    : document_((replay.finish(), std::move(replay).take_document())),
      history_(std::move(replay).take_history()),
      data_(std::move(data)),
      entries_(std::move(entries)),
      lesson_(std::move(lesson)),
      change_(change_to(document_)),
      index_(document_, job),
      centers_(document_, job) {}

}  // namespace mes
