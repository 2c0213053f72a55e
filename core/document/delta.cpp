// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/delta.h"

#include "core/base/assert.h"

#include <utility>

namespace mes {

DocumentDelta DocumentDelta::inverted() const {
  DocumentDelta out = *this;
  std::swap(out.from_revision, out.to_revision);
  std::swap(out.before, out.after);
  std::swap(out.balls_before, out.balls_after);
  std::swap(out.curve_before, out.curve_after);
  std::swap(out.annotations_before, out.annotations_after);
  std::swap(out.source_before, out.source_after);
  out.edits.assign(edits.rbegin(), edits.rend());
  for (SampleEdit& edit : out.edits) {
    std::swap(edit.from, edit.to);
    if (edit.kind == SampleEdit::Kind::insert) {
      edit.kind = SampleEdit::Kind::remove;
    } else if (edit.kind == SampleEdit::Kind::remove) {
      edit.kind = SampleEdit::Kind::insert;
    }
  }
  out.ball_edits.assign(ball_edits.rbegin(), ball_edits.rend());
  for (BallEdit& edit : out.ball_edits) {
    std::swap(edit.from, edit.to);
    if (edit.kind == BallEdit::Kind::insert) {
      edit.kind = BallEdit::Kind::remove;
    } else if (edit.kind == BallEdit::Kind::remove) {
      edit.kind = BallEdit::Kind::insert;
    }
  }
  return out;
}

DocumentDelta one_after_the_other(std::span<const DocumentDelta> deltas) {
  DocumentDelta out = deltas.front();
  for (const DocumentDelta& delta : deltas.subspan(1)) {
    MES_ASSERT(!delta.replaces_all() && delta.from_revision == out.to_revision);
    out.edits.insert(out.edits.end(), delta.edits.begin(), delta.edits.end());
    out.ball_edits.insert(out.ball_edits.end(), delta.ball_edits.begin(), delta.ball_edits.end());
    out.to_revision = delta.to_revision;
    out.curve_after = delta.curve_after;
    out.annotations_after = delta.annotations_after;
    out.source_after = delta.source_after;
  }
  return out;
}

}  // namespace mes
