// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/source_selection.h"

#include <array>
#include <set>
#include <vector>

namespace mes {
namespace {

// The points of a shape that may be samples.
std::vector<Vec2> corners_of_shape(const ProvenanceShape& shape) {
  const auto& v = shape.values;
  switch (shape.kind) {
    case PrimitiveKind::point: return {{v[0], v[1]}};
    case PrimitiveKind::segment: return {{v[0], v[1]}, {v[2], v[3]}};
    case PrimitiveKind::triangle: return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
    case PrimitiveKind::disk:
    case PrimitiveKind::circle:
    case PrimitiveKind::arc:
    case PrimitiveKind::parabola:
    case PrimitiveKind::ray:
    case PrimitiveKind::line: return {};
  }
  return {};
}

bool is_round(PrimitiveKind kind) {
  return kind == PrimitiveKind::disk || kind == PrimitiveKind::circle;
}

}  // namespace

std::size_t select_sources(Editor& editor, const Provenance& element) {
  const Document& document = editor.document();
  std::vector<SampleSlot> samples;
  std::set<std::array<double, 3>> disks;
  for (const ProvenanceLine& line : element.lines) {
    if (line.role == ProvenanceRole::product) continue;
    for (const ProvenanceShape& shape : line.shapes) {
      for (const Vec2 corner : corners_of_shape(shape))
        for (const SampleSlot slot : editor.index().in_box({corner, corner})) samples.push_back(slot);
      if (is_round(shape.kind)) disks.insert({shape.values[0], shape.values[1], shape.values[2]});
    }
  }
  std::vector<BallSlot> balls;
  if (!disks.empty())
    for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count())) {
      if (!document.is_ball_alive(slot)) continue;
      const Disk& disk = document.disk(slot);
      if (disks.contains({disk.center.x, disk.center.y, disk.radius})) balls.push_back(slot);
    }
  if (samples.empty() && balls.empty()) return 0;
  Selection& selection = editor.selection();
  selection.clear();
  for (const SampleSlot slot : samples) selection.add(slot);
  for (const BallSlot slot : balls) selection.add_ball(slot);
  return selection.size();
}

void ValueSelector::ask(Engine& engine, LayerIndex layer, double low, double high) {
  revision_ = editor_.document().revision();
  ProvenanceQuestion question;
  question.ticket = ++ticket_;
  question.layers = {layer};
  question.wish = ProvenanceWish::sources_of_values;
  question.low = low;
  question.high = high;
  engine.ask(std::move(question));
}

std::optional<std::string> ValueSelector::take(const Provenance& answer) {
  if (answer.ticket < kFirstTicket || answer.ticket >= 2 * kFirstTicket) return std::nullopt;
  if (answer.ticket != ticket_ || editor_.document().revision() != revision_) return std::string();
  if (select_sources(editor_, answer) == 0)
    return answer.lines.empty() ? std::string("No element of the layer has such a value")
                                : "Nothing is selected: " + answer.lines.front().text;
  const Selection& selection = editor_.selection();
  return "Selected " + counted(selection.sample_count(), selection.ball_count()) + ": " + answer.lines.front().text;
}

}  // namespace mes
